#pragma once

#include "comparison/case/case.h"

namespace fretval {

/// A case over an incompressible half-space that has the same contact and the same forces as one over a half-space of
/// another Poisson's ratio, so that MDR's answer to the one holds for the other.
///
/// MDR's springs have E* = 2 G/(1 - nu) and G* = 4 G/(2 - nu) per length. The incompressible ones, 4 G' and 8 G'/3, are
/// the same for the modulus G' = G/(2 (1 - nu)) and tangential displacements larger by 3 (1 - nu)/(2 - nu)
/// (mdr/rheology/compressible.h).
struct IncompressibleCase {
  Case input;
  double displacement = 1;  ///< tangential displacements of `input` over those of the case
};

/// Whether the body is a layer for which MDR has coupled springs, which move in one tangential direction.
bool is_layer_of_mdr(const Case& input);

/// The incompressible case that stands for a case: the case itself where it is incompressible already, and over a
/// layer, as MDR takes Poisson's ratio of a layer into account.
IncompressibleCase incompressible_case(const Case& input);

}  // namespace fretval
