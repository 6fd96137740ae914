#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "comparison/results/results_folder.h"

namespace fretval {

/// A unit with the prefix that suits what is drawn in it.
struct Axis {
  std::string unit;   ///< with its prefix, "mm"
  double factor = 1;  ///< of the prefix
  [[nodiscard]] std::vector<double> of(std::vector<double> values) const;
};

/// The axis whose prefix suits the largest of all values. unit: in SI, "m".
Axis axis_for(std::initializer_list<const std::vector<double>*> all, const std::string& unit);

/// Radii that a plot over r marks: c and a.
std::vector<std::pair<std::string, double>> radius_marks(const StoredResult& result, const Axis& axis);

}  // namespace fretval
