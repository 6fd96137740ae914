#include "fem/ring_contact/stick_zone/axis_pressure.h"

#include <cmath>
#include <vector>

#include "fem/motion/running_minimum.h"
#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

using Eigen::Index;

/// Rings that D(0) - D(x) ~ x^n is continued from.
struct TipRings {
  Index inner, outer;
};
constexpr TipRings of_smooth_tip{3, outermost_tip_ring}, of_pointed_tip{7, 12};

/// A pointed tip, n < 2, is continued from farther out: what its shape in the innermost rings is off by falls with the
/// power n - 1 of the rings alone, but with the fourth power of the number of the ring (at n = 1.24 and 32 rings 1.6e-4
/// of the pressure from the third and fifth ring, 1.1e-5 from these).
TipRings tip_rings(const PunchSeries& series, double contact_radius, double n) {
  return n < 2 && contact_radius > series.radii()[of_pointed_tip.outer] ? of_pointed_tip : of_smooth_tip;
}

double axis_pressure(const PunchSeries& series, const Eigen::VectorXd& depths, double contact_radius, double n) {
  const auto& x = series.radii();
  const auto [inner, outer] = tip_rings(series, contact_radius, n);
  const double at_inner = std::pow(x[inner], n), at_outer = std::pow(x[outer], n),
               bend = (depths[inner] - depths[outer]) / (at_outer - at_inner),
               on_axis = depths[inner] + bend * at_inner;
  Index n_pressed = depths.size();
  while (depths[n_pressed - 1] == 0) --n_pressed;
  Eigen::VectorXd rest = Eigen::VectorXd::Zero(n_pressed);
  for (Index i = inner; i < n_pressed; ++i) rest[i] = (on_axis - bend * std::pow(x[i], n) - depths[i]) / (x[i] * x[i]);
  const std::vector<signed char> one_zone(static_cast<std::size_t>(n_pressed), 0);
  const double of_tip = on_axis / contact_radius + bend * std::pow(contact_radius, n - 1) / (n - 1);
  return (series.force_per_radius() * of_tip + series.integral(rest, one_zone, contact_radius).value) / (2 * pi);
}

/// Pressure on the axis, continued from ring means: by the parabola through three rings, over the mean squared radii of
/// the rings.
double continued_to_axis(const PunchSeries& series, const Eigen::VectorXd& pressure) {
  constexpr Index first = 1, n = 3;  // the innermost ring is off by the shape of the tip
  double on_axis = 0;
  const auto square = [&](Index i) { return series.areas().head(i).sum() + series.areas()[i] / 2; };
  for (Index i = first; i < first + n; ++i) {
    double weight = 1;
    for (Index k = first; k < first + n; ++k)
      if (k != i) weight *= square(k) / (square(k) - square(i));
    on_axis += weight * pressure[i];
  }
  return on_axis;
}

}  // namespace

std::optional<double> axis_pressure_max(const PunchSeries& series, const Eigen::MatrixXd& pressure,
                                        const Eigen::VectorXd& contact_radius, double n,
                                        const std::vector<StepInPiece>& pieces) {
  const bool by_depths = series.is_half_space();
  const Eigen::MatrixXd depths = by_depths ? series.depths_of_instants(pressure) : pressure;
  Eigen::VectorXd samples = Eigen::VectorXd::Zero(contact_radius.size());
  for (Index k = 0; k < samples.size(); ++k)
    if (contact_radius[k] > series.radii()[of_smooth_tip.outer])
      samples[k] = by_depths ? axis_pressure(series, depths.col(k), contact_radius[k], n)
                             : continued_to_axis(series, pressure.col(k));
  if (samples.maxCoeff() == 0) return std::nullopt;
  return largest_of_period(samples, pieces);
}

}  // namespace fretval::fem
