#pragma once

#include <cmath>
#include <vector>

#include "comparison/simulation/fe_answer.h"
#include "comparison/support/constants.h"
#include "fem/condensation/revolved_surface.h"

namespace fretval {

/// A step of the last period of an answer, by its column in the tangential response.
struct PeriodStep {
  const FeAnswer& fe;
  Eigen::Index column;

  [[nodiscard]] long step() const { return fe.friction.n_steps + 1 - fe.friction.traction.cols() + column; }
  [[nodiscard]] Eigen::Index normal_column() const { return fe.normal.column(step()); }
  /// Dimensionless time at which forces balance in the step, from the start of the history on, or from the first row of
  /// a path on; s when divided by the angular frequency.
  [[nodiscard]] double time() const {
    if (!fe.normal.pieces.empty()) {
      const auto& step = fe.normal.pieces[static_cast<std::size_t>(normal_column())];
      return step.begin + step.fraction * step.duration();
    }
    return fe.normal.first_balance + static_cast<double>(step() - 1) * 2 * pi / fe.normal.steps_per_cycle;
  }
};

/// Columns of the last period at the ends of n equal parts of it, up to its end. Of equal steps, of which there may be
/// fewer than n, each column occurs once; along a path they are the columns of the steps that hold these instants.
inline std::vector<Eigen::Index> columns_at_equal_times(const FeAnswer& fe, Eigen::Index n) {
  const Eigen::Index n_all = fe.friction.traction.cols();
  std::vector<Eigen::Index> columns;
  if (fe.normal.pieces.empty()) {
    for (Eigen::Index i = 1; i <= std::min(n, n_all); ++i) columns.push_back(i * n_all / std::min(n, n_all) - 1);
    return columns;
  }
  constexpr double roundoff = 1e-9;
  Eigen::Index column = 0;
  for (Eigen::Index i = 1; i <= n; ++i) {
    const double end = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
    while (column + 1 < n_all && fe.normal.pieces[static_cast<std::size_t>(column)].end < end - roundoff) ++column;
    columns.push_back(column);
  }
  return columns;
}

/// What a ring does: it slips if its traction is at the friction limit, to roundoff.
inline fem::RingZone zone_of(double pressure, double traction, double friction_coefficient) {
  constexpr double roundoff = 1e-9;
  if (pressure <= 0) return fem::RingZone::open;
  if (std::abs(traction) < friction_coefficient * pressure * (1 - roundoff)) return fem::RingZone::sticks;
  return traction > 0 ? fem::RingZone::slips_forward : fem::RingZone::slips_backward;
}

}  // namespace fretval
