#pragma once

#include "mdr/motion/sampled_path.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/springs/path_data.h"

namespace fretval::mdr {

/// Indentation in m that no relaxation of the body exceeds along a path, see deepest_indentation() of
/// mdr/springs/forced_response.h.
double deepest_indentation(const Profile& profile, const PronyBody& body, const SampledPath& path);

/// Steps the springs along a path, of which every row is the end of a step. A single pass begins relaxed at its first
/// row; of a path that repeats the departure from rest rises smoothly over the ramp, and periods go by until the
/// tractions repeat. Where a force is prescribed each step finds the displacement that balances it (force_balance.h).
/// Bodies that creep for long are brought there by jumps (creep_jump.h). Throws std::runtime_error when they do not
/// after 2000 periods, GrossSlip with its instant between the steps,
/// std::invalid_argument for bad arguments.
PathCourse path_course(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path,
                       const PathFineness& fineness = {});

/// Forces, works and stick depths along a path, extrapolated (see SteppedPathForces). coarse: fineness of the coarser
/// one of the two computations.
SteppedPathForces path_forces(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path,
                              const PathFineness& coarse = {});

}  // namespace fretval::mdr
