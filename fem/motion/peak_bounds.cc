#include "fem/motion/peak_bounds.h"

#include <algorithm>

#include "fem/motion/sampled_minimum.h"

namespace fretval::fem {
namespace {

/// Largest value in [from, from + 1] of the parabola through three samples at 0, 1 and 2.
double largest_of_parabola(double y0, double y1, double y2, double from) {
  const double bend = y2 - 2 * y1 + y0, slope = (y2 - y0) / 2;
  const auto at = [&](double x) { return y1 + slope * (x - 1) + bend / 2 * (x - 1) * (x - 1); };
  const double vertex = bend < 0 ? std::clamp(1 - slope / bend, from, from + 1) : from;
  return std::max({at(from), at(from + 1), at(vertex)});
}

}  // namespace

PeakBounds peak_bounds(const Eigen::VectorXd& samples) {
  const Eigen::Index n = samples.size();
  Eigen::Index largest = 0;
  samples.maxCoeff(&largest);
  const auto at = [&](Eigen::Index steps_on) { return samples[(largest + steps_on + n) % n]; };
  const SampledMinimum of_negative(-at(-2), -at(-1), -at(0), -at(1), -at(2));
  if (of_negative.smooth()) {
    const auto [least, most] = std::minmax({-of_negative.minimum_of_quartic(), -of_negative.vertex_of_parabola()});
    return {least, most};
  }
  double most = std::max(at(0), -of_negative.vertex_of_parabola());
  for (const Eigen::Index begin : {-1, 0})
    most = std::max(most, std::min(largest_of_parabola(at(begin - 2), at(begin - 1), at(begin), 2),
                                   largest_of_parabola(at(begin + 1), at(begin + 2), at(begin + 3), -1)));
  return {at(0), most};
}

}  // namespace fretval::fem
