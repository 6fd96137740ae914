#pragma once

#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// A step of the last period of an answer: the column of the tangential response.
struct PeriodStep {
  const FeAnswer& fe;
  Eigen::Index column;

  [[nodiscard]] long step() const { return fe.friction.n_steps + 1 - fe.friction.traction.cols() + column; }
  [[nodiscard]] Eigen::Index normal_column() const { return fe.normal.column(step()); }
  /// From the start of the history on, at which forces balance; over the angular frequency. Along a path: from its first
  /// row on.
  [[nodiscard]] double time() const {
    if (!fe.normal.pieces.empty()) {
      const auto& step = fe.normal.pieces[static_cast<std::size_t>(normal_column())];
      return step.begin + step.fraction * step.duration();
    }
    return fe.normal.first_balance + static_cast<double>(step() - 1) * 2 * std::acos(-1.0) / fe.normal.steps_per_cycle;
  }
};

}  // namespace fretval
