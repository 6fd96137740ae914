#pragma once

#include "mdr/layer/layer.h"
#include "mdr/springs/forced_response.h"

namespace fretval::mdr {

/// forced_response() of mdr/springs/forced_response.h on a layer: the periodic response to prescribed motions, forces
/// or one of each, by coupled springs (mdr/layer/coupled_history.h) stepped until they repeat, extrapolated from n and
/// 2 n springs and steps, errors the whole difference. depths: of both stick zones, of the unworn image, also under
/// displacements alone; the radii are their zone_radius() (mdr/profiles/zone_depth.h). The contact radius is where the
/// load of the springs falls to nothing at the largest indentation. For a rheology with one G(t), which is a factor of
/// all. Throws as forced_response(), and std::runtime_error should the contact reach the last of the springs.
SteppedForcedResponse coupled_response(const Profile& profile, const Layer& layer, const PronyBody& body, double mu,
                                       const Prescribed& prescribed, const SpringFineness& fineness = {});

/// Where the loads of a bed fall to nothing: by the parabola through the three outermost springs in contact, m.
double edge_of_loads(const SpringBed& bed, const Eigen::ArrayXd& load);

}  // namespace fretval::mdr
