#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/ring_contact/contact_problem.h"

namespace fretval::fem {

/// A range of neighbouring rings: the first one, and the one after the last.
struct RingRange {
  Eigen::Index begin, end;
};
std::vector<RingRange> ranges_of(const std::vector<bool>& rings);

/// A zone around the axis, dimensionless; inner 0: a disc.
struct Annulus {
  double inner, outer;
};

/// Zones of rings that are marked, from the inner edge of their first ring to the outer edge of their last.
std::vector<Annulus> annuli_of(const std::vector<bool>& rings, const std::vector<double>& radii);

/// Where an elastic body touches a profile of any form at an indentation, to a fraction of a ring.
///
/// Between the indentations at which the last ring of a zone and the next one beyond it touch, pressures and gaps are
/// linear in the depth, with the slopes of a flat punch that has the shape of the contact: `dp/dd = C_SS^-1 A`,
/// `dgap/dd = u - 1`. Therefore the pressure of the last ring and the gap of the next one tell how far it is to either
/// event, and the end of the zone lies in between accordingly. At an event it lies as at the edge of a disc of rings
/// (PunchSeries::radii), mirrored at an inner edge: all edges look alike from nearby. The error is of second order in
/// the ring. Only the compliance is used.
///
/// pressure, gap: of static_contact.
std::vector<Annulus> contact_annuli(const ContactProblem& problem, const Eigen::VectorXd& pressure,
                                    const Eigen::VectorXd& gap);

/// Where rings stick, to a fraction of a ring. The stick margin of the rings is a traction on the zones that stick; a
/// uniform displacement lowers it by the traction of a punch that has their shape, and the last ring of a zone slips
/// first, then the one before it: these two reserves are extrapolated to zero, but no further than the next ring. A
/// zone of a single ring is taken from edge to edge of the ring.
std::vector<Annulus> stick_annuli(const ContactProblem& tangential, const Eigen::VectorXd& margin,
                                  const std::vector<bool>& sticks);

}  // namespace fretval::fem
