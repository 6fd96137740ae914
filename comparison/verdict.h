#pragma once

#include <map>
#include <optional>
#include <string>

#include "comparison/reference.h"
#include "comparison/simulation.h"

namespace fretval {

/// One quantity compared.
struct Difference {
  std::optional<double> difference;  ///< finite elements less MDR, relative; empty: one of the two says that nothing sticks
  double tolerance;
  bool pass;
};

/// Compared quantities by the name they have in result.json.
///
/// Stick radii: (c_FE - c_MDR)/a, a the unworn contact radius at the largest indentation, within the tolerance T of the case; contact radius and normal force relative, within T/10.
/// Where c/a < 0.1 the tolerance grows to T (0.1 a/c): c is the root of g(c) = depth, and for a profile with g'(0) = 0 a given
/// error of the depth moves a small c ever further. Where MDR says that nothing sticks, the finite elements must say
/// so too. For a limiting profile: slip inside c over u_x0 and force outside c over the force, both within T, and the
/// indentation at which the flank touches over the largest one, within T.
using Verdict = std::map<std::string, Difference>;

Verdict compare(const MdrAnswer& mdr, const FeAnswer& fe, double unworn_radius, double tolerance);

bool passes(const Verdict& verdict);

}  // namespace fretval
