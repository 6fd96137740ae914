#include "fem/ring_contact/pressure_for_friction.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

/// Increase of the force of a punch by each ring.
double force_of_ring(const PunchSeries& series, Index i) {
  return series.punch_force(i + 1) - series.punch_force(i);
}

/// E of the depths of a pressure, in all rings before the last one that is pressed.
Eigen::VectorXd left_out(const PunchSeries& series, const Eigen::VectorXd& pressure, Index last) {
  const auto &radii = series.radii(), &edges = series.edges();
  const Eigen::VectorXd depths = series.depths(pressure);
  const auto width = [&](Index i) { return edges[i + 1] - edges[i]; };
  const auto growth = [&](Index i) { return force_of_ring(series, i) / width(i); };
  const auto between = [&](Index i) {
    return (growth(i) + growth(i + 1)) / 2 * (depths[i + 1] - depths[i]) / (radii[i + 1] - radii[i]);
  };
  Eigen::VectorXd left = Eigen::VectorXd::Zero(depths.size());
  for (Index i = 1; i < last; ++i)
    left[i] = -width(i) * width(i) / 12 * (between(i) - between(i - 1)) / (radii[i + 1] - radii[i - 1]) / growth(i);
  left[0] = left[1];
  return left;
}

}  // namespace

Eigen::VectorXd pressure_for_friction(const PunchSeries& normal, const PunchSeries& tangential,
                                      const Eigen::VectorXd& pressure, double force) {
  constexpr Index fewest_rings = 4;
  Index n_pressed = 0;
  while (n_pressed < pressure.size() && pressure[n_pressed] > 0) ++n_pressed;
  if (normal.is_half_space() || n_pressed < fewest_rings) return pressure;
  const Index last = n_pressed - 1;
  Eigen::VectorXd left = left_out(normal, pressure, last), left_by_friction = left_out(tangential, pressure, last);
  double missing = force - pressure.dot(normal.areas());
  for (Index i = 0; i < last; ++i) missing -= left[i] * force_of_ring(normal, i);
  left[last] = missing / force_of_ring(normal, last);
  left_by_friction[last] = left[last] * normal.own_traction(last) / tangential.own_traction(last);
  const Eigen::VectorXd mended = pressure + normal.tractions(left) - tangential.tractions(left_by_friction);
  Eigen::VectorXd result = pressure;
  for (Index i = 0; i < n_pressed; ++i)
    if (mended[i] > 0) result[i] = mended[i];
  return result;
}

}  // namespace fretval::fem
