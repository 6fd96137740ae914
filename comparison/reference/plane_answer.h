#pragma once

#include "comparison/reference/mdr_values.h"

namespace fretval {

/// Whether the indenter moves in two directions along the surface.
bool moves_in_plane(const MdrCase& mdr);

/// What MDR's springs say where friction is a vector (mdr/plane): stick radii in closed form, forces and energies by
/// springs of two finenesses, their error the whole difference of both. Of prescribed displacements.
MdrAnswer plane_answer(const MdrCase& mdr, const mdr::NormalResponse& normal, int times);

}  // namespace fretval
