#pragma once

#include "mdr/layer/layer.h"
#include "mdr/springs/path_response.h"

namespace fretval::mdr {

/// path_forces() of mdr/springs/path_response.h on a layer: springs that the layer couples
/// (mdr/layer/coupled_step.h), stepped along a path, extrapolated likewise. Depths of stick zones are g(c) of the
/// unworn image. For a rheology with one G(t). Throws as path_forces(), and std::runtime_error should the contact reach
/// the last of the springs.
SteppedPathForces coupled_path_forces(const Profile& profile, const Layer& layer, const PronyBody& body, double mu,
                                      const SampledPath& path, const PathFineness& coarse = {});

}  // namespace fretval::mdr
