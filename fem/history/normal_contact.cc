#include "fem/history/normal_contact.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "fem/contact/force_balance.h"
#include "fem/contact/require_room.h"
#include "fem/ring_contact/contact_events.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

double total_force(const ContactForce& reading) {
  return reading.force + reading.beyond.force;
}

}  // namespace

NormalContact::NormalContact(const ContactProblem& problem, const RelaxationModel& relaxation, Eigen::VectorXd shape,
                             const Motion& motion, int steps_per_cycle, ForceReading how,
                             std::optional<Eigen::Index> n_inside_flank)
    : profile(std::move(shape)),
      state{{}, Eigen::MatrixXd::Zero(profile.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
      problem_(problem),
      relaxation_(relaxation),
      motion_(motion),
      steps_per_cycle_(steps_per_cycle),
      how_(how),
      series_(touches_in_order() ? series_under(problem, profile) : problem.series),
      n_inside_flank_(n_inside_flank),
      times_(motion, steps_per_cycle),
      dt_(times_.begin(1)),
      step_(relaxation, dt_),
      contact_(static_cast<std::size_t>(profile.size()), BoxState::lower) {
  const double depth = start_indentation();
  const auto contact = static_contact(problem, profile, depth);
  state.displacement = (depth - profile.array() + contact.gap.array()).matrix();
  for (Eigen::Index i = 0; i < profile.size(); ++i)
    if (contact.pressure[i] > 0) contact_[static_cast<std::size_t>(i)] = BoxState::interior;
  indentation = balance_indentation = depth;
  gap = balance_gap = contact.gap;
  reading = read_elastic(contact);
  if (touches_in_order() && relaxation.has_memory()) {
    free_surface_.emplace(problem.series, state, (contact.pressure.array() > 0).count());
    ends_of_profile_ = problem.series.displacements(profile);
    in_contact_for = (contact.pressure.array() > 0).select(infinity, Eigen::VectorXd::Zero(profile.size()));
  }
  reading.force *= relaxation.relaxed;
  pressure = relaxation.relaxed * contact.pressure;
  start_.rings.load = problem.series.depths(pressure);
}

/// Where the rings of a contact are added up; empty: it is read up to its edge.
std::optional<ContactForce> NormalContact::sum(const Eigen::VectorXd& on_rings) const {
  if (how_ == ForceReading::sum_of_rings)
    return sum_of_rings(problem_.compliance.radii, problem_.compliance.areas, on_rings);
  if (n_inside_flank_ && on_rings.head(*n_inside_flank_).minCoeff() > 0)
    return sum_inside_flank(problem_.compliance, on_rings, *n_inside_flank_);
  return std::nullopt;
}

ContactForce NormalContact::read_elastic(const StaticContact& contact) const {
  if (const auto added_up = sum(contact.pressure)) return *added_up;
  return contact_force(series_, contact.pressure, contact.gap);
}

void NormalContact::read(double depth, Attempt& made) const {
  const auto& series = problem_.series;
  const auto& pressure_made = made.rings.pressure;
  const auto added_up = sum(pressure_made);
  if (relaxation_.has_memory() || !added_up) {
    made.depths = pressure_made;
    series.to_depths(made.depths);
  }
  if (added_up) {
    made.reading = *added_up;
    return;
  }
  made.depths_of_instant = made.depths;
  std::optional<TimesInContact> times;
  if (relaxation_.has_memory()) {
    made.courses.to_instant(made.depths_of_instant);
    free_surface_->find_opening(step_, ends_of_profile_, depth, made.opening);
    made.in_contact_for = in_contact_for + dt_ * (step_.fraction() - made.courses.touches_at.array()).max(0).matrix();
    times.emplace(TimesInContact{relaxation_, made.in_contact_for});
  } else {
    made.opening.value = made.balance_gap;
    series.to_displacements(made.opening.value);
  }
  made.reading = contact_force(series_, {pressure_made, made.depths_of_instant, made.opening, times});
}

double NormalContact::start_indentation() const {
  const double start = normal_motion(motion_, 0).value;
  if (!motion_.normal_force) return start;
  const double force = start / relaxation_.relaxed, guess = profile.tail(1)[0] / 2,
               stiffness = problem_.series.force_per_radius() * problem_.compliance.radii.back() / 2;
  const auto force_at = [this](double depth) {
    const auto contact = static_contact(problem_, profile, depth);
    return total_force(read_elastic(contact));
  };
  return displacement_for_force(force_at, force, {guess, stiffness, force});
}

/// The load is that of the last step.
void NormalContact::find_start() {
  step_.find_response_without_slip(state, standing_still, start_.standing);
  if (!relaxation_.has_memory()) return;
  start_.rings.standing = start_.standing;
  start_.rings.gap = gap;
  for (auto* rings : {&start_.rings.standing, &start_.rings.gap}) problem_.series.to_displacements(*rings);
}

/// Free rings do not know the indenter: but for what rings in contact drive them, they move by themselves, linearly in
/// time, and what it moves by is no more than what their gaps change by.
void NormalContact::attempt(const Move& move, const WearingSolver& solver, Attempt& made) const {
  auto& courses = made.courses;
  if (relaxation_.has_memory())
    find_courses(problem_.series, step_, start_.rings, move.to_balance, move.whole.increment, courses);
  else
    courses.driven.setZero(gap.size());
  // A ring in contact closes its gap: it slips by what is left of it.
  made.target = start_.standing + step_.response_to(move.to_balance) * courses.driven +
                step_.instantaneous() * (courses.left_behind(move.whole.increment) - gap);
  if (courses.has_turns) made.target += courses.response;
  solver.solve(made.target, made.contact, made.room, made.rings);
  made.rings.gap /= step_.instantaneous();
  made.balance_gap = step_.fraction() * made.rings.gap + (1 - step_.fraction()) * gap;
  read(indentation + move.to_balance.increment, made);
}

NormalContact::Move NormalContact::steady(double increment) const {
  const double share = step_.fraction();
  return {steady_move(share * increment, share * dt_), steady_move(increment, dt_)};
}

/// First the increment of the indentation in the whole step, in which it moves steadily.
std::pair<double, NormalContact::Attempt> NormalContact::attempt_under_force(const WearingSolver& solver) const {
  const double force = normal_motion(motion_, time).value,
               stiffness = problem_.series.force_per_radius() * reading.radius * step_.instantaneous();
  auto last = made_;
  const auto make = [&](double increment) {
    attempt(steady(increment), solver, last);
    return last;
  };
  const auto force_of = [](const Attempt& made) { return total_force(made.reading); };
  return attempt_for_force(make, force_of, force, {last_increment_, stiffness, force});
}

FrozenStep NormalContact::frozen() const {
  FrozenStep frozen{step_, std::vector<bool>(contact_.size())};
  std::transform(contact_.begin(), contact_.end(), frozen.held.begin(),
                 [](BoxState state) { return state == BoxState::interior; });
  return frozen;
}

std::optional<StepInPiece> NormalContact::in_piece() const {
  auto step = times_.in_piece(n_steps - 1);
  if (step) step->fraction = step_.fraction();
  return step;
}

void NormalContact::step(const PressureWear& wear) {
  const double begin = times_.begin(n_steps);
  if (const auto piece = times_.in_piece(n_steps); piece && piece->duration() != dt_) {
    last_increment_ *= piece->duration() / dt_;
    dt_ = piece->duration();
    step_ = RelaxationStep(relaxation_, dt_);
  }
  const double weight = step_.fraction(), end = begin + dt_;
  time = begin + weight * dt_;
  gap = state.displacement + profile;
  gap.array() -= indentation;
  const auto position = [this, inside = begin + dt_ / 2](double t) { return normal_motion_inside(motion_, t, inside); };
  Move move{indenter_move(position, begin, time), indenter_move(position, begin, end)};
  const WearingSolver solver(problem_, {step_.instantaneous() * wear.coefficient, wear.exponent}, contact_);
  find_start();
  made_.contact = contact_;
  if (motion_.normal_force) {
    std::tie(last_increment_, made_) = attempt_under_force(solver);
    move = steady(last_increment_);
  } else {
    attempt(move, solver, made_);
  }
  const auto& courses = made_.courses;
  slip_ = gap - made_.rings.gap;
  if (wear.coefficient.size() > 0) {
    const Eigen::VectorXd worn = worn_by(wear, made_.rings.pressure);
    slip_ += worn;
    profile += worn;
    if (free_surface_) ends_of_profile_ = problem_.series.displacements(profile);
  }
  slip_ -= courses.left_behind(move.whole.increment);
  step_.advance(state, move.whole, slip_, courses.driven);
  if (courses.has_turns) state.memory += courses.memory;
  if (free_surface_) {
    for (Eigen::Index i = 0; i < gap.size(); ++i)
      in_contact_for[i] = made_.contact[static_cast<std::size_t>(i)] == BoxState::interior
                              ? in_contact_for[i] + dt_ * (1 - courses.touches_at[i])
                              : 0;
    free_surface_->advance(step_, state, made_.contact, made_.reading.radius);
  }
  balance_indentation = motion_.normal_force ? indentation + move.to_balance.increment : position(time).value;
  indentation = motion_.normal_force ? indentation + move.whole.increment : position(times_.begin(n_steps + 1)).value;
  gap.swap(made_.rings.gap);
  balance_gap.swap(made_.balance_gap);
  pressure.swap(made_.rings.pressure);
  contact_ = made_.contact;
  reading = made_.reading;
  start_.rings.load.swap(made_.depths);
  ++n_steps;
  require_room(pressure);
}

}  // namespace fretval::fem
