#include "comparison/verification/extremes/extreme_springs.h"

#include <cmath>

#include "comparison/reference/mdr_case.h"
#include "comparison/reference/mdr_document.h"

namespace fretval {

ComparedQuantities compared_with_springs(const Case& input) {
  const auto profile = profile_of(input.indenter);
  const auto motion = harmonic_motion_of(input.motion);
  const double contact_radius = mdr::inverse_transform(profile, mdr::maximum_indentation(motion));
  const auto exact = mdr::stick_depths(rheology_of(input.elastomer), input.friction_coefficient, motion);
  const auto coarse = spring_answer(input, {50, 24, 4, 1e-7}).history.depths;
  const auto fine = spring_answer(input, {100, 48, 4, 1e-7}).history.depths;
  const auto compared = [&](double mdr::StickDepths::*depth) {
    const auto radius = [&](const mdr::StickDepths& depths) {
      return depths.*depth > 0 ? mdr::inverse_transform(profile, depths.*depth) / contact_radius : 0;
    };
    const double stepped = radius(fine);
    return ComparedQuantity{radius(exact), stepped, input.tolerance, 3 * std::abs(stepped - radius(coarse))};
  };
  return {{Quantity::stick_radius_first_slip, compared(&mdr::StickDepths::first_slip)},
          {Quantity::stick_radius_shakedown, compared(&mdr::StickDepths::shakedown)}};
}

}  // namespace fretval
