#include "mdr/springs/spring_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <type_traits>
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

/// What passes for prescribed forces need of a step; see SpringStep::lines_of.
template <int n_branches, class TipRule>
struct SpringLines {
  std::array<double, static_cast<std::size_t>(std::max(n_branches, 1))> few_decays;
  const double* decay;  // of more than three branches
  Eigen::Index n_memory, n_springs;
  double stiffness, gain, viscosity, rate;  // rate: 1.5 eta/(G0 dt)
  TipRule tip_under;

  /// Force of the branches of a spring: what is left of it at the end of the step, and what it is at its start.
  struct BranchForce {
    double left, now;
  };
  [[nodiscard]] BranchForce branch_force(const double* memory, Eigen::Index spring) const {
    BranchForce force{0, 0};
    for (Eigen::Index i = 0; i < (n_branches < 0 ? n_memory : n_branches); ++i) {
      const double of_branch = memory[i * n_springs + spring];
      force.left += (n_branches < 0 ? decay[i] : few_decays[static_cast<std::size_t>(i)]) * of_branch;
      force.now += of_branch;
    }
    return force;
  }

  /// Load of a spring as a function of the indentation (NormalLines), and where its tip is if nothing holds it. depth
  /// and load: of the spring at the start of the step; coasting: rate of an indenter that comes to 0.
  struct NormalLine {
    double zero, touch, free;
  };
  [[nodiscard]] NormalLine normal_line(double height, double depth, double load, const BranchForce& force,
                                       double coasting) const {
    const double zero = (stiffness * height + gain * depth - force.left - viscosity * coasting) / (stiffness + rate),
                 free = tip_under(0.0, depth, force.left, depth + force.now);
    return {zero, load > 0 ? zero : std::max(zero, height + free), free};
  }
};

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

template <class Pass>
void SpringStep::for_branches(const Pass& pass) const {
  in_wide_registers([&] {
    switch (decay_.size()) {
      case 0:
        return pass(std::integral_constant<int, 0>());
      case 1:
        return pass(std::integral_constant<int, 1>());
      case 2:
        return pass(std::integral_constant<int, 2>());
      case 3:
        return pass(std::integral_constant<int, 3>());
      default:
        return pass(std::integral_constant<int, -1>());
    }
  });
}

void SpringStep::advance(SpringState& state, const SpringBed& bed, const IndenterState& to) const {
  if (viscosity_ > 0)
    for_branches([&](auto n) { advance_springs<true, n()>(state, bed, to); });
  else
    for_branches([&](auto n) { advance_springs<false, n()>(state, bed, to); });
  state.indenter_before = std::exchange(state.indenter, to);
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

template <int n_branches>
auto SpringStep::lines_of(Eigen::Index n_springs) const {
  SpringLines<n_branches, TipRule> lines{{},         decay_.data(),          static_cast<Eigen::Index>(decay_.size()),
                                         n_springs,  1 + gain_sum_,          gain_sum_,
                                         viscosity_, 1.5 * viscosity_ / dt_, tip_under_};
  if constexpr (n_branches > 0) std::copy_n(decay_.begin(), n_branches, lines.few_decays.begin());
  return lines;
}

NormalLines SpringStep::normal_lines(const SpringState& state, const SpringBed& bed) const {
  const Eigen::Index n = bed.depth.size();
  const double coasting = arrived(state, 0, 0).indentation_rate;
  NormalLines lines{Eigen::ArrayXd(n), Eigen::ArrayXd(n), 1 + gain_sum_ + 1.5 * viscosity_ / dt_};
  double *zero = lines.zero.data(), *touch = lines.touch.data();
  const double *depth = bed.depth.data(), *u = state.normal_depth.data(), *p = state.normal_load.data(),
               *memory = state.normal_memory.data();
  for_branches([&](auto n_branches) {
    const auto of = lines_of<n_branches()>(n);
#pragma GCC ivdep
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto line = of.normal_line(depth[j], u[j], p[j], of.branch_force(memory, j), coasting);
      zero[j] = line.zero;
      touch[j] = line.touch;
    }
  });
  return lines;
}

TangentialLines SpringStep::tangential_lines(const SpringState& state, const SpringBed& bed, double indentation) const {
  const Eigen::Index n = bed.depth.size();
  const auto coasting = arrived(state, 0, state.indenter.tangential);
  const double coasting_down = coasting.indentation_rate, coasting_along = coasting.tangential_rate, limit = limit_,
               before = state.indenter.indentation;
  TangentialLines lines{Eigen::ArrayXd(n), Eigen::ArrayXd(n), Eigen::ArrayXd(n)};
  double *value = lines.value.data(), *slope = lines.slope.data(), *most = lines.most.data();
  const double *depth = bed.depth.data(), *u = state.normal_depth.data(), *v = state.tangential_shift.data(),
               *p = state.normal_load.data(), *memory = state.normal_memory.data(),
               *tangential_memory = state.tangential_memory.data();
  for_branches([&](auto n_branches) {
    const auto of = lines_of<n_branches()>(n);
#pragma GCC ivdep
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto line = of.normal_line(depth[j], u[j], p[j], of.branch_force(memory, j), coasting_down);
      const auto force = of.branch_force(tangential_memory, j);
      const double touching = indentation - depth[j],
                   held = share_in_contact(p[j], u[j] - (before - depth[j]), touching - line.free),
                   free = of.tip_under(0.0, v[j], force.left, v[j] + force.now);
      value[j] = v[j] + force.left + of.stiffness * (1 - held) * (free - v[j]) + of.viscosity * coasting_along;
      slope[j] = of.stiffness * held + of.rate;
      const double load = (of.stiffness + of.rate) * (indentation - line.zero);
      most[j] = limit * (indentation > line.touch ? load : 0);
    }
  });
  return lines;
}

}  // namespace fretval::mdr
