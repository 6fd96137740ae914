#include "comparison/simulation/fem_case/expected_contact.h"

#include <algorithm>

namespace fretval {

double expected_contact_radius(const mdr::Profile& profile, double indentation, const Case::Body& body,
                               double poisson_ratio) {
  const double over_half_space = mdr::inverse_transform(profile, indentation);
  if (body.is_half_space()) return over_half_space;
  constexpr double slope = 1.1, incompressible_limit = 0.25, compressible_limit = 0.5;
  const double towards_incompressible = body.is_bonded ? std::clamp((poisson_ratio - 0.3) / 0.2, 0.0, 1.0) : 0;
  const double limit = compressible_limit + towards_incompressible * (incompressible_limit - compressible_limit);
  double radius = over_half_space;
  for (int k = 0; k < 30; ++k) {
    const double share = limit + (1 - limit) / (1 + slope * radius / body.thickness);
    radius = mdr::inverse_transform(profile, indentation / share);
  }
  return radius;
}

}  // namespace fretval
