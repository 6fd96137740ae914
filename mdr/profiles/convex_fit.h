#pragma once

#include <vector>

#include "mdr/support/piecewise_cubic.h"

namespace fretval::mdr {

/// Convex profile fitted to measured heights, and what it leaves of them.
struct ConvexFit {
  PiecewiseCubic height;  ///< f(r) in m on 0 <= r <= last row, f(0) = 0, twice continuously differentiable
  double offset;          ///< height of the tip in the table, m
  double residual_rms;    ///< m
  double worst_residual;  ///< row less fit where they differ most, m
  double worst_radius;    ///< where that is, m
};

/// Least-squares fit of
///
///   f(r) = offset + s r + int_0^r (r - t) f''(t) dt,   f'' a continuous broken line,   s >= 0, f'' >= 0
///
/// to the rows (r, f) in m, whose heights scatter independently with the standard deviation noise > 0 in m. A convex
/// f has a rising image g, so MDR holds for it. f'' bends at knots between rows: first at none but the ends; then,
/// while residuals keep one sign for too long somewhere or are too large as a whole, the intervals there are halved by
/// number of rows, and narrowed around single rows for the sake of kinks. The tip is horizontal, s = 0, unless that
/// leaves such residuals; if s is below a hundredth of the steepest slope, unless it does with more knots as well. A
/// run of m residuals is one-sided beyond chance when its sum exceeds (2 + sqrt(2 log n)) sqrt(m) noise, which less
/// than one table of pure noise in a thousand has. The least-squares problem is that of
/// mdr/support/non_negative_least_squares.h.
///
/// Errors of f, g, contact radius and force fall with 1/sqrt(n) where f'' is a straight line, and more slowly where it
/// takes knots. A noise stated too small goes unnoticed if the rows are so few that they are convex as they scatter.
///
/// At least 8 and at most 100000 rows; the first may lie off the axis. Throws std::invalid_argument for bad rows or
/// noise, and for heights that no convex profile meets within the noise, or with residuals of more than 1.5 times its
/// rms; the message says where and by how much. Noise below 1e-10 of the range of heights is taken as that. A kink is
/// rounded over at least 1e-6 of the last radius, which noise below 1e-6 of the heights may show.
ConvexFit convex_fit(const std::vector<double>& r, const std::vector<double>& f, double noise);

}  // namespace fretval::mdr
