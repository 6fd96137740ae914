#include "fem/ring_contact/stick_zone/sliding_ends.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fretval::fem {
namespace {

/// Whether all rings are at their friction limit, in a step of the last period.
bool slides(double friction_coefficient, const Eigen::VectorXd& pressure, const Eigen::VectorXd& traction) {
  constexpr double roundoff = 1e-9;
  const Eigen::ArrayXd limit = friction_coefficient * pressure.array();
  return (traction.array().abs() >= limit - roundoff * limit.maxCoeff()).all();
}

}  // namespace

SlidingEnds sliding_ends(double friction_coefficient, const NormalHistory& normal, const FrictionHistory& friction,
                         const Eigen::VectorXd& along, bool repeats) {
  SlidingEnds ends;
  const auto n = friction.traction.cols();
  if (n < 3) return ends;
  std::vector<bool> sliding(static_cast<std::size_t>(n));
  Eigen::VectorXd limit(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto column = normal.column(friction.n_steps - n + k + 1);
    sliding[static_cast<std::size_t>(k)] =
        slides(friction_coefficient, normal.pressure_on_friction().col(column), friction.traction.col(k));
    limit[k] = friction_coefficient * (normal.force[column] + normal.force_beyond[column]);
  }
  const auto slides_at = [&](Eigen::Index k) { return sliding[static_cast<std::size_t>(k % n)]; };
  const Eigen::Index last = repeats ? n - 1 : n - 3;  // step before those that stick
  for (Eigen::Index k = 0; k <= last; ++k) {
    if (!slides_at(k) || slides_at(k + 1)) continue;
    const double way = friction.force[k] < 0 ? -1 : 1;
    const auto room = [&](Eigen::Index j) { return limit[j % n] - way * friction.force[j % n]; };
    const double off = std::max(0.0, room(k + 2) - 2 * room(k + 1) + room(k)) / 8;
    ends.force = std::max(ends.force, off);
    const Eigen::Index end = repeats ? k + n : n;
    for (Eigen::Index j = k + 1; j < end && !slides_at(j); ++j) {
      ends.mean_force += off / static_cast<double>(n);
      ends.work += off * std::abs(along[j % n]);
    }
  }
  return ends;
}

}  // namespace fretval::fem
