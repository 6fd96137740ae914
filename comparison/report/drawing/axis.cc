#include "comparison/report/drawing/axis.h"

#include <algorithm>
#include <cmath>

#include "comparison/results/answer_text.h"

namespace fretval {

std::vector<double> Axis::of(std::vector<double> values) const {
  for (double& value : values) value /= factor;
  return values;
}

Axis axis_for(std::initializer_list<const std::vector<double>*> all, const std::string& unit) {
  double largest = 0;
  for (const auto* values : all)
    for (const double value : *values)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const auto [prefix, factor] = prefix_for(largest > 0 ? largest : 1);
  return {prefix + unit, factor};
}

std::vector<std::pair<std::string, double>> radius_marks(const StoredResult& result, const Axis& axis) {
  std::vector<std::pair<std::string, double>> marks;
  const double c = result.number("fe", "stick_radius_shakedown"), a = result.number("scene", "contact_radius_unworn");
  if (c > 0) marks.emplace_back("c", c / axis.factor);
  if (a > 0) marks.emplace_back("a", a / axis.factor);
  return marks;
}

}  // namespace fretval
