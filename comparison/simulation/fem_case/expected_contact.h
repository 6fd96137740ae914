#pragma once

#include "comparison/case/case.h"
#include "mdr/profiles/profile.h"

namespace fretval {

/// A contact radius in m at an indentation in m, which tells how long the contact line of a mesh has to be; an error in
/// it costs rings and nothing else. Over a half-space it is the radius of the elastic contact. Over a layer a smaller
/// indentation has the same radius a:
///
///   d(a)/d_half-space(a) = t + (1 - t)/(1 + c a/H)
///
/// with the thin layer's limit t = 1/4 of an incompressible bonded body (p vanishes with its slope at the edge), t =
/// 1/2 of a compressible one (Winkler), from nu = 0.3 to 1/2 between the two, and c = 1.1, the slope at a/H = 0 of the
/// bonded incompressible layer.
double expected_contact_radius(const mdr::Profile& profile, double indentation, const Case::Body& body,
                               double poisson_ratio);

}  // namespace fretval
