#include "fem/history/friction_search.h"

#include <vector>

#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

void step_under(FrictionContact& contact, const NormalHistory& normal) {
  const Eigen::Index column = normal.column(contact.n_steps + 1);
  contact.step(normal.pressure_on_friction().col(column), normal.instant(column));
}

/// Puts back the rings that have never slipped. Returns whether there were any; without a ring that has not slipped in
/// the search there is no memory to give them.
bool put_back_unslipped(const RingState& before, const Eigen::VectorXd& slip_path, RingState& found) {
  Eigen::Index like = -1;
  std::vector<Eigen::Index> moved;
  for (Eigen::Index i = 0; i < slip_path.size(); ++i) {
    if (slip_path[i] > 0) continue;
    if (found.displacement[i] != before.displacement[i])
      moved.push_back(i);
    else if (like < 0)
      like = i;
  }
  if (like < 0) return false;
  for (const Eigen::Index i : moved) {
    found.displacement[i] = before.displacement[i];
    found.memory.row(i) = found.memory.row(like);
  }
  return !moved.empty();
}

}  // namespace

PeriodicState find_periodic_friction(const FrictionContact& contact, const NormalHistory& normal,
                                     const Eigen::VectorXd& slip_path, double tolerance) {
  const int n_steps = contact.steps_per_cycle() * contact.motion().cycles_per_period();
  const auto step = [&normal](FrictionContact& trial) { step_under(trial, normal); };
  auto found =
      find_periodic_state(contact.problem().compliance, contact.relaxation(), Hold::sticks, contact.state, tolerance,
                          [&](const RingState& begin) { return period_from(begin, contact, n_steps, step); });
  if (put_back_unslipped(contact.state, slip_path, found.state)) found.to_come = infinity;
  return found;
}

}  // namespace fretval::fem
