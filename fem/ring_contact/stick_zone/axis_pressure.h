#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "fem/motion/sampled_path.h"
#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// Outermost of the rings from whose depths or pressures the pressure on the axis is continued, under a smooth tip.
constexpr Eigen::Index outermost_tip_ring = 5;

/// The largest pressure on the axis, p(0, t), in a period. Under a flat punch the pressure on the axis is F/(2 pi a^2),
/// under a superposition of punches
///
///   p(0) = k/(2 pi) (D(0)/a + int_0^a (D(0) - D(x))/x^2 dx),
///
/// D the depths and k the force per radius of a PunchSeries, a the contact radius. It is smooth while the edge crosses
/// a ring, which the pressure of the innermost ring is not (5e-6 and 2e-4 of Hertz's at 32 rings). The innermost depths
/// are off by the shape of the tip, so D(0) - D(x) ~ x^n of an indenter f ~ r^n, n > 1, is continued to the axis from
/// two rings beyond them (farther out for n < 2), and what is left of it integrated up to the edge. On another body
/// than a half-space no such formula is known, and the pressure of the innermost rings is continued to the axis as an
/// even polynomial. pressure: rings x instants of a period; contact_radius: at those instants; n: exponent of the tip;
/// pieces: of their steps along a path, empty for cosines. Instants at which the contact has too few rings for this do
/// not count; the result is empty if it always has.
std::optional<double> axis_pressure_max(const PunchSeries& series, const Eigen::MatrixXd& pressure,
                                        const Eigen::VectorXd& contact_radius, double n,
                                        const std::vector<StepInPiece>& pieces = {});

}  // namespace fretval::fem
