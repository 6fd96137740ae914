#pragma once

namespace fretval::fem {

/// Force of a unit flat punch on a half-space over its radius and shear modulus, normal and tangential:
///
///   4/(1 - nu)   and   8/(2 - nu)
///
/// Of a tangential one the mean over the disc of the displacement along the force. Source: Johnson, Contact Mechanics
/// (1985), sections 3.4 and 7.2. nu from 0 to 0.5. For what has to be known before there is a compliance, which tells
/// the same up to the error of its mesh (PunchSeries::force_per_radius).
double normal_punch(double poisson_ratio);
double tangential_punch(double poisson_ratio);

/// The first of them over the second, (2 - nu)/(2 (1 - nu)): 3/2 at nu = 1/2.
double normal_over_tangential_punch(double poisson_ratio);

}  // namespace fretval::fem
