#pragma once

#include <vector>

namespace fretval::mdr {

/// `f(s) = constant + slope s + sum_i coefficients_i exp(-rates_i s)`: what a Prony body makes of a steady motion.
struct ExponentialSum {
  double constant = 0, slope = 0;
  std::vector<double> coefficients, rates;  ///< as many of each; rates positive

  [[nodiscard]] double operator()(double s) const;
};

/// An upper bound of f on [0, length] that is above its supremum by no more than `error`, which has to be positive:
/// intervals are halved until max f at their ends + K h^2/8, with K the bound of |f''| in them, is no more than that
/// above the largest value found. length positive.
double supremum(const ExponentialSum& f, double length, double error);

}  // namespace fretval::mdr
