#pragma once

#include "comparison/simulation/bodies/body_store.h"
#include "fem/full_contact/surface_compliance.h"

namespace fretval {

/// The surface of a body with the orders up to highest_order, at any scale. Blocks that neither this store nor the one
/// of operators on disk has are made, on all cores. Throws fem::SolverError and meshes::MeshError.
fem::SurfaceCompliance find_or_make_surface(const BodyDescription& description, unsigned highest_order,
                                            BodyStore& bodies);

}  // namespace fretval
