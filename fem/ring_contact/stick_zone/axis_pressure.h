#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "fem/motion/sampled_path.h"
#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// The largest pressure on the axis, p(0, t), in a period. Of a flat punch it is F/(2 pi a^2), of their superposition
///
///   p(0) = k/(2 pi) (D(0)/a + int_0^a (D(0) - D(x))/x^2 dx),
///
/// D the depths and k the force per radius of a PunchSeries, a where the contact ends: smooth while an edge crosses its
/// ring, which the pressure of the innermost ring is not (5e-6 and 2e-4 of Hertz's at 32 rings). The innermost depths
/// are off by the shape of the tip, so D(0) - D(x) ~ x^n of an indenter f ~ r^n, n > 1, is continued to the axis from
/// two rings beyond them, and what is left of it integrated up to the edge. On another body than a half-space no such
/// formula is known, and the pressure of the innermost rings is continued to the axis as an even polynomial. pressure:
/// rings x instants of a period; contact_radius: of those instants; pieces: of their steps along a path, empty of
/// cosines. A contact too small for all that does not count; empty: it always is.
std::optional<double> axis_pressure_max(const PunchSeries& series, const Eigen::MatrixXd& pressure,
                                        const Eigen::VectorXd& contact_radius, double n,
                                        const std::vector<StepInPiece>& pieces = {});

}  // namespace fretval::fem
