#pragma once

#include <cstdint>

#include "comparison/verification/written_case.h"

namespace fretval {

/// Identifies a random case: the seed of the suite, the number of the case, and how many times it was drawn before
/// because the tool refused it as bad input.
struct RandomDraw {
  std::uint64_t seed;
  std::size_t number;
  int attempt = 0;
};

/// A random case, the same for the same draw on every machine. Drawn are
///
///   lengths 1 nm to 1 m, depths 1e-3 to 0.3 of the contact radius, moduli 1 mPa to 1 TPa, 1e-6 to 1e6 Hz;
///   every shape with a formula: parabola, cone, r^1.2 to r^8, rounded flat, truncated sphere;
///   every rheology but a table: branches of 0.01 to 100 G0 and omega tau = 1e-3 to 1e3, dashpots up to
///   omega eta = 10 G0, fractional orders 0.1 to 1;
///   mu = 0.01 to 10; Delta d/d0 = 0, 1e-3 to 1, 1 but for 1e-6, up to 3; any phase, 0 to 1e-6 deg, unlocked;
///   tangential amplitudes of nothing, full stick, any stick radius from 1e-4 a to (1 - 1e-6) a, the border of no stick
///   to 1e-9, gross slip;
///   limiting profiles of c/a = 0.25, 0.5 and 0.75 (one body each).
///
/// Prescribed forces, and cases that finite elements refuse by name, are not drawn.
Entries random_entries(const RandomDraw& draw);

}  // namespace fretval
