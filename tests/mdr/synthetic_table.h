#pragma once

#include <cmath>
#include <complex>
#include <random>

#include "mdr/modulus_table.h"
#include "mdr/rheology.h"

namespace fretval::mdr {

inline const double two_pi = 2 * std::acos(-1.0);

// "Measured" moduli of a known body at equal steps of log frequency, with normal relative noise on each.
inline ModulusTable synthetic_table(const Rheology& body, double lowest, double highest, int n_per_decade,
                                    double noise = 0, unsigned seed = 3) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  const double decades = std::log10(highest / lowest);
  const int n = static_cast<int>(std::lround(decades * n_per_decade));
  ModulusTable table;
  for (int i = 0; i <= n; ++i) {
    table.frequency.push_back(lowest * std::pow(10, decades * i / n));
    const std::complex<double> modulus = complex_modulus(body, two_pi * table.frequency.back());
    table.storage.push_back(modulus.real() * (1 + noise * normal(engine)));
    table.loss.push_back(modulus.imag() * (1 + noise * normal(engine)));
  }
  return table;
}

}  // namespace fretval::mdr
