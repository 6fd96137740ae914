#pragma once

#include "meshes/mesh.h"

namespace fretval {

/// A quarter disc whose cells under the contact are flatter by a factor `aspect` >= 1. Depths are multiplied by a
/// weight: 1/aspect within the radius `reach` around the centre, 1 beyond seven times, smooth and rising between,
/// so that the far boundary, the axis and the surface stay where they are.
meshes::Mesh flattened(meshes::Mesh mesh, double aspect, double reach);

}  // namespace fretval
