#pragma once

#include <Eigen/Dense>

#include "fem/motion/motion.h"
#include "fem/motion/relaxation.h"
#include "fem/ring_contact/contact_problem.h"
#include "fem/ring_contact/stick_zone/edge_radius.h"
#include "fem/wear/wear_course.h"

namespace fretval::fem {

/// The contact in which an indenter wears on rings. All of it must outlive what takes it.
struct WornContact {
  const ContactProblem &normal, &tangential;
  const RelaxationModel& relaxation;
  const Motion& motion;
  int steps_per_cycle;
  double friction_coefficient;
};

/// Share of the normal force that is as good as nothing: what wears no more bears no more than that outside of what
/// sticks, where an unworn contact bears tens of percent.
constexpr double as_good_as_nothing = 1e-2;

/// Where wear ends, to a share of a ring.
struct EndOfWear {
  EdgeRadius stick;        ///< radius of what sticks; 0: nothing
  Eigen::VectorXd worn;    ///< depths of the rings
  bool is_shared = false;  ///< whether the edge was read inside its ring; otherwise both are those of whole rings
};

/// The end of a course of wear, with the part of the ring at the edge of the stick zone that sticks.
///
/// A ring slips, and wears, as a whole or not at all, and next to the singular edge pressures and tractions of single
/// rings are off by a share that finer rings do not reduce: which rings beside the edge are worn in the end is left to
/// the last digits of the data. But any such end tells where the edge is: inside it the depths D of pressure and
/// traction (PunchSeries) are smooth, and the reserve
///   [min over t of (w - D_t) + min over t of (w + D_t)] / 2,   w = mu D k_n/k_t  (see limiting_amplitude)
/// vanishes there. Where a force is prescribed, the depths of each ring are those of a disc that ends in its middle and
/// bears the force alone, so that the edge is that of the disc that bears the force, and not of whole rings. It is the
/// root of a parabola through three rings, each up to eight rings from the next, and lies no further from the outermost
/// of them than half of the way to the innermost. Third order in the rings.
///
/// The worn depths are then carried over to that edge. The free surface at the largest indentation is that under the
/// depths D of what sticks. D of the rings that did stick is known from the indenter that is left; D of the disc up to
/// the edge from the indenter before, the ring that holds the edge having a share of its depth. What is worn differs by
/// what the difference moves of the surface; under a normal force the indenter also rises by what keeps the force. This
/// is the difference between two limiting profiles alone: what wear has left undone elsewhere stays undone. Rings
/// inside the edge that slipped all the same have lost nothing.
/// Second order in the rings.
///
/// Whole rings are kept over another body than a half-space, where fewer than nine rings stick, where the root is
/// further away, and where rings that slip or open bear more than a hundredth of the first force: wear goes on then, or
/// it has ended otherwise than in its limit. The uncertainty is then the wider one of the rings beside the edge, and
/// otherwise twice the distance from the root through rings half as far apart, with the scatter of the effective radii.
EndOfWear end_of_wear(const WornContact& contact, const Eigen::VectorXd& unworn, const WearCourse& course);

}  // namespace fretval::fem
