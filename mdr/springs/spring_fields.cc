#include "mdr/springs/spring_fields.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

// Linear between the springs, from the axis to the end of the bed, where it has the given value.
PiecewiseCubic linear(const SpringBed& bed, const Eigen::ArrayXd& values, double at_end) {
  const Eigen::Index n = values.size();
  PiecewiseCubic result;
  std::vector<double> y{values[0]};
  result.nodes.push_back(0);
  for (Eigen::Index j = 0; j < n; ++j) {
    result.nodes.push_back(bed.position[j]);
    y.push_back(values[j]);
  }
  result.nodes.push_back(bed.position[n - 1] + bed.width[n - 1] / 2);
  y.push_back(at_end);
  for (std::size_t k = 0; k + 1 < y.size(); ++k)
    result.coefficients.push_back({y[k], (y[k + 1] - y[k]) / (result.nodes[k + 1] - result.nodes[k]), 0, 0});
  return result;
}

PiecewiseCubic load_slope(const SpringBed& bed, const Eigen::ArrayXd& load, double stiffness) {
  return derivative(linear(bed, -stiffness / pi * load, 0));
}

double stress(const PiecewiseCubic& load_slope, double r) {
  require_non_negative("radial coordinate r", r);
  const double end = load_slope.nodes.back();
  return r < end ? abel_integral_above(load_slope, r, end) : 0;
}

double displacement(const PiecewiseCubic& springs, double r) {
  require_non_negative("radial coordinate r", r);
  if (r == 0) return value(springs, 0);
  return 2 / pi * abel_integral_below(springs, 0, std::min(r, springs.nodes.back()), r);
}

}  // namespace

SpringFields spring_fields(const SpringBed& bed, const PronyBody& body, const SpringState& state) {
  const Eigen::Index last = bed.depth.size() - 1;
  return {load_slope(bed, state.normal_load, 4 * body.relaxed_modulus),
          load_slope(bed, state.tangential_load, 8.0 / 3 * body.relaxed_modulus),
          linear(bed, state.normal_depth, state.normal_depth[last]),
          linear(bed, state.tangential_shift, state.tangential_shift[last])};
}

double pressure(const SpringFields& fields, double r) {
  return stress(fields.normal_load_slope, r);
}

double traction(const SpringFields& fields, double r) {
  return stress(fields.tangential_load_slope, r);
}

double normal_displacement(const SpringFields& fields, double r) {
  return displacement(fields.normal_depth, r);
}

double tangential_displacement(const SpringFields& fields, double r) {
  return displacement(fields.tangential_shift, r);
}

}  // namespace fretval::mdr
