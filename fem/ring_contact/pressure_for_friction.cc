#include "fem/ring_contact/pressure_for_friction.h"

namespace fretval::fem {

using Eigen::Index;

Eigen::VectorXd pressure_for_friction(const PunchSeries& normal, const PunchSeries& tangential,
                                      const Eigen::VectorXd& pressure, double force) {
  constexpr Index fewest_rings = 4;  // with less, forces are sums
  Index n_pressed = 0;
  while (n_pressed < pressure.size() && pressure[n_pressed] > 0) ++n_pressed;
  if (normal.is_half_space() || n_pressed < fewest_rings) return pressure;
  const Index last = n_pressed - 1;
  Eigen::VectorXd left_out = Eigen::VectorXd::Zero(pressure.size());
  left_out[last] = (force - pressure.dot(normal.areas())) / (normal.punch_force(n_pressed) - normal.punch_force(last));
  const double by_friction = normal.own_traction(last) / tangential.own_traction(last);
  const Eigen::VectorXd mended = pressure + normal.tractions(left_out) - tangential.tractions(by_friction * left_out);
  Eigen::VectorXd result = pressure;
  for (Index i = 0; i < n_pressed; ++i)
    if (mended[i] > 0) result[i] = mended[i];
  return result;
}

}  // namespace fretval::fem
