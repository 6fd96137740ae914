#include "fem/condensation/meridian_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "tests/fem/half_space_field.h"
#include "tests/fem/vtu_data.h"

namespace fretval::fem::meridian_section_test {
namespace {

using Components = std::function<double(unsigned, double, double)>;

double nothing(unsigned, double, double) {
  return 0;
}

/// What is at a point of a section.
struct Point {
  double x, z;
  std::array<double, 3> u;
  double xx, xz, yy, zz, pressure, mises;
};

constexpr double length = 3, depth = 2, pressure_unit = 5;

/// Lengths of 3 m, depths of 2 m, stresses of 5 Pa, on a disc of 6 units.
std::vector<Point> section_of(const Components& normal, const Components& tangential) {
  const GridData grid = quarter_disc_grid(1, 8, 6, 0.35);
  const HarmonicSpace space(grid, axisymmetric, 3), other(grid, lateral, 3);
  const Eigen::VectorXd field = field_of(space, normal), beside = field_of(other, tangential);
  std::ostringstream stream;
  BodyState state{{space, field, field}, std::nullopt};
  state.tangential.emplace(HarmonicState{other, beside, beside});
  write_meridian_section(state, {length, depth, pressure_unit}, stream);
  const std::string file = stream.str();
  const auto x = vtu_data(file, ""), u = vtu_data(file, "displacement (m)"), s = vtu_data(file, "stress (Pa)"),
             p = vtu_data(file, "pressure (Pa)"), mises = vtu_data(file, "von Mises stress (Pa)");
  std::vector<Point> points;
  for (std::size_t k = 0; k < p.size(); ++k) {
    for (const std::size_t zero : {1, 3, 5, 7}) EXPECT_EQ(s[9 * k + zero], 0) << "the plane is one of symmetry";
    EXPECT_EQ(s[9 * k + 2], s[9 * k + 6]);
    EXPECT_EQ(x[3 * k + 1], 0);
    points.push_back({x[3 * k],
                      x[3 * k + 2],
                      {u[3 * k], u[3 * k + 1], u[3 * k + 2]},
                      s[9 * k],
                      s[9 * k + 2],
                      s[9 * k + 4],
                      s[9 * k + 8],
                      p[k],
                      mises[k]});
  }
  EXPECT_GT(points.size(), 100U);
  return points;
}

constexpr double precision = 1e-5;  // of the numbers in the file, which are of the order of 100

// Components U and W of the normal harmonic count inwards and down.
TEST(MeridianSection, FillsBothSidesBelowTheSurfaceInMetres) {
  double left = 0, right = 0, top = 1, bottom = 0;
  for (const auto& at : section_of([](unsigned c, double, double) { return c == 1 ? 0.75 : 0; }, nothing)) {
    left = std::min(left, at.x);
    right = std::max(right, at.x);
    top = std::min(top, at.z);
    bottom = std::max(bottom, at.z);
    EXPECT_FLOAT_EQ(static_cast<float>(at.u[2]), depth * 0.75);
    EXPECT_EQ(at.u[0], 0);
  }
  EXPECT_FLOAT_EQ(static_cast<float>(right), 6 * length);
  EXPECT_FLOAT_EQ(static_cast<float>(left), -6 * length);
  EXPECT_EQ(top, 0);
  EXPECT_FLOAT_EQ(static_cast<float>(bottom), 6 * length);
}

// u_z = b r^2, both down and z downwards: sigma_xz = 2 b x.
TEST(MeridianSection, HasTheShearOfASurfaceThatSinksUnevenly) {
  constexpr double b = 0.05;
  for (const auto& at : section_of([](unsigned c, double r, double) { return c == 1 ? b * r * r : 0; }, nothing))
    EXPECT_NEAR(at.xz / pressure_unit, 2 * b * at.x / length, precision);
}

// u_x = e x, u_y = e y, u_z = -2 e z under a pressure p, e = 0.5, p = 0.25: stress 2 eps - p.
TEST(MeridianSection, HasTheStressesOfAUniformExpansion) {
  constexpr double e = 0.5, p = 0.25;
  const auto expansion = [](unsigned c, double r, double z) {
    return c == 0 ? -e * r : c == 1 ? 2 * e * z : -p;  // z up
  };
  for (const auto& at : section_of(expansion, nothing)) {
    EXPECT_NEAR(at.u[0] / depth, e * at.x / length, precision);
    EXPECT_NEAR(at.u[2] / depth, -2 * e * at.z / length, precision);
    EXPECT_NEAR(at.xx / pressure_unit, 2 * e - p, precision);
    EXPECT_NEAR(at.yy / pressure_unit, 2 * e - p, precision);
    EXPECT_NEAR(at.zz / pressure_unit, -4 * e - p, precision);
    EXPECT_NEAR(at.xz / pressure_unit, 0, precision);
    EXPECT_NEAR(at.pressure / pressure_unit, p, precision);
    EXPECT_NEAR(at.mises / pressure_unit, 6 * e, precision);
  }
}

// u_x = g z, the whole depth moves along x; of the normal harmonic u_r = h r z, u_z = -h z^2, whose shear is h r / 2.
TEST(MeridianSection, HasTheShearOfBothHarmonics) {
  constexpr double g = 0.5, h = 0.125;
  const auto shear = [](unsigned c, double, double z) { return c == 0 ? -g * z : 0; };
  const auto radial = [](unsigned c, double r, double z) { return c == 0 ? h * r * z : c == 1 ? -h * z * z : 0; };
  for (const auto& at : section_of(radial, shear)) {
    const double x = at.x / length, z = at.z / length;
    EXPECT_NEAR(at.u[0] / depth, g * z + h * x * z, 10 * precision);
    EXPECT_NEAR(at.xz / pressure_unit, g + h * x, precision);
    EXPECT_NEAR(at.xx / pressure_unit, 2 * h * z, precision);
    EXPECT_NEAR(at.zz / pressure_unit, -4 * h * z, precision);
    EXPECT_NEAR(std::pow(at.mises, 2), std::pow(6 * h * z * pressure_unit, 2) + 3 * std::pow(at.xz, 2), 1e-2);
  }
}

// u_r = c r^2 cos(theta), u_theta = -3 c r^2 sin(theta) has no divergence: eps_rr = 2 c r = -eps_tt at theta = 0. On
// the axis, where a component is divided by the radius, all vanishes. u_z = b r cos(theta) tilts the body.
TEST(MeridianSection, AddsTheFirstHarmonicOnOneSideAndSubtractsItOnTheOther) {
  constexpr double c = 0.25, b = 0.5, p = 0.125;
  const auto odd = [](unsigned component, double r, double) {
    return component == 0 ? 2 * c * r * r : component == 1 ? -c * r * r : component == 2 ? -b * r : p * r;
  };
  for (const auto& at : section_of(nothing, odd)) {
    const double x = at.x / length;
    EXPECT_NEAR(at.u[0] / depth, c * x * x, 10 * precision);
    EXPECT_NEAR(at.u[2] / depth, b * x, precision);
    EXPECT_NEAR(at.pressure / pressure_unit, p * x, precision);
    EXPECT_NEAR(at.xx / pressure_unit, 4 * c * x - p * x, precision);
    EXPECT_NEAR(at.yy / pressure_unit, -4 * c * x - p * x, precision);
    EXPECT_NEAR(at.zz / pressure_unit, -p * x, precision);
    EXPECT_NEAR(at.xz / pressure_unit, b, precision);
  }
}

// Displacements and stresses are those of two bodies.
TEST(MeridianSection, KeepsDisplacementsAndStressesApart) {
  const HarmonicSpace space(quarter_disc_grid(1, 8, 6, 0.35), axisymmetric, 2);
  const Eigen::VectorXd sunk = field_of(space, [](unsigned c, double, double) { return c == 1 ? 1 : 0; }),
                        pressed = field_of(space, [](unsigned c, double, double) { return c == 2 ? -1 : 0; });
  std::ostringstream stream;
  write_meridian_section({{space, sunk, pressed}, std::nullopt}, {1, 1, 1}, stream);
  for (const float p : vtu_data(stream.str(), "pressure (Pa)")) EXPECT_FLOAT_EQ(p, 1);
  const auto u = vtu_data(stream.str(), "displacement (m)");
  for (std::size_t k = 2; k < u.size(); k += 3) EXPECT_FLOAT_EQ(u[k], 1);
}

}  // namespace
}  // namespace fretval::fem::meridian_section_test
