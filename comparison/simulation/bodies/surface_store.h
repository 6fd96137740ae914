#pragma once

#include <Eigen/Dense>
#include <memory>
#include <utility>

#include "comparison/simulation/fem_case/body_description.h"
#include "comparison/support/made_once.h"
#include "fem/condensation/compliance.h"
#include "fem/full_contact/surface_compliance.h"
#include "fem/operators/fourier_order.h"

namespace fretval {

class BodyStore;

/// Blocks of the surfaces of bodies (fem::surface_block), which cases, numbers of angles and refinements share.
using SurfaceStore = MadeOnce<std::pair<BodyDescription, fem::FourierOrder>, fem::Compliance>;

/// The surface of a body with the orders up to the highest one, at any scale: what the store does not have, nor that
/// of operators of other runs, is made, on all cores. Throws fem::SolverError and meshes::MeshError.
fem::SurfaceCompliance find_or_make_surface(const BodyDescription& description, unsigned highest_order,
                                            BodyStore& bodies);

}  // namespace fretval
