#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "mdr/rheology/prony_body.h"

namespace fretval {

/// Moduli of the standard solid G = 1 MPa, G1 = 1 MPa, tau = 0.1 s from 1e-4 to 1e4 Hz; the loss moduli times a
/// factor.
inline std::string standard_solid_table(double loss_factor = 1) {
  std::string table = "f,G',G''\nHz,MPa,MPa\n";
  for (int k = -40; k <= 40; ++k) {
    const double f = std::pow(10.0, k / 10.0);
    const auto modulus = mdr::complex_modulus(mdr::standard_solid(1, 1, 0.1), 2 * std::acos(-1.0) * f);
    table += std::to_string(f) + "," + std::to_string(modulus.real()) + "," +
             std::to_string(std::max(1e-6, loss_factor * modulus.imag())) + "\n";
  }
  return table;
}

}  // namespace fretval
