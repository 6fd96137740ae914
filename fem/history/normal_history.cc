#include "fem/history/normal_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "fem/history/cycle_jump.h"
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

double change_per_cycle(const Eigen::MatrixXd& now, const Eigen::MatrixXd& before) {
  const double change = (now - before).cwiseAbs().maxCoeff();
  return change > 0 ? change / now.maxCoeff() : 0;
}

PeriodicState search(const NormalContact& contact, double periodicity) {
  return find_periodic_state(contact.problem().compliance, contact.relaxation(), Hold::closes, contact.state,
                             share_of_search * periodicity, [&contact](const RingState& begin) {
                               return period_from(begin, contact, contact.steps_per_cycle(),
                                                  [](NormalContact& trial) { trial.step(); });
                             });
}

}  // namespace

NormalHistory normal_history(NormalContact contact, const HistoryControl& control, const Beside& beside) {
  const int n_steps = contact.steps_per_cycle();
  NormalHistory history;
  history.steps_per_cycle = n_steps;
  history.periodicity = infinity;
  if (contact.touches_in_order()) history.touch_radii = contact.problem().series.radii();
  CycleRecord record(contact, history);
  const double creep = longest_creep_time(contact.relaxation()) / (2 * pi);
  CycleJump jump(creep);
  bool jumped = false, may_search = creep >= slow_creep && !contact.motion().normal_force &&
                                    change_to_come(0, creep) <= control.periodicity;
  double to_come = infinity;  // as a search found
  while (jumped || !(history.periodicity <= control.periodicity)) {
    if (history.n_cycles >= control.max_cycles)
      throw SolverError(fmt::format(
          "the normal response is not periodic after {} cycles: it will still change by {:.1e} of its largest value, "
          "{:.1e} is asked for; the body creeps for {:.3g} cycles: set the Duration of the "
          "test, so that branches slower than it are springs",
          history.n_cycles, history.periodicity, control.periodicity, creep));
    const Eigen::MatrixXd before = history.pressure;
    record.begin();
    if (contact.motion().is_single_pass()) record.add_start(contact);
    for (int k = 0; k < n_steps; ++k) {
      contact.step();
      if (contact.n_steps == 1) history.first_balance = contact.time;
      record.add(k, contact);
      if (beside) beside(contact);
    }
    record.end();
    ++history.n_cycles;
    if (contact.motion().is_single_pass()) {
      history.periodicity = 0;
      break;
    }
    const bool after_jump = std::exchange(jumped, false);
    if (history.n_cycles <= std::max(contact.motion().cycles_of_ramp(), 1)) continue;
    if (!after_jump) {
      const double change = change_per_cycle(history.pressure, before);
      history.periodicity = std::min(change_to_come(change, creep), std::max(change, to_come));
    }
    if (history.periodicity <= control.periodicity) continue;
    if (after_jump && to_come < infinity) continue;  // a search is followed by two plain cycles
    if (std::exchange(may_search, false)) {
      auto found = search(contact, control.periodicity);
      contact.state = std::move(found.state);
      to_come = found.to_come;
      history.n_cycles_of_search = found.n_periods;
      jumped = true;
    } else {
      to_come = infinity;
      jumped = jump.advance(contact.state, contact.indentation);
    }
  }
  return history;
}

}  // namespace fretval::fem
