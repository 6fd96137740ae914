#include "mdr/springs/spring_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "mdr/support/checks.h"
#include "mdr/support/wide_registers.h"

namespace fretval::mdr {

namespace {

// 1/(1-e^-z) - 1/z: 1/2 for slow relaxation (trapezoidal rule), 1 for fast (implicit Euler), exact for one exponential.
double fitted_theta(double z) {
  return z < 1e-3 ? 0.5 + z / 12 : -1 / std::expm1(-z) - 1 / z;
}

// Share of the step during which a spring is in contact; of a spring that touches in the step by the height of the
// indenter above its free tip at the start and its depth below the free tip at the end, m.
double share_in_contact(double load_before, double above, double below) {
  return load_before > 0 || below <= 0 ? 1 : below / (below + above);
}

}  // namespace

double branch_gain(const PronyBody& body, std::size_t i, double dt) {
  const double z = dt / body.branch_times[i];
  return body.branch_moduli[i] / body.relaxed_modulus * -std::expm1(-z) / z;
}

SpringState relaxed_state(const SpringBed& bed, const PronyBody& body, double indentation) {
  validate(body);
  require_finite("indentation", indentation);
  const Eigen::Index n = bed.depth.size(), n_branches = static_cast<Eigen::Index>(body.branch_moduli.size());
  const Eigen::ArrayXd contact = (indentation - bed.depth).max(0);
  const Eigen::ArrayXd none = Eigen::ArrayXd::Zero(n);
  const Eigen::ArrayXXd memory = Eigen::ArrayXXd::Zero(n, n_branches);
  const IndenterState rest{indentation, 0, 0, 0};
  return {rest, contact, none, contact, none, none, memory, memory, rest};
}

SpringStep::SpringStep(const PronyBody& body, double mu, double dt) : limit_(1.5 * mu), dt_(dt), gain_sum_(0) {
  validate(body);
  require_positive("coefficient of friction", mu);
  require_positive("time step", dt);
  for (std::size_t i = 0; i < body.branch_moduli.size(); ++i) {
    decay_.push_back(std::exp(-dt / body.branch_times[i]));
    gain_.push_back(branch_gain(body, i, dt));
    gain_sum_ += gain_.back();
  }
  viscosity_ = body.viscosity / body.relaxed_modulus;
  const double theta = viscosity_ > 0 ? fitted_theta(dt * (1 + gain_sum_) / viscosity_) : 1;
  tip_under_ = {viscosity_ / dt, theta, gain_sum_, viscosity_ / dt + theta * (1 + gain_sum_)};
}

Eigen::ArrayXd SpringStep::left_of(const Eigen::ArrayXXd& memory) const {
  return (memory.matrix() * Eigen::Map<const Eigen::VectorXd>(decay_.data(), memory.cols())).array();
}

Eigen::ArrayXd SpringStep::free_tips(const Eigen::ArrayXd& position, const Eigen::ArrayXXd& memory) const {
  return tip_under_.operator()<Eigen::ArrayXd>(0, position, left_of(memory), position + memory.rowwise().sum());
}

void SpringStep::advance(SpringState& state, const SpringBed& bed, const IndenterState& to) const {
  if (viscosity_ > 0)
    advance_in_wide_registers<true>(state, bed, to);
  else
    advance_in_wide_registers<false>(state, bed, to);
  state.indenter_before = std::exchange(state.indenter, to);
}

template <bool has_dashpot>
void SpringStep::advance_in_wide_registers(SpringState& state, const SpringBed& bed, const IndenterState& to) const {
  in_wide_registers([&] {
    switch (decay_.size()) {
      case 0:
        return advance_springs<has_dashpot, 0>(state, bed, to);
      case 1:
        return advance_springs<has_dashpot, 1>(state, bed, to);
      case 2:
        return advance_springs<has_dashpot, 2>(state, bed, to);
      case 3:
        return advance_springs<has_dashpot, 3>(state, bed, to);
      default:
        return advance_springs<has_dashpot, -1>(state, bed, to);
    }
  });
}

// One pass over the springs without a branch in it, so that the compiler vectorises it; n_branches = -1: any number.
template <bool has_dashpot, int n_branches>
void SpringStep::advance_springs(SpringState& state, const SpringBed& bed, const IndenterState& to) const {
  constexpr auto n_fixed = static_cast<std::size_t>(std::max(n_branches, 1));
  const std::size_t n_memory = n_branches < 0 ? decay_.size() : n_branches;
  const Eigen::Index n = bed.depth.size();
  const double gain = gain_sum_, compliance = 1 / (1 + gain_sum_), limit = limit_;
  const TipRule tip_under = tip_under_;
  const double d = to.indentation, d_before = state.indenter.indentation,
               shift = to.tangential - state.indenter.tangential, drag = viscosity_ * to.indentation_rate,
               tangential_drag = viscosity_ * to.tangential_rate;
  const double* g = bed.depth.data();
  double *u = state.normal_depth.data(), *v = state.tangential_shift.data();
  double *p = state.normal_load.data(), *t = state.tangential_load.data();
  double *h = state.normal_memory.data(), *k = state.tangential_memory.data(), *slip = state.slip.data();
  std::array<double, n_fixed> decay{}, branch_gain{};
  if constexpr (n_branches > 0) {
    std::copy_n(decay_.begin(), n_fixed, decay.begin());
    std::copy_n(gain_.begin(), n_fixed, branch_gain.begin());
  }
  const double* a = n_branches < 0 ? decay_.data() : decay.data();
  const double* b = n_branches < 0 ? gain_.data() : branch_gain.data();
#pragma GCC ivdep
  for (Eigen::Index j = 0; j < n; ++j) {
    // left: what is left of the branch forces at the end of the step; now: the forces of relaxed spring and branches at
    // its start.
    double left = 0, left_tangential = 0, now = u[j], now_tangential = v[j];
    for (std::size_t i = 0; i < n_memory; ++i) {
      const Eigen::Index at = static_cast<Eigen::Index>(i) * n + j;
      left += a[i] * h[at];
      left_tangential += a[i] * k[at];
      now += h[at];
      now_tangential += k[at];
    }
    const double touching = d - g[j], above = u[j] - (d_before - g[j]);
    double depth, load, traction, tip, slipped;
    if constexpr (has_dashpot) {
      const double free = tip_under(0.0, u[j], left, now);
      const double pressed = touching + left + gain * (touching - u[j]) + drag;
      const double in_contact = p[j] > 0 ? pressed : touching - free;  // where positive
      load = in_contact > 0 ? std::max(0.0, pressed) : 0;
      depth = in_contact > 0 ? touching : std::max(free, touching);
      // Position of the tip if it recovers until the instant of touch and sticks from then on.
      const double held = share_in_contact(p[j], above, touching - free),
                   moved = held * shift + (1 - held) * (tip_under(0.0, v[j], left_tangential, now_tangential) - v[j]);
      const double stuck = v[j] + left_tangential + (1 + gain) * moved + tangential_drag;
      const double most = limit * load;
      traction = std::min(std::max(stuck, -most), most);
      const double mean_load = in_contact > 0 ? tip_under.theta * traction + (1 - tip_under.theta) * t[j] : 0;
      const double slipping = tip_under(mean_load, v[j], left_tangential, now_tangential);
      tip = in_contact > 0 && traction == stuck ? v[j] + moved : slipping;
      slipped = in_contact > 0 || p[j] > 0 ? v[j] + moved - tip : 0;
    } else {
      const double free = (gain * u[j] - left) * compliance;
      depth = std::max(free, touching);
      load = (1 + gain) * (depth - free);
      const double held = share_in_contact(p[j], above, touching - free);
      const double stuck = held * (v[j] + left_tangential + (1 + gain) * shift);
      const double most = limit * load;
      traction = std::min(std::max(stuck, -most), most);
      tip = (traction - left_tangential + gain * v[j]) * compliance;
      slipped = p[j] > 0 || load > 0 ? (stuck - traction) * compliance : 0;
    }
    slip[j] = slipped;
    const double move = depth - u[j], tangential_move = tip - v[j];
    for (std::size_t i = 0; i < n_memory; ++i) {
      const Eigen::Index at = static_cast<Eigen::Index>(i) * n + j;
      h[at] = a[i] * h[at] + b[i] * move;
      k[at] = a[i] * k[at] + b[i] * tangential_move;
    }
    u[j] = depth;
    v[j] = tip;
    p[j] = load;
    t[j] = traction;
  }
}

IndenterState SpringStep::arrived(const SpringState& state, double indentation, double tangential) const {
  const auto rate = [this](double now, double last, double before) {
    return (3 * now - 4 * last + before) / (2 * dt_);
  };
  const auto &last = state.indenter, &before = state.indenter_before;
  return {indentation, rate(indentation, last.indentation, before.indentation), tangential,
          rate(tangential, last.tangential, before.tangential)};
}

NormalLines SpringStep::normal_lines(const SpringState& state, const SpringBed& bed) const {
  const double stiffness = 1 + gain_sum_, rate = 1.5 * viscosity_ / dt_, slope = stiffness + rate;
  const double coasting = arrived(state, 0, 0).indentation_rate;
  const Eigen::ArrayXd zero =
      (stiffness * bed.depth + gain_sum_ * state.normal_depth - left_of(state.normal_memory) - viscosity_ * coasting) /
      slope;
  const Eigen::ArrayXd touch = bed.depth + free_tips(state.normal_depth, state.normal_memory);
  return {zero, (state.normal_load > 0).select(zero, zero.max(touch)), slope};
}

TangentialLines SpringStep::tangential_lines(const SpringState& state, const SpringBed& bed, double indentation) const {
  const double stiffness = 1 + gain_sum_, rate = 1.5 * viscosity_ / dt_;
  const NormalLines normal = normal_lines(state, bed);
  const Eigen::ArrayXd load = (indentation > normal.touch).select(normal.slope * (indentation - normal.zero), 0);
  const Eigen::ArrayXd below = indentation - bed.depth - free_tips(state.normal_depth, state.normal_memory);
  Eigen::ArrayXd held(load.size());
  for (Eigen::Index j = 0; j < held.size(); ++j)
    held[j] = share_in_contact(state.normal_load[j],
                               state.normal_depth[j] - (state.indenter.indentation - bed.depth[j]), below[j]);
  const double coasting = arrived(state, 0, state.indenter.tangential).tangential_rate;
  const Eigen::ArrayXd& v = state.tangential_shift;
  return {v + left_of(state.tangential_memory) + stiffness * (1 - held) * (free_tips(v, state.tangential_memory) - v) +
              viscosity_ * coasting,
          stiffness * held + rate, limit_ * load};
}

}  // namespace fretval::mdr
