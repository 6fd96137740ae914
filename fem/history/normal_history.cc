#include "fem/history/normal_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "fem/history/drive_to_period.h"
#include "fem/history/periodic_state.h"
#include "fem/motion/running_minimum.h"
#include "fem/ring_contact/pressure_for_friction.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

std::optional<NormalInstant> NormalHistory::instant(Eigen::Index column) const {
  if (!touches_in_order()) return {};
  NormalInstant instant{touch_radii, contact_radius[column], force[column]};
  if (pressure_depths.size() > 0)
    instant.pressure_depths.emplace(pressure_depths.col(column).data(), pressure_depths.rows());
  return instant;
}

void find_friction_pressure(const PunchSeries& normal, const PunchSeries& tangential, NormalHistory& history) {
  if (normal.is_half_space() || !history.touches_in_order()) return;
  history.friction_pressure.resizeLike(history.pressure);
  for (Eigen::Index k = 0; k < history.pressure.cols(); ++k)
    history.friction_pressure.col(k) =
        pressure_for_friction(normal, tangential, history.pressure.col(k), history.force[k]);
}

namespace {

/// Records a cycle, in the place of the one before.
class CycleRecord {
 public:
  CycleRecord(const NormalContact& contact, NormalHistory& history)
      : history_(history), gap_at_balance_(contact.pressure.size(), 0), height_(1, -infinity) {
    const Eigen::Index n = contact.steps_per_cycle();
    history.pressure = history.displacement = Eigen::MatrixXd::Zero(contact.pressure.size(), n);
    for (auto* series : {&history.time, &history.indentation, &history.force, &history.force_uncertainty,
                         &history.force_beyond, &history.force_beyond_uncertainty, &history.contact_radius})
      series->resize(n);
  }

  void begin() {
    history_.smallest_gap = Eigen::VectorXd::Constant(history_.pressure.rows(), infinity);
    gap_at_balance_.restart();
    height_.restart();
    history_.pieces.clear();
    deepest_ = -infinity;
  }

  /// Adds the start of a single pass to the record, at which the contact may be largest.
  void add_start(const NormalContact& contact) {
    history_.smallest_gap = contact.gap;
    gap_at_balance_.add(contact.balance_gap);
    height_.add(Eigen::VectorXd::Constant(1, -contact.indentation));
    history_.deepest_displacement = contact.state.displacement;
    deepest_ = contact.indentation;
  }

  void add(Eigen::Index k, const NormalContact& contact) {
    history_.time[k] = contact.time;
    history_.indentation[k] = contact.balance_indentation;
    history_.pressure.col(k) = contact.pressure;
    history_.displacement.col(k) =
        ((contact.balance_gap - contact.profile).array() + contact.balance_indentation).matrix();
    history_.force[k] = contact.reading.force;
    history_.force_uncertainty[k] = contact.reading.uncertainty;
    history_.force_beyond[k] = contact.reading.beyond.force;
    history_.force_beyond_uncertainty[k] = contact.reading.beyond.uncertainty;
    history_.contact_radius[k] = contact.reading.radius;
    history_.smallest_gap = history_.smallest_gap.cwiseMin(contact.gap);
    auto step = contact.in_piece();
    if (step) history_.pieces.push_back(*step);
    gap_at_balance_.add(contact.balance_gap, step);
    if (step) step->fraction = 1;  // the indenter is known at the end
    height_.add(Eigen::VectorXd::Constant(1, -contact.indentation), step);
    if (contact.indentation > deepest_) history_.deepest_displacement = contact.state.displacement;
    deepest_ = std::max(deepest_, contact.indentation);
  }

  void end() {
    history_.smallest_gap_at_balance =
        (history_.smallest_gap.array() > 0).select(gap_at_balance_.value(), history_.smallest_gap);
    history_.largest_indentation = -height_.value()[0];
  }

 private:
  NormalHistory& history_;
  RunningMinimum gap_at_balance_, height_;
  double deepest_ = -infinity;
};

/// The way of a normal contact to its periodic state, see drive_to_period.
class NormalWay {
 public:
  NormalWay(NormalContact& contact, const HistoryControl& control, const Beside& beside, NormalHistory& history)
      : contact_(contact),
        control_(control),
        beside_(beside),
        history_(history),
        record_(contact, history),
        creep_(longest_creep_time(contact.relaxation()) / (2 * pi)) {}

  [[nodiscard]] Shortening shortening() const {
    const bool may_search =
        creep_ >= slow_creep && !contact_.motion().normal_force && change_to_come(0, creep_) <= control_.periodicity;
    return {creep_, may_search ? 1 : 0};
  }

  [[nodiscard]] bool is_at_end(double periodicity) const {
    if (history_.n_cycles < control_.max_cycles) return false;
    throw SolverError(fmt::format(
        "the normal response is not periodic after {} cycles: it will still change by {:.1e} of its largest value, "
        "{:.1e} is asked for; the body creeps for {:.3g} cycles: set the Duration of the "
        "test, so that branches slower than it are springs",
        history_.n_cycles, periodicity, control_.periodicity, creep_));
  }

  void step_through_period() {
    before_ = history_.pressure;
    record_.begin();
    if (is_single_pass()) record_.add_start(contact_);
    for (int k = 0; k < contact_.steps_per_cycle(); ++k) {
      contact_.step();
      if (contact_.n_steps == 1) history_.first_balance = contact_.time;
      record_.add(k, contact_);
      if (beside_) beside_(contact_);
    }
    record_.end();
    ++history_.n_cycles;
  }

  [[nodiscard]] bool is_single_pass() const { return contact_.motion().is_single_pass(); }
  [[nodiscard]] bool is_in_start() const {
    return history_.n_cycles <= std::max(contact_.motion().cycles_of_ramp(), 1);
  }
  [[nodiscard]] double change() const {
    const double change = (history_.pressure - before_).cwiseAbs().maxCoeff();
    return change > 0 ? change / history_.pressure.maxCoeff() : 0;
  }
  [[nodiscard]] bool goes_on(double periodicity, double /*change*/) const {
    return !(periodicity <= control_.periodicity);
  }

  double search() {
    auto found = find_periodic_state(contact_.problem().compliance, contact_.relaxation(), Hold::closes, contact_.state,
                                     share_of_search * control_.periodicity, [this](const RingState& begin) {
                                       return period_from(begin, contact_, contact_.steps_per_cycle(),
                                                          [](NormalContact& trial) { trial.step(); });
                                     });
    contact_.state = std::move(found.state);
    history_.n_cycles_of_search = found.n_periods;
    return found.to_come;
  }
  bool jump(CycleJump& jump) { return jump.advance(contact_.state, contact_.indentation); }

 private:
  NormalContact& contact_;
  const HistoryControl& control_;
  const Beside& beside_;
  NormalHistory& history_;
  CycleRecord record_;
  double creep_;            // periods
  Eigen::MatrixXd before_;  // pressures of the cycle before
};

}  // namespace

NormalHistory normal_history(NormalContact contact, const HistoryControl& control, const Beside& beside) {
  NormalHistory history;
  history.steps_per_cycle = contact.steps_per_cycle();
  if (contact.touches_in_order()) history.touch_radii = contact.series().radii();
  NormalWay way(contact, control, beside, history);
  history.periodicity = drive_to_period(way, way.shortening()).periodicity;
  return history;
}

}  // namespace fretval::fem
