#pragma once

#include <optional>

#include "comparison/reference/mdr_values.h"
#include "mdr/motion/commensurability.h"
#include "mdr/springs/forced_response.h"

namespace fretval {

/// Springs with a dashpot are slow to step, and to settle. Others are given up where their ramp, of which a second one
/// is twice as long, would take more than all periods that they have.
bool settles_for_long(const mdr::PronyBody& body, double period);

/// The cycle that springs are asked about; empty: none, see MdrAnswer::cycle.
std::optional<mdr::CommonCycle> cycle_to_step(const MdrCase& mdr);

/// What springs say of it; empty: there is none.
std::optional<MdrCycle> cycle_of_springs(const MdrCase& mdr, const mdr::SteppedForcedResponse& stepped,
                                         double normal_force_max);

/// Of any stepped response, by the length of the tangential path of the indenter.
template <class Response>
MdrCycle cycle_of(const MdrCase& mdr, const Response& response, const Response& error, double normal_force_max,
                  double tangential_way) {
  const double sliding_force = mdr.friction_coefficient * normal_force_max;
  return {response.tangential_force_max,
          response.tangential_force_mean,
          response.friction_work,
          response.bulk_work,
          response.tangential_work,
          sliding_force,
          sliding_force * tangential_way,
          std::max(error.tangential_force_max, error.tangential_force_mean),
          error.friction_work + error.bulk_work,
          error.tangential_work,
          mdr.body.viscosity == 0 || mdr.is_single_pass() || mdr.cycle_tolerance};
}

}  // namespace fretval
