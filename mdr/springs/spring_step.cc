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

// Of a step, how much of it a spring spends in contact that touches in it: from the height of the indenter above its
// free tip at the start, and the depth of the indenter below it at the end.
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
  theta_ = viscosity_ > 0 ? fitted_theta(dt * (1 + gain_sum_) / viscosity_) : 1;
  weight_ = viscosity_ / dt + theta_ * (1 + gain_sum_);
}

// Position of a tip at the end of a step whose load, averaged with theta, is given.
template <class T>
T SpringStep::tip_under(double load, const T& position, const T& left, const T& force_now) const {
  return (load + viscosity_ / dt_ * position - theta_ * (left - gain_sum_ * position) - (1 - theta_) * force_now) /
         weight_;
}

Eigen::ArrayXd SpringStep::left_of(const Eigen::ArrayXXd& memory) const {
  return (memory.matrix() * Eigen::Map<const Eigen::VectorXd>(decay_.data(), memory.cols())).array();
}

Eigen::ArrayXd SpringStep::free_tips(const Eigen::ArrayXd& position, const Eigen::ArrayXXd& memory) const {
  return tip_under<Eigen::ArrayXd>(0, position, left_of(memory), position + memory.rowwise().sum());
}

void SpringStep::advance(SpringState& state, const SpringBed& bed, const IndenterState& to) const {
  if (viscosity_ > 0) return advance_with_dashpot(state, bed, to);
  in_wide_registers([&] {
    switch (decay_.size()) {
      case 0:
        return advance_elastomer<0>(state, bed, to);
      case 1:
        return advance_elastomer<1>(state, bed, to);
      case 2:
        return advance_elastomer<2>(state, bed, to);
      case 3:
        return advance_elastomer<3>(state, bed, to);
      default:
        return advance_elastomer<-1>(state, bed, to);
    }
  });
}

// One pass over the springs without a branch in it, so that the compiler vectorises it; n_branches = -1: any number.
template <int n_branches>
void SpringStep::advance_elastomer(SpringState& state, const SpringBed& bed, const IndenterState& to) const {
  constexpr auto n_fixed = static_cast<std::size_t>(std::max(n_branches, 1));
  const std::size_t n_memory = n_branches < 0 ? decay_.size() : n_branches;
  const Eigen::Index n = bed.depth.size();
  const double gain = gain_sum_, compliance = 1 / (1 + gain_sum_), limit = limit_;
  const double d = to.indentation, d_before = state.indenter.indentation,
               shift = to.tangential - state.indenter.tangential;
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
    double left = 0, left_tangential = 0;  // of the memory, at the end of the step
    for (std::size_t i = 0; i < n_memory; ++i) {
      const Eigen::Index at = static_cast<Eigen::Index>(i) * n + j;
      left += a[i] * h[at];
      left_tangential += a[i] * k[at];
    }
    const double free = (gain * u[j] - left) * compliance;
    const double depth = std::max(free, d - g[j]);
    const double load = (1 + gain) * (depth - free);
    const double held = share_in_contact(p[j], u[j] - (d_before - g[j]), d - g[j] - free);
    const double trial = held * (v[j] + left_tangential + (1 + gain) * shift);
    const double most = limit * load;
    const double traction = std::min(std::max(trial, -most), most);
    const double tip = (traction - left_tangential + gain * v[j]) * compliance;
    slip[j] = p[j] > 0 || load > 0 ? (trial - traction) * compliance : 0;
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
  state.indenter_before = std::exchange(state.indenter, to);
}

void SpringStep::advance_with_dashpot(SpringState& state, const SpringBed& bed, const IndenterState& to) const {
  const double shift = to.tangential - state.indenter.tangential;
  const auto n_memory = static_cast<Eigen::Index>(decay_.size());
  for (Eigen::Index j = 0; j < bed.depth.size(); ++j) {
    double left = 0, left_tangential = 0, now = state.normal_depth[j], now_tangential = state.tangential_shift[j];
    for (Eigen::Index i = 0; i < n_memory; ++i) {
      const double a = decay_[static_cast<std::size_t>(i)];
      left += a * state.normal_memory(j, i);
      left_tangential += a * state.tangential_memory(j, i);
      now += state.normal_memory(j, i);
      now_tangential += state.tangential_memory(j, i);
    }
    const double u = state.normal_depth[j], v = state.tangential_shift[j], touching = to.indentation - bed.depth[j];
    const double free = tip_under(0.0, u, left, now);
    const double pressed = touching + left + gain_sum_ * (touching - u) + viscosity_ * to.indentation_rate;
    const bool contact = state.normal_load[j] > 0 ? pressed > 0 : touching > free;
    const double load = contact ? std::max(0.0, pressed) : 0;
    const double depth = contact ? touching : std::max(free, touching);
    // Where the tip goes if it sticks from the instant of touch on, until when it recovers.
    const double held = share_in_contact(state.normal_load[j], u - (state.indenter.indentation - bed.depth[j]),
                                         touching - free),
                 moved = held * shift + (1 - held) * (tip_under(0.0, v, left_tangential, now_tangential) - v);
    const double stuck = v + left_tangential + (1 + gain_sum_) * moved + viscosity_ * to.tangential_rate;
    const double most = limit_ * load;
    const double traction = std::min(std::max(stuck, -most), most);
    const double mean_load = contact ? theta_ * traction + (1 - theta_) * state.tangential_load[j] : 0;
    const double tip =
        contact && traction == stuck ? v + moved : tip_under(mean_load, v, left_tangential, now_tangential);
    state.slip[j] = contact || state.normal_load[j] > 0 ? v + moved - tip : 0;
    for (Eigen::Index i = 0; i < n_memory; ++i) {
      const double a = decay_[static_cast<std::size_t>(i)], b = gain_[static_cast<std::size_t>(i)];
      state.normal_memory(j, i) = a * state.normal_memory(j, i) + b * (depth - u);
      state.tangential_memory(j, i) = a * state.tangential_memory(j, i) + b * (tip - v);
    }
    state.normal_depth[j] = depth;
    state.tangential_shift[j] = tip;
    state.normal_load[j] = load;
    state.tangential_load[j] = traction;
  }
  state.indenter_before = std::exchange(state.indenter, to);
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
