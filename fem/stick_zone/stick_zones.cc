#include "fem/stick_zone/stick_zones.h"

#include <algorithm>

#include "fem/stick_zone/stick_radius.h"

namespace fretval::fem {
namespace {

constexpr double never_slipped = 1e-9;

/// Rings from the centre that stick: slip no more than allowed and never lose their grip altogether.
Eigen::Index count_stuck(const Eigen::VectorXd& slip, const Eigen::VectorXd& margin, double allowed) {
  Eigen::Index n = 0;
  while (n < slip.size() && slip[n] <= allowed && margin[n] > 0) ++n;
  return n;
}

/// Between two instants a ring may have to slip although it sticks at both. Its reserve shows that: it is a minimum
/// over time, interpolated, and it is negative.
Eigen::Index with_reserve(const Eigen::VectorXd& reserve, Eigen::Index n_stuck) {
  Eigen::Index n = 0;
  while (n < n_stuck && reserve[n] > 0) ++n;
  return n;
}

/// Whether one of the two rings after the first n loses contact; smallest: pressure of each ring.
bool ends_next_to_smallest_contact(const Eigen::VectorXd& smallest, Eigen::Index n) {
  const Eigen::Index n_next = std::min<Eigen::Index>(2, smallest.size() - n);
  return n_next > 0 && smallest.segment(n, n_next).minCoeff() <= 0;
}

EdgeRadius stick_zone(const Compliance& tangential, const Eigen::VectorXd& smallest_pressure,
                      const Eigen::VectorXd& reserve, Eigen::Index n_stuck, double exponent) {
  constexpr double anywhere = 3e-4, next_to_smallest_contact = 1e-3, if_blunt = 12.5;
  const Eigen::Index n = with_reserve(reserve, n_stuck);
  auto edge = stick_radius(tangential, reserve, n);
  if (n == 0) return edge;
  const double ring = tangential.radii[n] - tangential.radii[n - 1], relative = ring / tangential.radii[n];
  double rings = anywhere;
  if (ends_next_to_smallest_contact(smallest_pressure, n))
    rings = next_to_smallest_contact + if_blunt * std::max(exponent - 2, 0.0) * relative * relative;
  edge.uncertainty += rings * ring;
  return edge;
}

}  // namespace

StuckRings stuck_rings(const FrictionHistory& friction, const Motion& motion) {
  return {count_stuck(friction.slip_path, friction.first_slip_margin, never_slipped * friction.amplitude),
          count_stuck(friction.period_slip, friction.shakedown_margin, slip_of_stuck_ring(motion, friction.amplitude))};
}

StickZones stick_zones(const Compliance& tangential, const NormalHistory& normal, const FrictionHistory& friction,
                       const StuckRings& stuck, double exponent) {
  const Eigen::VectorXd smallest_in_cycle = normal.pressure.rowwise().minCoeff();
  return {stick_zone(tangential, normal.smallest_pressure, friction.first_slip_reserve, stuck.first_slip, exponent),
          stick_zone(tangential, smallest_in_cycle, friction.shakedown_reserve, stuck.shakedown, exponent)};
}

}  // namespace fretval::fem
