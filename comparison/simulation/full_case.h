#pragma once

#include <optional>

#include "comparison/simulation/bodies/body_store.h"
#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// The answer of the contact on rings and angles (fem/full_contact) to a case of it. Without coupling its pressures are
/// those of the ring contact, which reads contact radius and normal force. Stick radii are those of discs with the
/// areas of the zones.
///
/// ring: the answer of the ring contact to the same case; empty: the motion goes in two directions. What is read on
/// rings and angles has the errors of its rings and steps, and the ring contact has better readings. Therefore the same
/// friction is stepped once more with one angle, which is the ring contact to roundoff but for its readings, and the
/// difference of the two histories, in which these errors cancel, is added to the answer of the ring contact. With
/// coupling the normal contact is stepped along, and its force and edge are corrected in the same way. Throws
/// fem::SolverError where the numerics fail.
FeAnswer compute_full_contact(const ContactProblems& problems, const FemCase& fem, const std::optional<FeAnswer>& ring,
                              BodyStore& bodies);

/// The resolution whose rings lie half a ring from those of an answer where its stick zones end. Empty: the zones have
/// better readings, or none; or the mesh is given, and with it where its rings lie.
std::optional<Resolution> half_a_ring_away(const FemCase& fem, const FeAnswer& answer);

/// Takes the means of an answer and of another one: of its zones, forces and works. What is read of points errs by up
/// to a tenth of a ring, to either side, with the place of the edge in its ring, nearly as a sine: the mean over two
/// places half a ring apart errs by a sixth of that.
void average(const FeAnswer& other, FeAnswer& answer);

/// A zone in units of a length.
PlaneZone zone_of(const fem::ContactRegion& region, double length);

}  // namespace fretval
