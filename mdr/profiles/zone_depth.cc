#include "mdr/profiles/zone_depth.h"

#include <algorithm>

namespace fretval::mdr {

namespace {

struct FlatFace {
  double radius, rise;  // b, and g(2 b), or g where the profile ends before
};

FlatFace flat_face(const Profile& profile) {
  const double b = inverse_transform(profile, 0);
  return {b, transform(profile, std::min(2 * b, end_radius(profile)))};
}

}  // namespace

double zone_depth(const Profile& profile, double radius) {
  const auto [b, rise] = flat_face(profile);
  return radius < b ? (radius / b - 1) * rise : transform(profile, radius);
}

std::optional<double> zone_radius(const Profile& profile, double depth) {
  if (depth > 0) return inverse_transform(profile, depth);
  const auto [b, rise] = flat_face(profile);
  if (b == 0 || depth <= -rise) return std::nullopt;
  return b * (1 + depth / rise);
}

}  // namespace fretval::mdr
