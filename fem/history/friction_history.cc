#include "fem/history/friction_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "fem/history/drive_to_period.h"
#include "fem/history/friction_search.h"
#include "fem/history/scatter.h"
#include "fem/ring_contact/friction_force.h"
#include "fem/ring_contact/pressure_for_friction.h"
#include "fem/ring_contact/sliding_ends.h"
#include "fem/ring_contact/unseen_slip.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

/// Samples from which the tangential forces of a period are read once it is known to be the last one, as a reading
/// takes as long as a step.
class ForcesOfPeriod {
 public:
  ForcesOfPeriod(const FrictionContact& contact, const TouchingRings& touching, int n_steps)
      : samples_(static_cast<std::size_t>(n_steps), Sample{contact.zones, touching, 0}) {}

  void see(const FrictionContact& contact, const TouchingRings& touching, double normal_force) {
    auto& sample = samples_[static_cast<std::size_t>(contact.n_steps - 1) % samples_.size()];
    sample.zones = contact.zones;
    sample.touching = touching;
    sample.limit_force = contact.friction_coefficient() * normal_force;
  }

  void report(const FrictionContact& contact, const Eigen::MatrixXd& limit_depths, FrictionHistory& history) const {
    const auto n = static_cast<Eigen::Index>(samples_.size());
    history.force.resize(n);
    history.force_uncertainty.resize(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const auto& [zones, touching, limit_force] = samples_[static_cast<std::size_t>(k)];
      const auto force = friction_force(contact.problem().series, zones, touching, limit_depths.col(k), limit_force);
      history.force[k] = force.value;
      history.force_uncertainty[k] = force.uncertainty;
    }
  }

 private:
  struct Sample {
    SlipZones zones;
    TouchingRings touching;
    double limit_force;
  };
  std::vector<Sample> samples_;  // by step of the period
};

}  // namespace

FrictionPeriod::FrictionPeriod(Eigen::Index n_rings, int n_steps)
    : forward_(n_rings),
      backward_(n_rings),
      slip_(n_rings),
      traction_(Eigen::MatrixXd::Zero(n_rings, n_steps)),
      displacement_(traction_),
      depths_(traction_),
      limit_depths_(traction_),
      pieces_(static_cast<std::size_t>(n_steps)),
      indenter_(n_steps),
      both_ways_(2),
      extremes_(2, -infinity),
      zones_(static_cast<std::size_t>(n_rings)),
      last_traction_(Eigen::VectorXd::Zero(n_rings)),
      last_depths_(last_traction_),
      work_(n_rings),
      series_work_(n_rings) {
  begin();
}

void FrictionPeriod::begin() {
  extremes_.restart();
  forward_.setConstant(infinity);
  backward_.setConstant(infinity);
  for (auto* sum : {&slip_, &work_, &series_work_}) sum->setZero();
  largest_change_ = largest_traction_ = 0;
  std::fill(zones_.begin(), zones_.end(), 0);
  if (k_ > 0) {
    const int n_kept = std::min(k_, RunningMinimum::n_before);
    depths_before_ = depths_.middleCols(k_ - n_kept, n_kept);
    limit_depths_before_ = limit_depths_.middleCols(k_ - n_kept, n_kept);
    pieces_before_.assign(pieces_.begin() + k_ - n_kept, pieces_.begin() + k_);
  }
  k_ = 0;
}

void FrictionPeriod::pass(const FrictionContact& contact) {
  forward_ = forward_.cwiseMin(contact.limit - contact.traction);
  backward_ = backward_.cwiseMin(contact.limit + contact.traction);
  slip_ += contact.slip.cwiseAbs();
  largest_change_ = std::max(largest_change_, (contact.traction - traction_.col(k_)).lpNorm<Eigen::Infinity>());
  largest_traction_ = std::max(largest_traction_, contact.traction.lpNorm<Eigen::Infinity>());
  last_traction_ = traction_.col(k_) = contact.traction;
  last_depths_ = depths_.col(k_) = contact.zones.depths();
  limit_depths_.col(k_) = contact.limit_depths;
  pieces_[static_cast<std::size_t>(k_++)] = contact.in_piece();
}

void FrictionPeriod::see(const FrictionContact& contact) {
  displacement_.col(k_) = contact.balance_displacements();
  // The mean slip rate of a step belongs to its middle, between two balance times.
  const double weight = 1.5 - contact.fraction();
  work_ += (weight * contact.traction + (1 - weight) * last_traction_).cwiseProduct(contact.slip);
  series_work_ += (weight * contact.zones.depths() + (1 - weight) * last_depths_).cwiseProduct(contact.slip_depths);
  auto whole_step = contact.in_piece();  // the indenter is known at its end
  if (whole_step) whole_step->fraction = 1;
  both_ways_ << contact.displacement, -contact.displacement;
  extremes_.add(both_ways_, whole_step);
  indenter_[k_] = contact.balance_displacement;
  for (std::size_t i = 0; i < zones_.size(); ++i) zones_[i] |= contact.limit[static_cast<Eigen::Index>(i)] > 0 ? 2 : 4;
  pass(contact);
}

/// Smallest slip reserve of the period in a direction, without a floor (see FirstSlip).
Eigen::VectorXd FrictionPeriod::smallest_reserve(double direction) const {
  RunningMinimum smallest(slip_.size(), -infinity);
  const auto add = [&](const auto& limit_depths, const auto& depths, const auto& pieces, Eigen::Index n) {
    for (Eigen::Index k = 0; k < n; ++k)
      smallest.add(limit_depths.col(k) - direction * depths.col(k), pieces[static_cast<std::size_t>(k)]);
  };
  add(limit_depths_before_, depths_before_, pieces_before_, depths_before_.cols());
  smallest.restart();
  add(limit_depths_, depths_, pieces_, k_);
  return smallest.value();
}

void FrictionPeriod::hand_over(const ContactProblem& problem, FrictionHistory& history) {
  history.shakedown_margin = (forward_ + backward_) / 2;
  history.shakedown_reserve = (smallest_reserve(1) + smallest_reserve(-1)) / 2;
  history.period_slip = slip_;
  constexpr double roundoff = 1e-12;  // a ring that is held at its friction limit slips by that
  const double no_slip = roundoff * displacement_.cwiseAbs().maxCoeff();
  auto zones = zones_;
  for (std::size_t i = 0; i < zones.size(); ++i)
    if (slip_[static_cast<Eigen::Index>(i)] > no_slip) zones[i] |= 1;
  const auto dissipated = problem.series.integral(series_work_, zones);
  history.dissipated_energy = dissipated.value;
  history.dissipated_uncertainty = dissipated.unseen_kinks;
  history.friction_work = work_.cwiseProduct(problem.compliance.areas);
  history.traction = std::move(traction_);
  history.displacement = std::move(displacement_);
  history.indenter = std::move(indenter_);
}

double FrictionPeriod::amplitude(const Motion& motion) const {
  return motion.tangential_force ? -extremes_.value().sum() / 2 : motion.tangential_amplitude();
}

FirstSlip::FirstSlip(Eigen::Index n_rings)
    : margin_(Eigen::VectorXd::Constant(n_rings, infinity)),
      forward_(n_rings, -infinity),
      backward_(n_rings, -infinity),
      slip_path_(Eigen::VectorXd::Zero(n_rings)) {}

void FirstSlip::see(const FrictionContact& contact) {
  margin_ = margin_.cwiseMin(contact.limit - contact.traction.cwiseAbs());
  const auto step = contact.in_piece();
  forward_.add(contact.limit_depths - contact.zones.depths(), step);
  backward_.add(contact.limit_depths + contact.zones.depths(), step);
}

void FirstSlip::report(FrictionHistory& history) const {
  history.first_slip_margin = margin_;
  history.first_slip_reserve = forward_.value().cwiseMin(backward_.value());
  history.slip_path = slip_path_;
}

WatchedFriction::WatchedFriction(const ContactProblem& problem, const RelaxationModel& relaxation,
                                 double friction_coefficient, const Motion& motion, int steps_per_cycle)
    : contact(problem, relaxation, friction_coefficient, motion, steps_per_cycle),
      first_slip(problem.n_rings()),
      period(problem.n_rings(), period_steps()),
      n_steps_to_pass_(static_cast<long>(motion.cycles_of_ramp()) * steps_per_cycle - period_steps()) {}

void WatchedFriction::step(const Eigen::VectorXd& pressure, const std::optional<NormalInstant>& normal) {
  if (contact.n_steps % period_steps() == 0) {
    slip_before = period.slip();
    period.begin();
  }
  contact.step(pressure, normal);
  if (contact.n_steps <= n_steps_to_pass_)
    period.pass(contact);
  else
    period.see(contact);
  first_slip.see(contact);
  if (contact.n_steps % period_steps() == 0) {
    first_slip.see_end_of(period);
    slip_of_periods.push_back(period.slip());
  }
}

void WatchedFriction::step_beside(const NormalContact& normal) {
  const auto& series = normal.series();
  const NormalInstant instant{series.radii(), normal.reading.radius, normal.reading.force};
  if (series.is_half_space())
    step(normal.pressure, instant);
  else
    step(pressure_for_friction(series, contact.problem().series, normal.pressure, normal.reading.force), instant);
}

namespace {

/// Where slip dies out slowly everywhere, tractions hardly change from period to period long before the rings stick.
bool is_about_to_stick(const Eigen::VectorXd& before, const Eigen::VectorXd& slip, double allowed, double n_periods) {
  Eigen::Index n = 0;
  while (n < slip.size() && slip[n] <= allowed) ++n;
  if (n == slip.size() || !(slip[n] < before[n])) return false;
  return std::log(slip[n] / allowed) < n_periods * std::log(before[n] / slip[n]);
}

/// Whether any ring is about to stick, where the zones that stick need not lie around the centre.
bool any_is_about_to_stick(const Eigen::VectorXd& before, const Eigen::VectorXd& slip, double allowed,
                           double n_periods) {
  for (Eigen::Index i = 0; i < slip.size(); ++i) {
    const bool falls = slip[i] > allowed && slip[i] < before[i];
    if (falls && std::log(slip[i] / allowed) < n_periods * std::log(before[i] / slip[i])) return true;
  }
  return false;
}

constexpr int most_searches = 4;

/// Plain sums: depths of rings that touch in any order cannot be continued to an edge.
void report_sums(const Eigen::VectorXd& areas, FrictionHistory& history) {
  history.force = history.traction.transpose() * areas;
  history.force_uncertainty = Eigen::VectorXd::Zero(history.force.size());
  history.dissipated_energy = history.friction_work.sum();
  history.dissipated_uncertainty = 0;
}

}  // namespace

double slip_of_stuck_ring(const Motion& motion, double amplitude) {
  constexpr double per_amplitude_and_oscillation = 1e-4;
  if (amplitude == 0) return 0;
  const double path = tangential_path(motion) / 4;
  return per_amplitude_and_oscillation * path / motion.tangential_amplitude() * amplitude * motion.cycles_per_period();
}

namespace {

/// The way of friction to its periodic state under the repeating cycle of the normal contact, see drive_to_period.
class FrictionWay {
 public:
  FrictionWay(WatchedFriction& friction, const NormalHistory& normal, const HistoryControl& control,
              const std::function<void(const FrictionContact&)>& see, FrictionHistory& history)
      : friction_(friction),
        normal_(normal),
        control_(control),
        see_(see),
        history_(history),
        touching_{normal.touch_radii, contact().relaxation().viscosity == 0},
        forces_(contact(), touching_, friction.period_steps()),
        in_order_(normal.touches_in_order()),
        creep_(longest_creep_time(contact().relaxation()) / (2 * pi * cycles_per_period())) {}

  [[nodiscard]] Shortening shortening() const {
    const auto& motion = contact().motion();
    const bool may_search =
        creep_ >= slow_creep && motion.locked && !motion.tangential_force && !motion.is_single_pass();
    const bool has_gone_along = contact().n_steps >= normal_.n_steps();
    return {creep_, may_search ? most_searches : 0, may_search && has_gone_along};
  }

  [[nodiscard]] bool is_at_end(double periodicity) const {
    const int most_cycles = contact().motion().locked
                                ? control_.max_cycles
                                : std::max(control_.max_cycles, most_long_periods * cycles_per_period());
    if (history_.n_cycles < most_cycles) return false;
    if (repeats_) return true;
    throw SolverError(fmt::format(
        "the tangential response is not periodic after {} cycles: it will still change by {:.1e} of its largest "
        "value, {:.1e} is asked for; the body creeps for {:.3g} cycles: set the Duration of the test, so that "
        "branches slower than it are springs",
        history_.n_cycles, periodicity, control_.periodicity, creep_ * cycles_per_period()));
  }

  void step_through_period() {
    do {
      const Eigen::Index column = normal_.column(contact().n_steps + 1);
      if (in_order_) {
        friction_.step(normal_.pressure_on_friction().col(column), normal_.instant(column));
        touching_.move_to(normal_.contact_radius[column]);
        forces_.see(contact(), touching_, normal_.force[column]);
      } else {
        friction_.step(normal_.pressure.col(column));
      }
      if (see_) see_(contact());
    } while (contact().n_steps % friction_.period_steps() != 0);
    history_.n_cycles = static_cast<int>(contact().n_steps / contact().steps_per_cycle());
  }

  [[nodiscard]] bool is_single_pass() const { return contact().motion().is_single_pass(); }
  [[nodiscard]] bool is_in_start() const {
    return history_.n_cycles <= std::max(contact().motion().cycles_of_ramp(), normal_.n_cycles) + cycles_per_period();
  }
  [[nodiscard]] double change() const { return friction_.period.change(); }

  bool goes_on(double periodicity, double change) {
    const auto& motion = contact().motion();
    repeats_ = periodicity <= control_.periodicity || (motion.tangential_force && scatter_.is_all(change));
    const double allowed = slip_of_stuck_ring(motion, friction_.period.amplitude(motion));
    const auto is_about = in_order_ ? is_about_to_stick : any_is_about_to_stick;
    const bool settles = is_about(friction_.slip_before, friction_.period.slip(), allowed,
                                  static_cast<double>(history_.n_cycles) / cycles_per_period());
    return settles || !repeats_;
  }

  double search() {
    auto found = find_periodic_friction(contact(), normal_, friction_.first_slip.slip_path(),
                                        share_of_search * control_.periodicity);
    history_.n_cycles_of_search += found.n_periods * cycles_per_period();
    contact().state = std::move(found.state);
    return found.to_come;
  }
  bool jump(CycleJump& jump) { return jump.advance(contact().state, contact().displacement); }

  /// Writes the forces of the last period.
  void report_forces() const {
    if (in_order_)
      forces_.report(contact(), friction_.period.limit_depths(), history_);
    else
      report_sums(contact().problem().compliance.areas, history_);
  }

 private:
  [[nodiscard]] FrictionContact& contact() const { return friction_.contact; }
  [[nodiscard]] int cycles_per_period() const { return contact().motion().cycles_per_period(); }

  WatchedFriction& friction_;
  const NormalHistory& normal_;
  const HistoryControl& control_;
  const std::function<void(const FrictionContact&)>& see_;
  FrictionHistory& history_;
  TouchingRings touching_;
  ForcesOfPeriod forces_;
  bool in_order_;
  double creep_;  // periods
  Scatter scatter_;
  bool repeats_ = false;
};

}  // namespace

FrictionHistory friction_history(WatchedFriction friction, const NormalHistory& normal, const HistoryControl& control,
                                 const std::function<void(const FrictionContact&)>& see) {
  const auto& contact = friction.contact;
  FrictionHistory history;
  FrictionWay way(friction, normal, control, see, history);
  const auto drive = drive_to_period(way, way.shortening());
  history.periodicity = drive.periodicity;
  history.jumped = drive.moved;
  history.n_steps = contact.n_steps;
  friction.first_slip.report(history);
  friction.period.hand_over(contact.problem(), history);
  history.force_off_by_steps =
      force_off_by_sliding_ends(contact.problem().series, friction.period.depths(), friction.period.limit_depths(),
                                !contact.motion().is_single_pass());
  way.report_forces();
  history.amplitude = friction.period.amplitude(contact.motion());
  history.unseen_slip_energy =
      unseen_slip_energy(contact.problem().series, friction.period.depths(), friction.period.limit_depths());
  history.slip_of_periods = std::move(friction.slip_of_periods);
  return history;
}

ContactHistory contact_history(NormalContact normal, WatchedFriction friction, const HistoryControl& control) {
  ContactHistory history;
  const auto& series = normal.problem().series;
  history.normal =
      normal_history(std::move(normal), control, [&](const NormalContact& contact) { friction.step_beside(contact); });
  find_friction_pressure(series, friction.contact.problem().series, history.normal);
  history.friction = friction_history(std::move(friction), history.normal, control);
  return history;
}

FrictionHistory friction_at_rest(const ContactProblem& problem, double friction_coefficient,
                                 const std::vector<Eigen::VectorXd>& pressures, const NormalHistory& normal) {
  const Eigen::Index n = problem.n_rings(), n_steps = normal.steps_per_cycle;
  FrictionHistory history;
  history.first_slip_margin = Eigen::VectorXd::Constant(n, infinity);
  RunningMinimum since_start(n, -infinity), last_cycle(n, -infinity);
  const auto in_piece = [&normal](Eigen::Index k) {
    return normal.pieces.empty() ? std::nullopt : std::optional(normal.pieces[static_cast<std::size_t>(k)]);
  };
  long step = -1;
  for (const auto& pressure : pressures) {
    const Eigen::VectorXd limit = friction_coefficient * pressure;
    history.first_slip_margin = history.first_slip_margin.cwiseMin(limit);
    since_start.add(problem.series.depths(limit), in_piece(step < 0 ? 0 : step % n_steps));
    ++step;
  }
  for (Eigen::Index k = 0; k < n_steps; ++k)
    last_cycle.add(problem.series.depths(friction_coefficient * normal.pressure.col(k)), in_piece(k));
  history.n_cycles = normal.n_cycles;
  history.n_steps = normal.n_steps();
  history.shakedown_margin = friction_coefficient * normal.pressure.rowwise().minCoeff();
  history.first_slip_reserve = since_start.value();
  history.shakedown_reserve = last_cycle.value();
  history.slip_path = history.period_slip = history.friction_work = Eigen::VectorXd::Zero(n);
  history.force = history.force_uncertainty = history.force_off_by_steps = history.indenter =
      Eigen::VectorXd::Zero(n_steps);
  history.traction = history.displacement = Eigen::MatrixXd::Zero(n, n_steps);
  return history;
}

}  // namespace fretval::fem
