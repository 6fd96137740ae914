#pragma once

#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// Reads a contact whose rings touch in any order (ContactKind::annuli). No order is assumed: forces and energies are
/// sums over the rings, and zones are read ring by ring.
///
/// No body touches further than the elastic one that rests at the largest indentation, whose zones are read to a
/// fraction of a ring (fem::contact_annuli); where the same rings touch in the cycle, its ends are those of the
/// contact. Otherwise the ends are the edges of rings, uncertain by a ring. The contact radius is the outermost end; a
/// stick radius is that of a zone that is one disc, and empty where there are others or none.
FeAnswer read_zones(const ContactProblems& problems, const FemCase& fem, const Eigen::VectorXd& profile,
                    fem::NormalHistory normal, fem::FrictionHistory&& friction);

}  // namespace fretval
