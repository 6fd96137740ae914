#include "fem/ring_contact/unseen_slip.h"

#include <algorithm>

namespace fretval::fem {
namespace {

/// How many values come before the first one of a kind.
template <class Kind>
Eigen::Index n_before(const Eigen::VectorXd& values, const Kind& is_of_kind) {
  return std::find_if(values.begin(), values.end(), is_of_kind) - values.begin();
}

/// Values of two neighbouring rings, continued linearly. Rings are counted from the centre.
struct Line {
  Eigen::Index ring;
  double value, falls;

  Line(const Eigen::VectorXd& values, Eigen::Index last)
      : ring(last), value(values[last]), falls(values[last - 1] - values[last]) {}
  [[nodiscard]] double at(double x) const { return value - (x - static_cast<double>(ring)) * falls; }
  [[nodiscard]] double root() const { return static_cast<double>(ring) + value / falls; }
};

/// That of an oscillation whose tractions are largest at one instant. n: rings in contact, of which n_stuck stick.
double energy_beyond(const PunchSeries& series, const Eigen::VectorXd& depths, const Eigen::VectorXd& limits,
                     Eigen::Index n, Eigen::Index n_stuck) {
  const Line limit(limits, n - 1);
  if (limit.falls <= 0) return 0;
  const double way = depths[n_stuck - 1] < 0 ? -1 : 1;
  const Line room(limits - way * depths, n_stuck - 1);
  const double edge = limit.root(), lacking = -room.at(edge);
  if (lacking <= 0) return 0;
  const double start = room.root();
  const double force = (edge - start) * (series.punch_force(n) - series.punch_force(n - 1));
  return 2.0 / 3 * limit.at(start) * lacking * force;
}

}  // namespace

double unseen_slip_energy(const PunchSeries& series, const Eigen::MatrixXd& depths,
                          const Eigen::MatrixXd& limit_depths) {
  constexpr Eigen::Index most_slipping = 1;
  double most = 0;
  for (Eigen::Index k = 0; k < depths.cols(); ++k) {
    const Eigen::VectorXd limits = limit_depths.col(k), depth = depths.col(k);
    const Eigen::Index n = n_before(limits, [](double limit) { return limit <= 0; });
    const Eigen::Index n_stuck = n_before((limits - depth.cwiseAbs()).head(n), [](double room) { return room <= 0; });
    if (n_stuck < 2 || n - n_stuck > most_slipping) return 0;
    most = std::max(most, energy_beyond(series, depth, limits, n, n_stuck));
  }
  return most;
}

}  // namespace fretval::fem
