#pragma once

#include <Eigen/Dense>

namespace fretval::fem {

/// Between which values the largest one of a periodic signal lies.
struct PeakBounds {
  double least, most;
};

/// Bounds from equally spaced samples of one period, at least six. Where the samples around the largest one are smooth
/// they are what the quartic through five of them and the parabola through three say (SampledMinimum). Elsewhere the
/// signal bends nearby, as where a contact that slides begins to stick, and the peak is no less than the largest
/// sample. If it bends within one of the steps beside that, the peak is no more than either the parabola through the
/// three samples before such a step or that through the three after it says within the step: one of the two holds on
/// each side of the bend, and the other one rises above it. If it bends a step farther away, the peak is that of the
/// parabola through the largest sample and its two neighbours. Which of the two is not known, and the larger one is the
/// bound.
PeakBounds peak_bounds(const Eigen::VectorXd& samples);

}  // namespace fretval::fem
