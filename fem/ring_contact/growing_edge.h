#pragma once

#include <Eigen/Dense>

#include "fem/motion/relaxation.h"
#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// How long the rings of a contact over a body with memory have been in contact.
struct TimesInContact {
  const RelaxationModel& relaxation;
  const Eigen::VectorXd&
      ring;  ///< time since each ring was touched, in the unit of the relaxation times; may be infinite
};

/// A part of a normal force.
struct ForceAtEdge {
  double force = 0, uncertainty = 0;
};

/// What the integral of cubics through the depths of rings misses of the normal force next to the edge of a contact
/// that grows over a body with memory.
///
/// The edge was at the distance R(t) inside of where it is now a time t ago. What lies there was touched then, and its
/// depth is `D = C int_0^t G(y) R'(y) dy`, G the relaxation of the body and C the indentation that one more unit of
/// radius takes, which varies smoothly. A branch that relaxes while the edge crosses a ring lets D fall to its value at
/// the edge (zero, or the jump of a dashpot) within less than a ring, where no cubic follows. R(t) is the cubic through
/// the last three rings in contact and the edge. C at the edge is on the line through the values that this law gives
/// for the last ring but one and the one before. The uncertainty is what the force would differ by with the C of the
/// last ring.
///
/// Nothing is missed of a body without branches: depths of rings in contact go with the indentation and its rate,
/// however long each has been in contact, and are cubics up to the edge.
///
/// depths: of PunchSeries, of n_pressed rings, at least four, around the centre; radius: of the edge. Where the last
/// rings were not touched one after the other, nothing is added, and what depths that fall to zero from the last ring
/// on would take off is the uncertainty, by half.
ForceAtEdge force_missed_at_edge(const PunchSeries& series, const Eigen::VectorXd& depths, Eigen::Index n_pressed,
                                 double radius, const TimesInContact& times);

}  // namespace fretval::fem
