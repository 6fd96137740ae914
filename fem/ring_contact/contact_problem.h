#pragma once

#include <utility>

#include "fem/condensation/compliance.h"
#include "fem/ring_contact/box_solver.h"
#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// A contact line with its compliance factored for contact (or friction) steps. Copies share one compliance matrix and
/// one factor of it.
struct ContactProblem {
  Compliance compliance;
  BoxSolver solver;
  PunchSeries series;

  /// slack: see BoxSolver.
  explicit ContactProblem(Compliance c, double slack = 1e-13)
      : compliance(std::move(c)),
        solver(compliance.matrix, slack),
        series(compliance, solver.factor(), solver.inverse()) {}
  [[nodiscard]] Eigen::Index n_rings() const { return compliance.areas.size(); }
};

}  // namespace fretval::fem
