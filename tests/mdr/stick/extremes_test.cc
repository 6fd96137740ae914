#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "mdr/profiles/indentation.h"
#include "mdr/profiles/profile.h"
#include "mdr/stick/limiting_profile.h"
#include "mdr/stick/surface_fields.h"
#include "mdr/support/constants.h"
#include "tests/mdr/fifty_digits.h"

namespace fretval::mdr::extremes_test {
namespace {

// Asked for is 1e-10. The adaptive quadrature of slope integrals of flat faces leaves up to 6e-12, powers of 20 and a
// rounded contact radius next to which the pressure is taken up to 3e-12, everything else less than 1e-13.
constexpr double tolerance = 1e-11;

class Draw {
 public:
  double uniform(double lower, double upper) { return std::uniform_real_distribution<double>(lower, upper)(random_); }
  double decades(double lowest, double highest) { return std::pow(10, uniform(lowest, highest)); }
  template <class T>
  T one_of(const std::vector<T>& values) {
    return values[std::uniform_int_distribution<std::size_t>(0, values.size() - 1)(random_)];
  }
  // Of 1: from 1e-9 to 1 - 1e-12, dense at both ends.
  double share() { return uniform(0, 1) < 0.5 ? decades(-9, 0) : 1 - decades(-12, 0); }

 private:
  std::mt19937 random_{11};
};

void expect_near(double value, const Wide& exact, const Wide& scale, const char* quantity, double within = tolerance) {
  ASSERT_TRUE(std::isfinite(value)) << quantity;
  EXPECT_LE(static_cast<double>(abs(value - exact) / scale), within) << quantity << " = " << value << ", not " << exact;
}

struct PowerScene {
  Profile profile;
  double indentation, modulus, stick_share;
};

PowerScene draw_power_scene(Draw& draw) {
  const double whole = std::floor(draw.uniform(1, 21));
  const double n = draw.one_of<double>({0.5, 1, 2, 20, 1 + 1e-9, 3 - 1e-9, whole, draw.uniform(0.5, 20)});
  const double a = draw.decades(-12, 6), d = draw.decades(-12, 6);
  return {power_law(d / (transform_factor(n) * std::pow(a, n)), n), d, draw.decades(-3, 15), draw.share()};
}

TEST(Extremes, PowerLawsAgreeWithFiftyDigits) {
  Draw draw;
  for (int i = 0; i < 150; ++i) {
    const PowerScene scene = draw_power_scene(draw);
    const Profile& profile = scene.profile;
    const WidePowerLaw exact(std::get<PowerLaw>(profile));
    SCOPED_TRACE(testing::Message() << "n = " << exact.n);
    const double d = scene.indentation, G = scene.modulus;
    const Wide a = exact.g_inverse(d);
    const double radius = contact_radius(profile, d), r = scene.stick_share * radius, out = radius / scene.stick_share;
    expect_near(radius, a, a, "contact radius");
    expect_near(shape(profile, r), exact.f(r), exact.f(a), "shape");
    expect_near(transform(profile, r), exact.g(r), d, "transform");
    expect_near(transform_slope(profile, out), exact.g_slope(out), exact.g_slope(out), "slope");
    expect_near(transform_integral(profile, r), exact.g_integral(r), d * a, "integral");
    expect_near(normal_force(profile, G, d), 8 * Wide(G) * (a * d - exact.g_integral(a)), G * a * d, "force");
    const Wide slope_integral = exact.slope_integral(r, radius);
    expect_near(abel_slope_integral(profile, r, radius), slope_integral, slope_integral, "slope integral");
    expect_near(pressure(profile, G, d, r), 4 * G / wide_pi * slope_integral, G * d / a, "pressure",
                tolerance * static_cast<double>(1 + slope_integral * a / d));
    expect_near(abel_depth_integral(profile, r, out, out), exact.depth_integral_to_edge(r, out), exact.g(out),
                "depth integral to the edge");
    const Wide inner = exact.depth_integral_from_axis(r, out);
    // x^n underflows far inside, where it is nothing against d.
    expect_near(abel_depth_integral(profile, 0, r, out), inner, inner + 1e-50 * d, "depth integral from the axis");
    const Wide edge = a < out ? a : Wide(out);
    const Wide displaced = 2 / wide_pi * (d * asin(edge / out) - exact.depth_integral_from_axis(edge, out));
    expect_near(normal_displacement(profile, d, out), displaced, displaced, "displacement");
  }
}

TEST(Extremes, LimitingProfilesOfPowerLawsAgreeWithFiftyDigits) {
  Draw draw;
  for (int i = 0; i < 200; ++i) {
    const PowerScene scene = draw_power_scene(draw);
    const WidePowerLaw exact(std::get<PowerLaw>(scene.profile));
    const double d = scene.indentation, G = scene.modulus;
    const double a = contact_radius(scene.profile, d), c = scene.stick_share * a;
    SCOPED_TRACE(testing::Message() << "n = " << exact.n << ", c/a = " << scene.stick_share);
    const LimitingProfile worn = limiting_profile(scene.profile, c, d);
    const auto excess = [&](const Wide& r) -> Wide {
      return 2 / wide_pi * (d * acos(c / r) - exact.depth_integral_to_edge(c, r));
    };
    // The surfaces meet within the tolerance of the outer radius; next to c it may be all of the worn zone.
    const Wide outer = worn.outer_radius, before = outer * (1 - Wide(tolerance));
    ASSERT_GE(worn.outer_radius, a);
    EXPECT_LT(excess(outer * (1 + Wide(tolerance))), 0);
    if (before > c) {
      EXPECT_GT(excess(before), 0);
    }
    for (const double share : {draw.decades(-12, 0), draw.uniform(0, 1), 1 - draw.decades(-9, 0)}) {
      const double r = c + share * (worn.outer_radius - c);
      if (r <= c || r >= worn.outer_radius) continue;
      // Relative accuracy wherever the worn depth is of the order of d_max arccos(c/r), the larger of its two parts.
      const Wide angle = atan(sqrt((Wide(r) - c) * (Wide(r) + c)) / c);
      expect_near(worn_depth(worn, r), excess(r), d * angle, "worn depth", 1e-13);
      expect_near(shape(worn, r), excess(r) + exact.f(r), d + exact.f(r), "worn shape");
    }
    const double r = draw.share() * c;
    const EdgeStress stress = limiting_pressure(worn, G, d, r);
    const Wide jump = d - exact.g(c), regular = 4 * G / wide_pi * exact.slope_integral(r, c);
    expect_near(stress.regular, regular, regular + 1e-50 * Wide(G) * d / c, "regular pressure");
    expect_near(stress.intensity, 4 * G / wide_pi * jump, Wide(G) * d, "intensity");
    expect_near(limiting_normal_force(worn, G, d), 8 * Wide(G) * (c * Wide(d) - exact.g_integral(c)), Wide(G) * c * d,
                "force");
  }
}

Profile draw_flat_faced(Draw& draw, double a, double flat_share) {
  const double b = flat_share * a, R = a * draw.decades(-3, 6);
  return draw.one_of<Profile>({rounded_flat(b, R), truncated_sphere(R, b), FlatFaced{b, draw.decades(-6, 1), 0}});
}

TEST(Extremes, FlatFacedProfilesAgreeWithFiftyDigits) {
  Draw draw;
  for (int i = 0; i < 40; ++i) {
    const double a = draw.decades(-12, 6), G = draw.decades(-3, 15);
    const double flat_share = draw.one_of<double>({draw.decades(-9, 0), 1 - draw.decades(-9, 0)});
    const Profile profile = draw_flat_faced(draw, a, flat_share);
    const WideFlatFaced exact(std::get<FlatFaced>(profile));
    SCOPED_TRACE(testing::Message() << "b/a = " << flat_share << ", s = " << exact.s);
    const double b = std::get<FlatFaced>(profile).flat_radius, d = transform(profile, a);
    expect_near(d, exact.g(a), exact.g(a), "transform");
    expect_near(transform_slope(profile, a), exact.g_slope(a), exact.g_slope(a), "slope");
    expect_near(transform_integral(profile, a), exact.g_integral(a), exact.g_integral(a), "integral");
    expect_near(shape(profile, a), exact.f(a), exact.f(a), "shape");
    expect_near(contact_radius(profile, d), a, a, "contact radius");
    expect_near(normal_force(profile, G, d), 8 * Wide(G) * (Wide(a) * d - exact.g_integral(a)), Wide(G) * a * d,
                "force");
    const double c = b + draw.share() * (a - b);
    for (const double r : {b * (1 - draw.decades(-12, 0)), b + draw.decades(-9, 0) * (a - b)}) {
      if (r == b) continue;
      const Wide slope_integral = exact.slope_integral(r, a);
      expect_near(abel_slope_integral(profile, r, a), slope_integral, slope_integral, "slope integral");
    }
    if (c > b && c < a)
      expect_near(abel_depth_integral(profile, c, a, a), exact.depth_integral_to_edge(c, a), d, "depth integral");
    expect_near(abel_depth_integral(profile, 0, a, a), wide_pi / 2 * exact.f(a), exact.f(a), "whole depth integral");
  }
}

TEST(Extremes, LimitingProfilesOfFlatFacesAgreeWithFiftyDigits) {
  Draw draw;
  for (int i = 0; i < 30; ++i) {
    const double a = draw.decades(-12, 6);
    const double flat_share = draw.one_of<double>({draw.decades(-9, 0), 1 - draw.decades(-6, 0)});
    const Profile profile = draw_flat_faced(draw, a, flat_share);
    const WideFlatFaced exact(std::get<FlatFaced>(profile));
    const double b = std::get<FlatFaced>(profile).flat_radius, d = transform(profile, a);
    const double c = std::min(b + draw.share() * (a - b), contact_radius(profile, d));
    SCOPED_TRACE(testing::Message() << "b/a = " << flat_share << ", s = " << exact.s << ", c/a = " << c / a);
    const LimitingProfile worn = limiting_profile(profile, c, d);
    const auto excess = [&](const Wide& r) -> Wide {
      return 2 / wide_pi * (d * acos(c / r) - exact.depth_integral_to_edge(c, r));
    };
    const Wide outer = worn.outer_radius, before = outer * (1 - Wide(1e-10));
    EXPECT_LT(excess(outer * (1 + Wide(1e-10))), 0);
    if (before > c) {
      EXPECT_GT(excess(before), 0);
    }
    const double r = c + draw.share() * (worn.outer_radius - c);
    if (r > c && r < worn.outer_radius)
      expect_near(worn_depth(worn, r), excess(r), d * acos(c / Wide(r)), "worn depth");
    expect_near(limiting_normal_force(worn, 3, d), 24 * (c * Wide(d) - exact.g_integral(c)), 3 * c * Wide(d), "force");
  }
}

// Ten rows a decade of a parabola, which a table interpolates exactly.
TEST(Extremes, TablesOverManyDecadesKeepTheirDigits) {
  std::vector<double> r{0}, f{0};
  for (int k = -90; k <= 0; ++k) {
    r.push_back(std::pow(10, k / 10.0));
    f.push_back(r.back() * r.back() / 4);
  }
  const Profile table = tabulated(r, f), exact = parabola(2);
  for (const double x : {1e-9, 3e-7, 1e-4, 0.02, 0.9}) {
    const double d = transform(exact, x);
    EXPECT_NEAR(transform(table, x) / d, 1, tolerance);
    EXPECT_NEAR(contact_radius(table, d) / x, 1, tolerance);
    EXPECT_NEAR(normal_force(table, 1, d) / normal_force(exact, 1, d), 1, tolerance);
    for (const double s : {0.0, 1e-3, 0.5, 0.999999}) {
      const double at_axis = pressure(exact, 1, d, 0);
      EXPECT_NEAR(pressure(table, 1, d, s * x) / at_axis, pressure(exact, 1, d, s * x) / at_axis, tolerance);
    }
    EXPECT_NEAR(normal_displacement(table, d, 3 * x) / normal_displacement(exact, d, 3 * x), 1, tolerance);
  }
}

// Far away the displacement is that of a point load, F/(4 pi G r), to the order (a/r)^2; x^n is out of range there.
TEST(Extremes, FarFieldsOfSteepProfilesStayInRange) {
  for (const double n : {0.5, 2.0, 20.0}) {
    for (const double r : {1e12, 1e17, 1e60}) {
      const double point = normal_force(power_law(1, n), 3, 0.1) / (12 * pi * r);
      EXPECT_NEAR(normal_displacement(power_law(1, n), 0.1, r) / point, 1, tolerance) << n << " at " << r;
    }
  }
}

TEST(Extremes, TangentialDisplacementNextToTheStickZone) {
  const LimitingProfile worn = limiting_profile(parabola(5), 0.5, 0.2);
  for (const double gap : {1e-15, 1e-12, 1e-6, 1.0, 1e12}) {
    const double r = 0.5 + gap;
    const Wide exact = 2 / wide_pi * asin(Wide(0.5) / r);
    expect_near(limiting_tangential_displacement(worn, 1, r), exact, exact, "tangential displacement", 1e-15);
  }
}

// Dimensionless results of the same case in odd units.
std::vector<double> dimensionless(const Profile& profile, double d, double G, double stick_share) {
  const double a = contact_radius(profile, d), c = stick_share * a;
  const LimitingProfile worn = limiting_profile(profile, c, d);
  std::vector<double> results{
      worn.outer_radius / a, normal_force(profile, G, d) / (G * a * d), pressure(profile, G, d, 0.37 * a) * a / (G * d),
      limiting_normal_force(worn, G, 0.9 * d) / (G * a * d), normal_displacement(profile, d, 1.7 * a) / d};
  for (const double share : {0.01, 0.3, 0.8})
    results.push_back(worn_depth(worn, c + share * (worn.outer_radius - c)) / d);
  return results;
}

void expect_unchanged(const Profile& here, const Profile& there, double length, double height, double stick_share) {
  const double metre = 2.3e5;
  const std::vector<double> before = dimensionless(here, height, 3, stick_share);
  const std::vector<double> after = dimensionless(there, height * length, 3 * metre, stick_share);
  for (std::size_t k = 0; k < before.size(); ++k) EXPECT_NEAR(after[k], before[k], 1e-13 * (1 + before[k])) << k;
}

TEST(Extremes, DoNotDependOnUnits) {
  Draw draw;
  for (int i = 0; i < 100; ++i) {
    const double length = draw.one_of<double>({3.7e-9, 2.3e5, 1 / 3e-7}), stick_share = draw.uniform(0.01, 0.99);
    const double n = draw.one_of<double>({0.5, 1, 2, 4, draw.uniform(0.5, 6)}), b = draw.decades(-1, 1);
    expect_unchanged(power_law(b, n), power_law(b * std::pow(length, 1 - n), n), length, 0.1, stick_share);
    const double flat = draw.uniform(0.01, 1), R = draw.uniform(1, 9);
    expect_unchanged(truncated_sphere(R, flat), truncated_sphere(R * length, flat * length), length, 0.1, stick_share);
    expect_unchanged(rounded_flat(flat, R), rounded_flat(flat * length, R * length), length, 0.1, stick_share);
  }
  std::vector<double> r, f, r_scaled, f_scaled;
  for (int k = 0; k <= 200; ++k) {
    r.push_back(0.01 * k);
    f.push_back(std::pow(r.back(), 3));
    r_scaled.push_back(3.7e-9 * r.back());
    f_scaled.push_back(3.7e-9 * f.back());
  }
  expect_unchanged(tabulated(r, f), tabulated(r_scaled, f_scaled), 3.7e-9, 0.1, 0.6);
}

}  // namespace
}  // namespace fretval::mdr::extremes_test
