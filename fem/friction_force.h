#pragma once

#include <Eigen/Dense>

#include "fem/punch_series.h"
#include "fem/slip_zones.h"

namespace fretval::fem {

/// Tangential force. While the outermost rings slip it is what the slip reserve leaves of mu times the normal force:
/// the reserve vanishes in the slip zone, however narrow it is, so the edge of the contact plays no part. Where it
/// begins to vanish is found from the reserve of the stuck rings, and of the next ones as they were held when their
/// slip began: that of the last zone that sticks may have one ring or none left.
/// limit_depths: of mu p, limit_force: mu times the normal force.
double friction_force(const PunchSeries& series, const SlipZones& zones, const Eigen::VectorXd& limit_depths,
                      double limit_force);

}  // namespace fretval::fem
