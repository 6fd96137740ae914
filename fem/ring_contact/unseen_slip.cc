#include "fem/ring_contact/unseen_slip.h"

#include <algorithm>

namespace fretval::fem {
namespace {

Eigen::Index n_in_contact(const Eigen::VectorXd& limits) {
  Eigen::Index n = 0;
  while (n < limits.size() && limits[n] > 0) ++n;
  return n;
}

/// That of an oscillation whose tractions are largest at one instant.
double energy_beyond(const PunchSeries& series, const Eigen::VectorXd& depths, const Eigen::VectorXd& limits,
                     Eigen::Index n) {
  const Eigen::Index last = n - 1, before = n - 2;
  const double limit = limits[last], limit_falls = limits[before] - limit;
  if (limit_falls <= 0) return 0;
  const double edge = limit / limit_falls;  // rings from the last one
  const double way = depths[last] < 0 ? -1 : 1;
  const double room = limit - way * depths[last], room_falls = limits[before] - way * depths[before] - room;
  const double lacking = edge * room_falls - room;  // at the edge
  if (lacking <= 0) return 0;
  const double start = room / room_falls;
  const double force = (edge - start) * (series.punch_force(n) - series.punch_force(last));
  return 2.0 / 3 * (limit - start * limit_falls) * lacking * force;
}

}  // namespace

double unseen_slip_energy(const PunchSeries& series, const Eigen::MatrixXd& depths,
                          const Eigen::MatrixXd& limit_depths) {
  if (limit_depths.cols() == 0) return 0;
  const Eigen::Index n = n_in_contact(limit_depths.col(0));
  double most = 0;
  for (Eigen::Index k = 0; k < depths.cols(); ++k) {
    const Eigen::VectorXd limits = limit_depths.col(k), depth = depths.col(k);
    if (n < 2 || n_in_contact(limits) != n || (depth.head(n).array().abs() >= limits.head(n).array()).any()) return 0;
    most = std::max(most, energy_beyond(series, depth, limits, n));
  }
  return most;
}

}  // namespace fretval::fem
