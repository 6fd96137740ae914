#pragma once

#include "meshes/mesh.h"

namespace fretval::meshes {

/// Improves poor cells, those of a scaled Jacobian below 0.4: moves their nodes inside the body towards the mean of the
/// nodes they share an edge with, as long as the poorest cell around a node gets better. No cell ends up poorer than
/// the poorest one around it was; nodes of the boundary stay.
void smooth(Mesh& mesh);

}  // namespace fretval::meshes
