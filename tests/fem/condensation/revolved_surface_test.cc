#include "fem/condensation/revolved_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/fem/half_space_field.h"
#include "tests/fem/vtu_data.h"

namespace fretval::fem::revolved_surface_test {
namespace {

constexpr unsigned n_sectors = 12;
constexpr double length = 3, depth = 2, pressure_unit = 5;

/// A surface of 8 rings with these constants as components of its harmonics.
std::string surface_of(const std::vector<double>& normal, const std::vector<double>& tangential) {
  const GridData grid = quarter_disc_grid(1, 8, 6, 0.35);
  const HarmonicSpace space(grid, axisymmetric, 2), other(grid, lateral, 2);
  const auto constants = [](const std::vector<double>& values) {
    return [&values](unsigned c, double, double) { return c < values.size() ? values[c] : 0; };
  };
  const Eigen::VectorXd field = field_of(space, constants(normal)), beside = field_of(other, constants(tangential));
  const Eigen::VectorXd unused = Eigen::VectorXd::Zero(0);
  RingTractions rings{Eigen::VectorXd::LinSpaced(8, 8, 1), Eigen::VectorXd::LinSpaced(8, -4, 3),
                      std::vector<RingZone>(8, RingZone::sticks)};
  rings.zones[3] = RingZone::slips_backward;
  std::ostringstream stream;
  BodyState state{{space, field, unused}, std::nullopt};
  state.tangential.emplace(HarmonicState{other, beside, unused});
  write_revolved_surface(state, rings, {length, depth, pressure_unit}, n_sectors, stream);
  return stream.str();
}

// Four corners a piece, twelve pieces a ring, the rings an eighth of 3 m wide.
TEST(RevolvedSurface, HasThePiecesOfEveryRing) {
  const auto points = vtu_data(surface_of({}, {}), "");
  ASSERT_EQ(points.size(), 3U * 4 * n_sectors * 8);
  for (std::size_t k = 0; k < points.size() / 3; ++k) {
    const auto ring = static_cast<double>(k / (4 * n_sectors)), corner = ring + static_cast<double>(k % 2);
    EXPECT_NEAR(std::hypot(points[3 * k], points[3 * k + 1]), corner / 8 * length, 1e-6);
    EXPECT_EQ(points[3 * k + 2], 0);
  }
}

// The indenter presses down, which is along z, and drags along x, all around.
TEST(RevolvedSurface, HasTheTractionsOnItsRings) {
  const std::string file = surface_of({}, {});
  const auto t = vtu_data(file, "traction (Pa)"), p = vtu_data(file, "contact pressure (Pa)"),
             tau = vtu_data(file, "shear traction (Pa)"),
             zone = vtu_data(file, "zone (0 open, 1 sticks, 2 slips forward, 3 backward)");
  ASSERT_EQ(p.size(), 4U * n_sectors * 8);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const auto ring = static_cast<int>(k / (4 * n_sectors));
    EXPECT_FLOAT_EQ(p[k], static_cast<float>(pressure_unit * (8 - ring)));
    EXPECT_FLOAT_EQ(tau[k], static_cast<float>(pressure_unit * (ring - 4)));
    EXPECT_EQ(t[3 * k], tau[k]);
    EXPECT_EQ(t[3 * k + 1], 0);
    EXPECT_EQ(t[3 * k + 2], p[k]);
    EXPECT_EQ(zone[k], ring == 3 ? 3 : 1);
  }
}

// s = 0.5 moves the body along x; m = 0.25 is u_r = m cos(theta), u_theta = m sin(theta), which doubles the angle. U
// counts inwards, W down in the normal harmonic and up in the other one.
TEST(RevolvedSurface, TurnsTheDisplacementsAroundTheAxis) {
  const std::string file = surface_of({0.375, 0.75}, {0.5, 0.25, 0.125});
  const auto points = vtu_data(file, ""), u = vtu_data(file, "displacement (m)");
  for (std::size_t k = 0; k < u.size() / 3; ++k) {
    if (std::hypot(points[3 * k], points[3 * k + 1]) < 1e-6) continue;  // the angle is that of the piece
    const double theta = std::atan2(points[3 * k + 1], points[3 * k]), c = std::cos(theta), s = std::sin(theta);
    EXPECT_NEAR(u[3 * k], depth * (0.5 + 0.25 * std::cos(2 * theta) - 0.375 * c), 1e-5);
    EXPECT_NEAR(u[3 * k + 1], depth * (0.25 * std::sin(2 * theta) - 0.375 * s), 1e-5);
    EXPECT_NEAR(u[3 * k + 2], depth * (0.75 - 0.125 * c), 1e-5);
  }
}

}  // namespace
}  // namespace fretval::fem::revolved_surface_test
