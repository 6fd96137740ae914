#include "fem/history/friction_contact.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "fem/contact/force_balance.h"
#include "fem/contact/gross_slip.h"
#include "fem/ring_contact/contact_force.h"
#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

/// Least response of the rings, over that of the relaxed body to the largest displacement of the indenter so far, that
/// is read from the depths which are stepped along. In a smaller one, as with hardly any friction, their roundoff would
/// be more than 1e-10 of it, and a step asks for 1e-9.
constexpr double still_summed = 1e-3;

}  // namespace

FrictionContact::FrictionContact(const ContactProblem& problem, const RelaxationModel& relaxation,
                                 double friction_coefficient, const Motion& motion, int steps_per_cycle)
    : limit(Eigen::VectorXd::Zero(problem.n_rings())),
      limit_depths(limit),
      traction(limit),
      slip(limit),
      slip_depths(limit),
      state{limit, Eigen::MatrixXd::Zero(limit.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
      zones(limit.size()),
      problem_(problem),
      relaxation_(relaxation),
      friction_coefficient_(friction_coefficient),
      motion_(motion),
      steps_per_cycle_(steps_per_cycle),
      times_(motion, steps_per_cycle),
      n_steps_of_ramp_(static_cast<long>(motion.cycles_of_ramp()) * steps_per_cycle),
      dt_(times_.begin(1)),
      step_(relaxation, dt_),
      depths_of_state_(state),
      moves_of_cycle_(static_cast<std::size_t>(steps_per_cycle)),
      made_{std::vector<BoxState>(static_cast<std::size_t>(limit.size()), BoxState::interior), {}, {}, {}, {}, {}},
      until_touch_(limit.size()) {}

/// Reads the depths from the state anew. At the start of every cycle is enough: in between they are stepped like the
/// state, and their roundoff stays small.
void FrictionContact::read_depths_of_state() {
  const auto& series = problem_.series;
  depths_of_state_.displacement = series.displacements(state.displacement);
  for (Eigen::Index i = 0; i < state.memory.cols(); ++i)
    depths_of_state_.memory.col(i) = series.displacements(state.memory.col(i));
}

void FrictionContact::attempt(const IndenterMove& to_balance, Attempt& made) const {
  auto& [stick, target, solution, slip_to_touch, depths_to_touch, depths] = made;
  step_.find_response_without_slip(state, to_balance, target.q);
  const double largest_response = target.q.lpNorm<Eigen::Infinity>();
  target.q = problem_.compliance.areas.cwiseProduct(target.q);
  if (largest_response < still_summed * relaxation_.relaxed * largest_displacement_) {
    problem_.solver.hold(target);
  } else {
    step_.find_response_without_slip(depths_of_state_, to_balance, target.held);
    target.held = problem_.series.loads_of_depths(target.held);
  }
  slip_before_touch(made);
  foresee_slip(made);
  problem_.solver.solve(target, least_, limit, stick, solution);
  depths = problem_.series.depths_of_loads(solution.loads);
}

/// Where the rings around the centre stick and all others slip one way, the rings slip whose depths would exceed their
/// limit if all rings stuck: at the edge of the stick zone traction and slip have the signs of what is left of the
/// limit. In other states that is only about right, and rings at their very limit are what they were in the last step.
void FrictionContact::foresee_slip(Attempt& made) const {
  constexpr double roundoff = 1e-10;
  auto& depths = made.depths;
  depths = problem_.series.depths_of_loads(made.target.held);
  const double close = roundoff * depths.lpNorm<Eigen::Infinity>();
  Eigen::Index n_touching = limit.size(), n_stuck = 0;
  while (n_touching > 0 && limit[n_touching - 1] == 0) --n_touching;
  while (n_stuck < n_touching && std::abs(depths[n_stuck]) < limit_depths[n_stuck] - close) ++n_stuck;
  const double way = n_stuck < n_touching && depths[n_stuck] < 0 ? -1 : 1;
  for (Eigen::Index i = n_stuck; i < n_touching; ++i)
    if (!(way * depths[i] > limit_depths[i] + close)) return;
  std::fill(made.stick.begin(), made.stick.begin() + n_stuck, BoxState::interior);
  std::fill(made.stick.begin() + n_stuck, made.stick.begin() + n_touching, way > 0 ? BoxState::upper : BoxState::lower);
}

double FrictionContact::force_of(const Attempt& made, const std::optional<NormalInstant>& normal) const {
  if (!normal) return problem_.compliance.areas.dot(made.solution.x);
  SlipZones after = zones;
  after.update(limit, made.stick, made.depths);
  return friction_force(problem_.series, after, *touching_, limit_depths, friction_coefficient_ * normal->force).value;
}

/// Returns the increment of the displacement in the whole step, in which the indenter moves steadily, and the attempt
/// with it.
std::pair<double, FrictionContact::Attempt> FrictionContact::attempt_under_force(
    double time, const std::optional<NormalInstant>& normal) {
  if (normal) {
    if (!touching_) touching_.emplace(TouchingRings{normal->touch_radii, relaxation_.viscosity == 0});
    touching_->move_to(normal->radius);
  }
  const auto borne = normal ? ContactForce{friction_coefficient_ * normal->force, normal->radius}
                            : sum_of_rings(problem_.compliance.radii, problem_.compliance.areas, limit);
  const double force = tangential_motion(motion_, time).value, most = borne.force, spare = most - std::abs(force);
  if (!(spare > 0)) {
    const double share = spare_before_ > 0 ? spare_before_ / (spare_before_ - spare) : 1,
                 start = time_before_ + share * (time - time_before_);
    throw GrossSlip(start, amplitude_share(motion_, start));
  }
  time_before_ = time;
  spare_before_ = spare;
  const auto n_stuck = std::count(made_.stick.begin(), made_.stick.end(), BoxState::interior);
  const double radius = std::min(problem_.compliance.radii[static_cast<std::size_t>(n_stuck)], borne.radius),
               stiffness = problem_.series.force_per_radius() * radius * step_.instantaneous();
  auto last = made_;
  const auto make = [&](double increment) {
    attempt(steady_move(step_.fraction() * increment, step_.fraction() * dt_), last);
    return last;
  };
  const auto force_made = [&](const Attempt& made) { return force_of(made, normal); };
  return attempt_for_force(make, force_made, force, {last_increment_, stiffness, most});
}

void FrictionContact::find_touching(const Eigen::Ref<const Eigen::VectorXd>& pressure,
                                    const std::optional<NormalInstant>& normal) {
  n_touching_ = 0;
  // Under a prescribed tangential force the correction is left out: the move of the indenter follows from the rings
  // that are held, and with the correction stick radii scatter seven times as much.
  if (!normal || relaxation_.viscosity > 0 || motion_.tangential_force) return;
  const double before = std::exchange(radius_before_, normal->radius), growth = normal->radius - before;
  if (n_steps == 0 || !(growth > 0)) return;
  first_touching_ = 0;
  while (first_touching_ < limit.size() && limit[first_touching_] > 0) ++first_touching_;
  Eigen::Index end = first_touching_;
  while (end < limit.size() && pressure[end] > 0) ++end;
  n_touching_ = end - first_touching_;
  const auto radii = normal->touch_radii.segment(first_touching_, n_touching_).array();
  until_touch_.head(n_touching_) = ((radii - before) / growth).max(0).min(1);
}

/// While the contact grows, the indenter takes along the rings that touch already: each punch of PunchSeries moves from
/// the instant on at which its outermost ring touches.
void FrictionContact::slip_before_touch(Attempt& made) const {
  auto& [stick, target, solution, slip_to_touch, depths_to_touch, depths] = made;
  if (n_touching_ == 0) return;
  const auto touching = [this](auto&& rings) { return rings.segment(first_touching_, n_touching_); };
  slip_to_touch.setZero(limit.size());
  auto missing = touching(slip_to_touch);
  missing = until_touch_.head(n_touching_).cwiseProduct(touching(problem_.series.depths_of_loads(target.held)));
  problem_.series.to_rings(missing, first_touching_);
  touching(target.q) -= touching(problem_.compliance.areas).cwiseProduct(missing);
  missing /= step_.stiffness_before_balance();
  depths_to_touch = slip_to_touch;
  problem_.series.to_displacements(depths_to_touch);
  target.held -= step_.stiffness_before_balance() * problem_.series.loads_of_depths(depths_to_touch);
}

std::optional<StepInPiece> FrictionContact::in_piece() const {
  auto step = times_.in_piece(n_steps - 1);
  if (step) step->fraction = step_.fraction();
  return step;
}

FrictionContact::Moves FrictionContact::moves_in_step(double begin) const {
  const auto position = [this, inside = begin + dt_ / 2](double t) {
    return tangential_motion_inside(motion_, t, inside);
  };
  const double weight = step_.fraction();
  const auto to_balance = indenter_move(position, begin, begin + weight * dt_);
  return {to_balance, weight == 1 ? to_balance : indenter_move(position, begin, begin + dt_)};
}

/// The moves of a cycle that repeats are kept: to evaluate their cosines takes a tenth of the time of a step.
const FrictionContact::Moves& FrictionContact::moves() {
  const bool repeats = motion_.locked && !motion_.path && n_steps >= n_steps_of_ramp_;
  if (!repeats) return moves_ = moves_in_step(times_.begin(n_steps));
  const long step = n_steps % steps_per_cycle_;
  auto& known = moves_of_cycle_[static_cast<std::size_t>(step)];
  // The move is always made at the time of the first cycle after the ramp, whichever cycle asks first, so that a
  // contact that was read back goes on the same to the last bit.
  if (!known) known = moves_in_step(times_.begin(n_steps_of_ramp_ + step));
  return *known;
}

void FrictionContact::step(const Eigen::Ref<const Eigen::VectorXd>& pressure,
                           const std::optional<NormalInstant>& normal) {
  const double begin = times_.begin(n_steps);
  if (const auto piece = times_.in_piece(n_steps); piece && piece->duration() != dt_) {
    last_increment_ *= piece->duration() / dt_;
    dt_ = piece->duration();
    step_ = RelaxationStep(relaxation_, dt_);
  }
  if (n_steps % steps_per_cycle_ == 0) read_depths_of_state();
  find_touching(pressure, normal);
  limit = friction_coefficient_ * pressure;
  least_ = -limit;
  if (normal && normal->pressure_depths) {
    limit_depths = friction_coefficient_ * *normal->pressure_depths;
  } else {
    limit_depths = limit;
    problem_.series.to_depths(limit_depths);
  }
  if (motion_.tangential_force) {
    const double weight = step_.fraction();
    std::tie(last_increment_, made_) = attempt_under_force(begin + weight * dt_, normal);
    moves_ = {steady_move(weight * last_increment_, weight * dt_), steady_move(last_increment_, dt_)};
  }
  const auto& [to_balance, whole] = motion_.tangential_force ? moves_ : moves();
  if (!motion_.tangential_force) attempt(to_balance, made_);
  auto& [stick, target, solution, slip_to_touch, depths_to_touch, depths] = made_;
  zones.update(limit, stick, depths);
  for (std::size_t i = 0; i < stick.size(); ++i)
    if (limit[static_cast<Eigen::Index>(i)] == 0) stick[i] = BoxState::interior;  // the guess for when it touches again
  slip = solution.residual.cwiseQuotient(step_.instantaneous() * problem_.compliance.areas);
  slip_depths = problem_.series.depths_of_loads(target.held - solution.loads) / step_.instantaneous();
  if (n_touching_ > 0) {
    slip += slip_to_touch;
    slip_depths += depths_to_touch;
  }
  step_.advance(state, whole, slip);
  step_.advance(depths_of_state_, whole, slip_depths);
  balance_displacement = displacement + to_balance.increment;
  displacement += whole.increment;
  largest_displacement_ = std::max({largest_displacement_, std::abs(displacement), std::abs(balance_displacement)});
  traction.swap(solution.x);
  ++n_steps;
}

FrozenStep FrictionContact::frozen() const {
  FrozenStep frozen{step_, std::vector<bool>(made_.stick.size())};
  for (std::size_t i = 0; i < made_.stick.size(); ++i)
    frozen.held[i] = made_.stick[i] == BoxState::interior && limit[static_cast<Eigen::Index>(i)] > 0;
  return frozen;
}

}  // namespace fretval::fem
