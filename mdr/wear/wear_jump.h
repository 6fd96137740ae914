#pragma once

#include <Eigen/Core>
#include <optional>

#include "mdr/wear/abel_matrices.h"
#include "mdr/wear/wear_cycle.h"

namespace fretval::mdr {

/// Depth in m that many cycles wear off the rings, implicit in the pressure and explicit in the slip:
///
///   dw = max(0, n k sum_t |ds_t| p_t(dw)),   p_t = 4 G0 stress q_t,   q_t = max(0, load_t - stiffness_t image dw)
///
/// With work = 4 G0 n k, dimensionless. As n grows, dw tends to where the pressure of all slipping rings is zero, and
/// never goes beyond. stiffness_t is 1, as for an elastic or a slow change of g; but where a viscoelastic spring is
/// hit faster than it relaxes, it is load_t over the room, so that the load ends just where the spring is out of
/// reach: room = d_max - g per spring in m, not positive where it cannot be reached.
/// Semismooth Newton iterations, until they change dw by no more than the accuracy in m; empty if they do not converge.
std::optional<Eigen::ArrayXd> wear_jump(const AbelMatrices& matrices, const WearCycle& cycle,
                                        const Eigen::ArrayXd& room, double work, double accuracy);

}  // namespace fretval::mdr
