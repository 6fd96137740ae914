#pragma once

#include "comparison/case/case.h"

namespace fretval {

/// A case over an incompressible half-space that has the same contact and the same forces as one over a half-space of
/// another Poisson's ratio, so that whatever MDR says of the one holds for the other.
///
/// MDR's springs have E* = 2 G/(1 - nu) and G* = 4 G/(2 - nu) per length. The incompressible ones, 4 G' and 8 G'/3, are
/// the same for the modulus G' = G/(2 (1 - nu)) and tangential displacements larger by 3 (1 - nu)/(2 - nu)
/// (mdr/rheology/compressible.h).
struct IncompressibleCase {
  Case input;
  double displacement = 1;  ///< tangential displacements of it over those of the case
};

/// Whether it is a layer that MDR knows: its coupled springs move in one direction.
bool is_layer_of_mdr(const Case& input);

/// The case itself where it is incompressible already, and over a layer, whose Poisson's ratio MDR knows.
IncompressibleCase incompressible_case(const Case& input);

}  // namespace fretval
