#include "comparison/simulation/bodies/normal_store.h"

#include "comparison/support/stopwatch.h"
#include "fem/ring_contact/pressure_for_friction.h"

namespace fretval {
namespace {

/// What a normal history depends on beside its body. Of the tangential motion that is the frequencies alone: the
/// slowest oscillation of either direction sets the ramp.
std::vector<std::vector<double>> parameters_of(const FemCase& fem, const Eigen::VectorXd& profile,
                                               const fem::HistoryControl& control) {
  const auto& [relaxed, moduli, times, viscosity] = fem.relaxation;
  std::vector<double> normal, orders;
  for (const auto& [amplitude, order, phase, across] : fem.motion.normal)
    normal.insert(normal.end(), {amplitude, static_cast<double>(order), phase});
  for (const auto& oscillation : fem.motion.tangential) orders.push_back(oscillation.order);
  if (const auto& path = fem.motion.path) {
    orders.insert(orders.end(), path->time.begin(), path->time.end());
    normal.insert(normal.end(), path->normal.begin(), path->normal.end());
    normal.push_back(path->repeats ? 1 : 0);
  }
  return {{profile.begin(), profile.end()},
          {relaxed, viscosity, fem.kind == ContactKind::annuli ? 1.0 : 0.0},
          moduli,
          times,
          {fem.motion.indentation, static_cast<double>(fem.motion.n_ramp_cycles), fem.motion.normal_force ? 1.0 : 0.0},
          normal,
          orders,
          {static_cast<double>(control.steps_per_cycle), static_cast<double>(control.max_cycles), control.periodicity}};
}

NormalRecord make_record(const FemCase& fem, const fem::ContactProblem& problem, const fem::PunchSeries* friction,
                         const Eigen::VectorXd& profile, const fem::HistoryControl& control) {
  Stopwatch watch;
  std::optional<Eigen::Index> n_inside_flank;
  if (fem.worn_edge && fem.worn_edge->inner > 0)
    n_inside_flank = fem::rings_within(problem.compliance, fem.worn_edge->inner);
  fem::NormalContact start(
      problem, fem.relaxation, profile, fem.motion, control.steps_per_cycle,
      fem.kind == ContactKind::annuli ? fem::ForceReading::sum_of_rings : fem::ForceReading::up_to_the_edge,
      n_inside_flank);
  NormalRecord record;
  const auto add = [&record](const fem::NormalContact& contact) {
    record.pressures.push_back(contact.pressure);
    record.radii.push_back(contact.reading.radius);
    record.forces.push_back(contact.reading.force);
  };
  add(start);
  record.history = fem::normal_history(std::move(start), control, add);
  if (friction) {
    if (!n_inside_flank) fem::find_friction_pressure(problem.series, *friction, record.history);
    if (record.history.friction_pressure.size() > 0)
      for (std::size_t k = 0; k < record.pressures.size(); ++k)
        record.pressures[k] =
            fem::pressure_for_friction(problem.series, *friction, record.pressures[k], record.forces[k]);
    for (const auto& pressure : record.pressures) record.depths.push_back(friction->depths(pressure));
    record.history.pressure_depths = friction->depths_of_instants(record.history.pressure_on_friction());
  }
  record.seconds = watch.lap();
  return record;
}

}  // namespace

fem::NormalInstant NormalRecord::instant(std::size_t step) const {
  fem::NormalInstant instant{history.touch_radii, radii[step], forces[step]};
  if (!depths.empty()) instant.pressure_depths.emplace(depths[step].data(), depths[step].size());
  return instant;
}

std::shared_ptr<const NormalRecord> NormalStore::find_or_make(const FemCase& fem, const fem::ContactProblem& problem,
                                                              const fem::PunchSeries* friction,
                                                              const Eigen::VectorXd& profile,
                                                              const fem::HistoryControl& control) {
  const Key key{fem.body, parameters_of(fem, profile, control)};
  return records_.find_or_make(key, [&] {
    auto record = make_record(fem, problem, friction, profile, control);
    const auto n_vectors = record.pressures.size() + record.depths.size();
    make_room_for(key, n_vectors * static_cast<std::size_t>(profile.size()));
    return record;
  });
}

void NormalStore::make_room_for(const Key& key, std::size_t n_numbers) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (n_numbers_ += n_numbers; n_numbers_ > room_ && !kept_.empty(); kept_.pop_front()) {
    n_numbers_ -= kept_.front().second;
    records_.forget(kept_.front().first);
  }
  kept_.emplace_back(key, n_numbers);
}

}  // namespace fretval
