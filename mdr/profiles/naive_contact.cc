#include "mdr/profiles/naive_contact.h"

#include <algorithm>
#include <cmath>

#include "mdr/support/checks.h"

namespace fretval::mdr {
namespace {

// Intervals of the sum over x, many for each of the 800 pieces or more of the image of a table; the error of the force
// is of second order in their width.
constexpr int n_parts = 20000;

}  // namespace

NaiveContact naive_contact(const Profile& profile, double depth) {
  require_non_negative("depth of the one-dimensional profile", depth);
  double end = end_radius(profile);
  if (!std::isfinite(end)) end = 1.1 * inverse_transform(profile, depth);
  const double width = end / n_parts;
  NaiveContact contact{0, 0};
  double before = depth - transform(profile, 0);
  for (int i = 1; i <= n_parts; ++i) {
    const double x = i == n_parts ? end : i * width, excess = depth - transform(profile, x);
    const double inside = std::max(before, 0.0) + std::max(excess, 0.0);
    // Where the sign changes, the share of the part in which the springs press.
    const double share = (before > 0) == (excess > 0) ? 1 : inside / (std::abs(before) + std::abs(excess));
    contact.force_over_modulus += 8 * width * share * inside / 2;
    if (excess > 0) contact.radius = x;
    if (before > 0 && excess <= 0) contact.radius = x - (1 - share) * width;
    before = excess;
  }
  return contact;
}

}  // namespace fretval::mdr
