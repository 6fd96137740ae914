#pragma once

#include <Eigen/Dense>

#include "fem/history/normal_history.h"
#include "fem/motion/motion.h"
#include "fem/motion/relaxation.h"
#include "fem/ring_contact/contact_problem.h"

namespace fretval::fem {

/// The largest tangential amplitude, over that of the motion, under which nothing inside the n_inside innermost rings
/// slips in the periodic state: the smallest lambda of a ring at which
///   min over t of (w - lambda u)  +  min over t of (w + lambda u)  =  0,   w = mu D k_n/k_t
/// D(t): depth of the ring in the pressure (PunchSeries of the normal problem); k_n, k_t: force of a unit punch per
/// radius, normally and tangentially; u(t): response of the body to the tangential motion without slip, under a
/// prescribed force, F_x(t) over the force of a unit punch. 0 where a ring loses contact.
///
/// While all these rings stick they are a flat punch, whose traction is lambda u t0, and what slip has locked in. Some
/// locked-in traction keeps them within mu p at all times just if no sum above is negative, and where the normal
/// contact does not see the friction a history ends in such a state if there is one. Source: Klarbring, Ciavarella,
/// Barber, Int. J. Solids Struct. 44 (2007) 8355. Thus neither a friction history is needed nor a threshold below which
/// slip counts as none.
///
/// Pressure and traction are singular at the edge of such a contact, where single rings are off by a share that no
/// refinement takes away: the outermost ring slips up to a tenth too early or late, whatever its width. Flat punches
/// have the depth 1 in all rings, up to the last one, so depths compare the intensities of both singularities.
double limiting_amplitude(const ContactProblem& normal_problem, const ContactProblem& tangential_problem,
                          const RelaxationModel& relaxation, double friction_coefficient, const Motion& motion,
                          const NormalHistory& normal, Eigen::Index n_inside);

}  // namespace fretval::fem
