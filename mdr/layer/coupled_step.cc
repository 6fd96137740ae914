#include "mdr/layer/coupled_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Theta of the exponentially fitted rule, as for independent springs, with z = step over relaxation time: 1/2
// (trapezoidal) for slow relaxation, towards 1 (implicit) for fast.
double fitted_theta(double z) {
  return z < 1e-3 ? 0.5 + z / 12 : -1 / std::expm1(-z) - 1 / z;
}

// Share of the step during which each spring is in contact; of a spring that touches in the step by its gap at the
// start (above) and its overlap with the indenter at the end (below), m.
Eigen::ArrayXd share_in_contact(const Eigen::ArrayXd& load_before, const Eigen::ArrayXd& above,
                                const Eigen::ArrayXd& below) {
  return (load_before > 0 || below <= 0).select(1.0, below / (below + above));
}

// Nothing has ever moved tangentially, and nothing does in the step.
bool rests(const SpringState& state, const PrescribedInStep& prescribed) {
  const auto none = [](const auto& values) { return (values == 0).all(); };
  return !prescribed.tangential_load && prescribed.indenter.tangential == state.indenter.tangential &&
         prescribed.indenter.tangential_rate == 0 && none(state.tangential_shift) && none(state.tangential_load) &&
         none(state.tangential_memory);
}

// The right of the equation of a row at y, which is the load where springs are in contact.
Eigen::ArrayXd load_at(const RowProblem& row, const Eigen::ArrayXd& coupling, double y) {
  return (row.value + row.slope * y - coupling) / row.stretch;
}

// Fall over the width of each spring of what is smooth across the edge; 0 where it rises outwards.
Eigen::ArrayXd fall_over_springs(const Eigen::ArrayXd& load) {
  const Eigen::Index n = load.size();
  Eigen::ArrayXd inner(n), outer(n);
  inner << load[0], load.head(n - 1);
  outer << load.tail(n - 1), 2 * load[n - 1] - load[std::max<Eigen::Index>(n - 2, 0)];
  return ((inner - outer) / 2).max(0.0);
}

// Of a body with memory the right of the equation has a kink where the contact ended a step before: what was not yet in
// contact would be pressed by all branches at once. Falls are lines through the differences on either side of it.
void set_falls_beside_kink(const Eigen::ArrayXd& load, Eigen::Index n_before, RowProblem& row) {
  const Eigen::Index n = load.size();
  row.fall = row.beyond = fall_over_springs(load);
  if (n_before < 3 || n - n_before < 2) return;
  const auto between = [&](Eigen::Index j) { return load[j - 1] - load[j]; };
  const auto line = [&](Eigen::Index nearest, Eigen::Index next, Eigen::Index j) {
    const double slope = (between(nearest) - between(next)) / static_cast<double>(nearest - next);
    return std::max(between(nearest) + (static_cast<double>(j - nearest) + 0.5) * slope, 0.0);
  };
  const Eigen::Index first_beyond = n_before + 1, next_beyond = std::min(first_beyond + 1, n - 1);
  const auto inside = [&](Eigen::Index j) { return line(n_before - 1, n_before - 2, j); };
  const auto beyond = [&](Eigen::Index j) {
    return next_beyond > first_beyond ? line(first_beyond, next_beyond, j) : std::max(between(first_beyond), 0.0);
  };
  row.fall[n_before - 1] = row.beyond[n_before - 1] = inside(n_before - 1);
  row.fall[n_before] = inside(n_before);
  row.beyond[n_before] = std::max(beyond(n_before), row.fall[n_before]);
  row.fall[first_beyond] = row.beyond[first_beyond] = beyond(first_beyond);
}

// Relaxed loads at an indentation, or with a given sum and the indentation that belongs to it. Their fall at the rim is
// taken from a solution without rim loads.
RowSolution relaxed_row(const CoupledBed& bed, double guess, std::optional<double> sum) {
  const Eigen::ArrayXd &g = bed.springs.depth, one = Eigen::ArrayXd::Ones(g.size());
  RowProblem row{-g, one, one, Eigen::ArrayXd::Zero(g.size()), Eigen::ArrayXd::Constant(g.size(), infinity)};
  RowSolver solver(bed.normal);
  const RowSolution without_rim = solver.solve(row, (guess - g).max(0.0), guess, sum);
  row.fall = row.beyond = fall_over_springs(load_at(row, without_rim.coupling, without_rim.y));
  return solver.solve(row, without_rim.load, without_rim.y, sum);
}

[[noreturn]] void slide(double load, double most) {
  GrossSlip slip("tangential force of " + std::to_string(std::abs(load) / most) +
                 " times mu times the normal force: the contact slides, there is no displacement for it");
  slip.excess = std::abs(load) - most;
  throw slip;
}

}  // namespace

CoupledStep::CoupledStep(const CoupledBed& bed, const PronyBody& body, double mu, double dt)
    : bed_(bed),
      normal_row_(bed.normal),
      tangential_row_(bed.tangential),
      limit_(mu * spring_modulus_ratio(bed.layer.poisson_ratio)),
      dt_(dt),
      gain_sum_(0) {
  validate(body);
  require_positive("coefficient of friction", mu);
  require_positive("time step", dt);
  for (std::size_t i = 0; i < body.branch_moduli.size(); ++i) {
    decay_.push_back(std::exp(-dt / body.branch_times[i]));
    gain_.push_back(branch_gain(body, i, dt));
    gain_sum_ += gain_.back();
  }
  stiffness_ = 1 + gain_sum_;
  viscosity_ = body.viscosity / body.relaxed_modulus;
  theta_ = viscosity_ > 0 ? fitted_theta(dt * stiffness_ / viscosity_) : 1;
}

Eigen::ArrayXd CoupledStep::left_of(const Eigen::ArrayXXd& memory) const {
  return (memory.matrix() * Eigen::Map<const Eigen::VectorXd>(decay_.data(), memory.cols())).array();
}

// Positions of the tips at the end of the step, from the loads of the body at its end and at its start.
Eigen::ArrayXd CoupledStep::tip_under(const Eigen::ArrayXd& load, const Eigen::ArrayXd& load_before,
                                      const Eigen::ArrayXd& position, const Eigen::ArrayXXd& memory) const {
  const double viscous = viscosity_ / dt_;
  return (theta_ * load + (1 - theta_) * load_before + viscous * position -
          theta_ * (left_of(memory) - gain_sum_ * position) - (1 - theta_) * (position + memory.rowwise().sum())) /
         (viscous + theta_ * stiffness_);
}

void CoupledStep::remember(Eigen::ArrayXXd& memory, const Eigen::ArrayXd& move) const {
  for (Eigen::Index i = 0; i < memory.cols(); ++i)
    memory.col(i) = decay_[static_cast<std::size_t>(i)] * memory.col(i) + gain_[static_cast<std::size_t>(i)] * move;
}

// Rate at the end of the step of an indenter that is at 0 then, by the parabola through its last two positions, m/s.
double CoupledStep::coasting_rate(double now, double before) const {
  return (before - 4 * now) / (2 * dt_);
}

CoupledStep::Request CoupledStep::normal_request(const SpringState& state, const PrescribedInStep& prescribed) const {
  const IndenterState &last = state.indenter, &before = state.indenter_before;
  const Eigen::ArrayXd& g = bed_.springs.depth;
  const auto n = g.size();
  Request request{{left_of(state.normal_memory) - gain_sum_ * state.normal_depth - stiffness_ * g,
                   Eigen::ArrayXd::Constant(n, stiffness_), Eigen::ArrayXd::Ones(n), Eigen::ArrayXd::Zero(n),
                   Eigen::ArrayXd::Constant(n, infinity)},
                  prescribed.indenter.indentation,
                  {}};
  if (!prescribed.normal_load) {
    request.row.value += viscosity_ * prescribed.indenter.indentation_rate;
    return request;
  }
  require_positive("normal load", *prescribed.normal_load);
  request.guess = 2 * last.indentation - before.indentation;
  request.sum = *prescribed.normal_load / bed_.springs.width[0];
  request.row.slope += 1.5 * viscosity_ / dt_;
  request.row.value += viscosity_ * coasting_rate(last.indentation, before.indentation);
  return request;
}

CoupledStep::Normal CoupledStep::normal_step(const SpringState& state, const PrescribedInStep& prescribed) const {
  const Eigen::ArrayXd &u = state.normal_depth, &p = state.normal_load, &g = bed_.springs.depth;
  Request request = normal_request(state, prescribed);
  const Eigen::ArrayXd coupled_before = coupling(bed_.normal, p + state.rim_load),
                       above = u - (state.indenter.indentation - g);
  Eigen::ArrayXd free_tips = u;
  if (viscosity_ > 0) {
    free_tips = tip_under(coupled_before, coupled_before, u, state.normal_memory);
    request.row.upper = (p > 0 || free_tips < request.guess - g).select(request.row.upper, 0.0);
  } else {
    const Eigen::ArrayXd load = load_at(request.row, coupled_before, request.guess);
    if (gain_sum_ > 0)
      set_falls_beside_kink(load, (p > 0).count(), request.row);
    else
      request.row.fall = request.row.beyond = fall_over_springs(load);
  }
  const RowSolution found = normal_row_.solve(request.row, p, request.guess, request.sum);
  const Eigen::ArrayXd touching = found.y - g;
  const Eigen::ArrayXd tips =
      tip_under(found.load + found.coupling, coupled_before, u, state.normal_memory).max(touching);
  const Eigen::ArrayXd below = viscosity_ > 0 ? Eigen::ArrayXd(touching - free_tips) : found.load / stiffness_;
  return {found.load, found.rim_load, (found.load > 0).select(touching, tips), share_in_contact(p, above, below),
          found.y};
}

// y is how far the indenter moves in the step.
CoupledStep::Request CoupledStep::tangential_request(const SpringState& state, const PrescribedInStep& prescribed,
                                                     const Normal& normal, const Eigen::ArrayXd& free_tips) const {
  const IndenterState &last = state.indenter, &before = state.indenter_before;
  const Eigen::ArrayXd &v = state.tangential_shift, &held = normal.held;
  const Eigen::ArrayXd most = limit_ * normal.load, stuck = v + left_of(state.tangential_memory);
  Request request{{}, prescribed.indenter.tangential - last.tangential, {}};
  if (viscosity_ > 0)
    request.row = {stuck + stiffness_ * (1 - held) * (free_tips - v), stiffness_ * held, Eigen::ArrayXd::Ones(v.size()),
                   -most, most};
  else  // Until it touches a tip moves with the coupling, which the stretch takes account of.
    request.row = {stuck, Eigen::ArrayXd::Constant(v.size(), stiffness_), 1 / held.max(1e-300), -most, most};
  if (!prescribed.tangential_load) {
    request.row.value += viscosity_ * prescribed.indenter.tangential_rate;
    return request;
  }
  const double width = bed_.springs.width[0];
  request.guess = last.tangential - before.tangential;
  request.sum = *prescribed.tangential_load / width;
  if (std::abs(*request.sum) >= most.sum()) slide(*prescribed.tangential_load, most.sum() * width);
  request.row.slope += 1.5 * viscosity_ / dt_;
  request.row.value += viscosity_ * (coasting_rate(last.tangential, before.tangential) + 1.5 / dt_ * last.tangential);
  return request;
}

CoupledStep::Tangential CoupledStep::at_rest(const SpringState& state) {
  const Eigen::ArrayXd none = Eigen::ArrayXd::Zero(state.tangential_load.size());
  return {none, none, none, 0};
}

CoupledStep::Tangential CoupledStep::tangential_step(const SpringState& state, const PrescribedInStep& prescribed,
                                                     const Normal& normal) const {
  using Flags = Eigen::Array<bool, Eigen::Dynamic, 1>;
  const Eigen::ArrayXd &v = state.tangential_shift, &t = state.tangential_load, &held = normal.held;
  const Eigen::ArrayXd coupled_before = coupling(bed_.tangential, t);
  const Eigen::ArrayXd free_tips = tip_under(coupled_before, coupled_before, v, state.tangential_memory);
  const Request request = tangential_request(state, prescribed, normal, free_tips);
  const RowSolution found = tangential_row_.solve(request.row, t, request.guess, request.sum);
  const Flags in_contact = normal.load > 0, sticks = in_contact && found.load.abs() < request.row.upper,
              touches = in_contact || state.normal_load > 0;
  const Eigen::ArrayXd slipping =
      tip_under(found.load + found.coupling, coupled_before + in_contact.select(t, 0.0), v, state.tangential_memory);
  const Eigen::ArrayXd free_now = viscosity_ > 0 ? free_tips : Eigen::ArrayXd(slipping - found.load / stiffness_);
  const Eigen::ArrayXd stuck_tips = v + held * found.y + (1 - held) * (free_now - v);
  const Eigen::ArrayXd tips = sticks.select(stuck_tips, slipping);
  return {found.load, tips, touches.select(stuck_tips - tips, 0.0), found.y};
}

void CoupledStep::advance(SpringState& state, const PrescribedInStep& prescribed) const {
  if (bed_.layer.base == LayerBase::frictionless &&
      (prescribed.tangential_load.value_or(0) != 0 || prescribed.indenter.tangential != 0))
    throw std::invalid_argument(
        "base of the layer = frictionless: nothing holds the layer against a tangential motion; must be bonded");
  const Normal normal = normal_step(state, prescribed);
  Tangential tangential = rests(state, prescribed) ? at_rest(state) : tangential_step(state, prescribed, normal);
  remember(state.normal_memory, normal.depth - state.normal_depth);
  remember(state.tangential_memory, tangential.tip - state.tangential_shift);
  state.normal_depth = normal.depth;
  state.normal_load = normal.load;
  state.rim_load = normal.rim_load;
  state.tangential_shift = std::move(tangential.tip);
  state.tangential_load = std::move(tangential.load);
  state.slip = std::move(tangential.slip);
  const IndenterState last = state.indenter, before = state.indenter_before;
  IndenterState to = prescribed.indenter;
  if (prescribed.normal_load) {
    to.indentation = normal.indentation;
    to.indentation_rate = 1.5 / dt_ * to.indentation + coasting_rate(last.indentation, before.indentation);
  }
  if (prescribed.tangential_load) {
    to.tangential = last.tangential + tangential.shift;
    to.tangential_rate = 1.5 / dt_ * to.tangential + coasting_rate(last.tangential, before.tangential);
  }
  state.indenter_before = std::exchange(state.indenter, to);
}

SpringState relaxed_state(const CoupledBed& bed, const PronyBody& body, double indentation) {
  SpringState state = relaxed_state(bed.springs, body, indentation);
  const RowSolution found = relaxed_row(bed, indentation, {});
  state.normal_load = found.load;
  state.rim_load = found.rim_load;
  state.normal_depth = (found.load > 0).select(indentation - bed.springs.depth, found.coupling);
  return state;
}

double relaxed_indentation(const CoupledBed& bed, double load) {
  require_positive("normal load", load);
  return relaxed_row(bed, bed.springs.depth.maxCoeff(), load / bed.springs.width[0]).y;
}

}  // namespace fretval::mdr
