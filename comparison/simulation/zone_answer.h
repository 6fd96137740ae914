#pragma once

#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// Reads a contact whose rings touch in any order (ContactKind::annuli). Nothing is supposed of the order: forces and
/// energies are sums over the rings, zones are what the rings do.
///
/// No body touches further than the elastic one that rests at the largest indentation, whose zones are read to a
/// fraction of a ring (fem::contact_annuli); where the rings that touch in the cycle are those, the ends are those.
/// Otherwise they are the edges of rings, uncertain by a ring. The contact radius is the outermost one; a stick radius
/// is that of a zone that is one disc, and empty where there are others or none.
FeAnswer read_zones(const ContactProblems& problems, const FemCase& fem, const Eigen::VectorXd& profile,
                    fem::NormalHistory normal, fem::FrictionHistory&& friction);

}  // namespace fretval
