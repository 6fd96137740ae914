#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace fretval::fem {

/// Observed order of convergence: least-squares slope of log2 of the errors, one per halving of the step.
inline double observed_order(const std::vector<double>& errors) {
  const double middle = (static_cast<double>(errors.size()) - 1) / 2;
  double product = 0, square = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = static_cast<double>(i) - middle;
    product -= x * std::log2(std::abs(errors[i]));
    square += x * x;
  }
  return product / square;
}

}  // namespace fretval::fem
