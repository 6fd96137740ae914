#include "mdr/profiles/profile.h"

#include <cmath>
#include <limits>
#include <string>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

// A caller's own g(g^-1(d)) may pass the last row of a table by roundoff.
constexpr double roundoff = 1e-12;

void require_on_profile(const Profile& profile, const char* quantity, double r) {
  require_non_negative(quantity, r);
  if (const double end = end_radius(profile); std::isfinite(end)) require_within(quantity, r, 0, end * (1 + roundoff));
}

/// What supposes a contact that is one full circle, in terms of what it supposes.
void require_rising_image(const Profile& profile) {
  const auto* table = std::get_if<ProfileTable>(&profile);
  if (table && !table->falls.empty())
    reject("profile table at r in m", table->falls.front().from,
           "the one-dimensional image g falls here, and the method of dimensionality reduction does not hold");
}

}  // namespace

Profile parabola(double radius) {
  require_positive("radius of the parabola", radius);
  return PowerLaw{1 / (2 * radius), 2, 1 / radius};
}

Profile sphere(double radius) {
  require_positive("radius of the sphere", radius);
  return Sphere{radius};
}

Profile cone(double slope_angle) {
  const double quarter_turn = pi / 2;
  require_finite("slope angle of the cone", slope_angle);
  if (!(slope_angle > 0 && slope_angle < quarter_turn)) {
    reject("slope angle of the cone", slope_angle, "must lie strictly between 0 and pi/2 rad");
  }
  return PowerLaw{std::tan(slope_angle), 1, quarter_turn * std::tan(slope_angle)};
}

Profile power_law(double coefficient, double exponent) {
  require_positive("coefficient of the power law", coefficient);
  require_within("exponent of the power law", exponent, 0.5, 20);
  return PowerLaw{coefficient, exponent, transform_factor(exponent) * coefficient};
}

Profile rounded_flat(double flat_radius, double edge_radius) {
  require_positive("flat radius", flat_radius);
  require_positive("edge radius", edge_radius);
  return FlatFaced{flat_radius, 0, 1 / edge_radius};
}

Profile truncated_sphere(double radius, double flat_radius) {
  require_positive("radius of the sphere", radius);
  require_positive("flat radius", flat_radius);
  return FlatFaced{flat_radius, flat_radius / radius, 1 / radius};
}

Profile tabulated(const std::vector<double>& r, const std::vector<double>& f, double noise) {
  return profile_table(r, f, noise);
}

Profile tabulated_as_it_is(const std::vector<double>& r, const std::vector<double>& f) {
  return profile_table_as_it_is(r, f);
}

std::vector<FallOfImage> falls_of_image(const Profile& profile) {
  const auto* table = std::get_if<ProfileTable>(&profile);
  return table ? table->falls : std::vector<FallOfImage>{};
}

double end_radius(const Profile& profile) {
  if (const auto* table = std::get_if<ProfileTable>(&profile)) return end_radius(*table);
  if (const auto* sphere = std::get_if<Sphere>(&profile)) return sphere->radius;
  return std::numeric_limits<double>::infinity();
}

double shape(const Profile& profile, double r) {
  require_on_profile(profile, "radial coordinate r", r);
  return std::visit([r](const auto& p) { return shape(p, r); }, profile);
}

double shape_slope(const Profile& profile, double r) {
  require_on_profile(profile, "radial coordinate r", r);
  return std::visit([r](const auto& p) { return shape_slope(p, r); }, profile);
}

double transform(const Profile& profile, double x) {
  require_on_profile(profile, "coordinate |x|", std::abs(x));
  return std::visit([x](const auto& p) { return transform(p, x); }, profile);
}

double transform_slope(const Profile& profile, double x) {
  require_rising_image(profile);
  require_on_profile(profile, "coordinate x", x);
  return std::visit([x](const auto& p) { return transform_slope(p, x); }, profile);
}

std::vector<double> transform_kinks(const Profile& profile) {
  const auto* flat_faced = std::get_if<FlatFaced>(&profile);
  return flat_faced ? std::vector<double>{flat_faced->flat_radius} : std::vector<double>{};
}

double transform_integral(const Profile& profile, double x) {
  require_rising_image(profile);
  require_on_profile(profile, "coordinate x", x);
  return std::visit([x](const auto& p) { return transform_integral(p, x); }, profile);
}

double inverse_transform(const Profile& profile, double depth) {
  require_rising_image(profile);
  require_non_negative("depth of the one-dimensional profile", depth);
  if (const auto* table = std::get_if<ProfileTable>(&profile)) {
    const double deepest = transform(*table, end_radius(*table));
    if (depth > deepest * (1 + roundoff))
      reject("depth of the one-dimensional profile", depth,
             "the contact would reach beyond the last row of the profile table, whose depth is " +
                 std::to_string(deepest));
  }
  if (const auto* sphere = std::get_if<Sphere>(&profile); sphere && depth > largest_depth(*sphere))
    reject("depth of the one-dimensional profile", depth,
           "the contact would reach the radius of the sphere, " + std::to_string(sphere->radius) +
               "; must be at most " + std::to_string(largest_depth(*sphere)));
  return std::visit([depth](const auto& p) { return inverse_transform(p, depth); }, profile);
}

double abel_slope_integral(const Profile& profile, double r, double a) {
  require_rising_image(profile);
  require_on_profile(profile, "outer radius a", a);
  require_within("radial coordinate r", r, 0, a);
  return std::visit([r, a](const auto& p) { return abel_slope_integral(p, r, a); }, profile);
}

double abel_depth_integral(const Profile& profile, double lower, double upper, double r) {
  require_rising_image(profile);
  require_on_profile(profile, "upper limit", upper);
  require_within("lower limit", lower, 0, upper);
  require_within("radial coordinate r", r, upper, std::numeric_limits<double>::max());
  return std::visit([=](const auto& p) { return abel_depth_integral(p, lower, upper, r); }, profile);
}

}  // namespace fretval::mdr
