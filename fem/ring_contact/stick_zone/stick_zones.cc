#include "fem/ring_contact/stick_zone/stick_zones.h"

#include <algorithm>

#include "fem/ring_contact/stick_zone/stick_radius.h"

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

EdgeRadius stick_zone(const Compliance& tangential, const Eigen::VectorXd& reserve, Eigen::Index n_stuck) {
  return stick_radius(tangential, reserve, with_reserve(reserve, n_stuck));
}

}  // namespace

StuckRings stuck_rings(const FrictionHistory& friction, const Motion& motion) {
  return {count_stuck(friction.slip_path, friction.first_slip_margin, never_slipped * friction.amplitude),
          count_stuck(friction.period_slip, friction.shakedown_margin, slip_of_stuck_ring(motion, friction.amplitude))};
}

StickZones stick_zones(const Compliance& tangential, const FrictionHistory& friction, const StuckRings& stuck) {
  return {stick_zone(tangential, friction.first_slip_reserve, stuck.first_slip),
          stick_zone(tangential, friction.shakedown_reserve, stuck.shakedown)};
}

}  // namespace fretval::fem
