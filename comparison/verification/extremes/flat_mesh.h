#pragma once

#include "meshes/mesh.h"

namespace fretval {

/// A quarter disc whose topmost cells under the contact, squares of the size `ring`, are flatter by a factor `aspect`
/// >= 1. Within the radius `reach`, depths up to it are raised to a power, z/reach -> (z/reach)^p, with
/// p = 1 + log(aspect)/log(reach/ring); beyond, p falls smoothly to 1 at three times the radius. Lengths in the unit of
/// the mesh.
meshes::Mesh flattened(meshes::Mesh mesh, double aspect, double ring, double reach);

}  // namespace fretval
