#pragma once

#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "mdr/rheology/modulus_table.h"
#include "mdr/rheology/rheology.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

// At least n_per_decade numbers a decade at equal steps of the logarithm, both ends included.
inline std::vector<double> log_spaced(double lowest, double highest, int n_per_decade) {
  const double decades = std::log10(highest / lowest);
  const int n_steps = static_cast<int>(std::ceil(decades * n_per_decade - 1e-9));
  std::vector<double> values;
  for (int i = 0; i <= n_steps; ++i) values.push_back(lowest * std::pow(10, decades * i / n_steps));
  return values;
}

// "Measured" moduli of a known body at log-spaced frequencies in Hz, with normal relative noise on each.
inline ModulusTable synthetic_table(const Rheology& body, double lowest, double highest, int n_per_decade,
                                    double noise = 0, unsigned seed = 3) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  ModulusTable table;
  table.frequency = log_spaced(lowest, highest, n_per_decade);
  for (const double frequency : table.frequency) {
    const std::complex<double> modulus = complex_modulus(body, 2 * pi * frequency);
    table.storage.push_back(modulus.real() * (1 + noise * normal(engine)));
    table.loss.push_back(modulus.imag() * (1 + noise * normal(engine)));
  }
  return table;
}

}  // namespace fretval::mdr
