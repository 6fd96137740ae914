#pragma once

#include <optional>
#include <ostream>

#include "fem/condensation/body_field.h"

namespace fretval::fem {

/// A body at an instant: its normal harmonic (n = 0) and, if the indenter moves tangentially, the tangential one (n =
/// 1).
struct BodyState {
  HarmonicState normal;
  std::optional<HarmonicState> tangential;
};

/// Units of a dimensionless body: of lengths in m, of displacements in m, of stresses in Pa.
struct FieldUnits {
  double length, depth, pressure;
};

/// Writes the plane y = 0 in which the indenter moves, both halves of it, in the VTU format, in SI units:
///   displacement (m)          vector
///   stress (Pa)               tensor, `G(t) * 2 eps - p I`
///   pressure (Pa)             p, positive where it presses: `-trace(stress) / 3` exactly
///   von Mises stress (Pa)
/// x is along the tangential motion, z points into the body, which fills z >= 0, and y completes them to the right
/// hand. Amplitudes of the harmonics add up at theta = 0 (x > 0), and are subtracted at theta = pi.
void write_meridian_section(const BodyState& state, const FieldUnits& units, std::ostream& stream);

}  // namespace fretval::fem
