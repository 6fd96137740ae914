#pragma once

#include "comparison/reference/mdr_values.h"

namespace fretval {

/// Whether the indenter moves in two directions along the surface.
bool moves_in_plane(const MdrCase& mdr);

/// MDR's answer where friction is a vector (mdr/plane): stick radii in closed form, forces and energies by springs of
/// two finenesses, whose error is the whole difference of the two. times: factor on the usual numbers of springs and
/// steps.
MdrAnswer plane_answer(const MdrCase& mdr, const mdr::NormalResponse& normal, int times);

}  // namespace fretval
