#include "fem/stick_zone/axis_pressure.h"

#include <cmath>

#include "fem/history/running_minimum.h"
#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

using Eigen::Index;

/// Rings that D(0) - D(x) ~ x^n is continued from.
constexpr Index inner = 3, outer = 5;

double axis_pressure(const PunchSeries& series, const Eigen::VectorXd& depths, double contact_radius, double n) {
  const auto &x = series.radii(), &edges = series.edges();
  const double at_inner = std::pow(x[inner], n), at_outer = std::pow(x[outer], n),
               bend = (depths[inner] - depths[outer]) / (at_outer - at_inner),
               on_axis = depths[inner] + bend * at_inner;
  double sum = bend * std::pow(edges[inner], n - 1) / (n - 1);
  Index n_pressed = depths.size();
  while (depths[n_pressed - 1] == 0) --n_pressed;
  // The outermost one reaches to the end of the contact, inside its ring or outside of it.
  for (Index i = inner; i < n_pressed; ++i)
    sum += (on_axis - depths[i]) / (x[i] * x[i]) * ((i + 1 < n_pressed ? edges[i + 1] : contact_radius) - edges[i]);
  return series.force_per_radius() / (2 * pi) * (on_axis / contact_radius + sum);
}

}  // namespace

std::optional<double> axis_pressure_max(const PunchSeries& series, const NormalHistory& normal, double n) {
  const auto& contact_radius = normal.contact_radius;
  const Eigen::MatrixXd depths = series.depths(normal.pressure);
  Eigen::VectorXd samples = Eigen::VectorXd::Zero(contact_radius.size());
  for (Index k = 0; k < samples.size(); ++k)
    if (contact_radius[k] > series.radii()[outer])
      samples[k] = axis_pressure(series, depths.col(k), contact_radius[k], n);
  if (samples.maxCoeff() == 0) return std::nullopt;
  return largest_of_period(samples, normal.pieces);
}

}  // namespace fretval::fem
