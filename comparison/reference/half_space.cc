#include "comparison/reference/half_space.h"

#include <cmath>

#include "mdr/layer/layer_contact.h"

namespace fretval {

double thickness_of_half_space(const MdrCase& mdr, double poisson_ratio, double share) {
  const double deepest = deepest_indentation(mdr), radius = mdr::inverse_transform(mdr.profile, deepest);
  const auto infinite = mdr::layer_contact(mdr.profile, {HUGE_VAL, poisson_ratio}, radius);
  const auto is_half_space = [&](double thickness) {
    const mdr::Layer layer{thickness, poisson_ratio};
    const auto contact = mdr.normal_force
                             ? mdr::layer_contact_under_force(mdr.profile, layer, 1, mdr::normal_force(infinite, 1))
                             : mdr::layer_contact_at_depth(mdr.profile, layer, deepest);
    return std::abs(contact.contact_radius / radius - 1) <= share;
  };
  constexpr double digits = 1e-3;
  double thin = radius / 20, thick = 2 * radius / share;
  while (thick / thin > 1 + digits) {
    const double middle = std::sqrt(thin * thick);
    (is_half_space(middle) ? thick : thin) = middle;
  }
  return thick;
}

MdrAnswer half_space_answer(const Case& input) {
  auto over_half_space = input;
  over_half_space.body = {};
  const auto mdr = mdr_case(over_half_space);
  return mdr_answer(mdr, mdr_normal_response(mdr));
}

}  // namespace fretval
