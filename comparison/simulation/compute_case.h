#pragma once

#include "comparison/simulation/bodies/body_store.h"
#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// The answer of finite elements to a case at a resolution: mesh, operators, condensation, histories, readings. Bodies
/// are shared with everything else that is computed from the same store. At nu = 1/2 the normal contact does not see
/// the friction, so it comes first. Throws fem::SolverError and meshes::MeshError where the numerics fail.
FeAnswer compute_case(const FemCase& fem, const Resolution& resolution, BodyStore& bodies);

}  // namespace fretval
