#pragma once

#include <map>
#include <optional>
#include <string>

#include "comparison/reference.h"
#include "comparison/simulation.h"

namespace fretval {

/// One quantity compared.
struct Difference {
  std::optional<double>
      difference;  ///< finite elements less MDR, relative; empty: one of the two says that nothing sticks
  double tolerance;
  bool pass;
};

/// How far finite elements and MDR may lie apart.
struct Tolerances {
  double stick_radius;    ///< over the unworn contact radius at the largest indentation
  double contact_radius;  ///< relative
  double normal_force;    ///< relative
};

/// What a case asks for: T = Accuracy / Tolerance on the stick radius, T/10 on contact radius and normal force.
Tolerances tolerances_of(double accuracy);

/// Compared quantities by the name they have in result.json.
///
/// Stick radii: (c_FE - c_MDR)/a, a the unworn contact radius at the largest indentation. Where c/a < 0.1 the tolerance
/// grows by 0.1 a/c: c is the root of g(c) = depth, and for a profile with g'(0) = 0 a given error of the depth moves a
/// small c ever further. Where MDR says that nothing sticks, the finite elements must say so too. For a limiting
/// profile: slip inside c over u_x0, force outside c over the force, and the indentation at which the flank touches
/// over the largest one, all within the tolerance of the stick radius.
using Verdict = std::map<std::string, Difference>;

Verdict compare(const MdrAnswer& mdr, const FeAnswer& fe, double unworn_radius, const Tolerances& tolerances);

bool passes(const Verdict& verdict);

}  // namespace fretval
