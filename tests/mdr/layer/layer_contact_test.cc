#include "mdr/layer/layer_contact.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

#include "mdr/profiles/indentation.h"
#include "mdr/support/constants.h"
#include "tests/mdr/error_of.h"
#include "tests/mdr/layer/layer_surface.h"

namespace fretval::mdr::layer_contact_test {
namespace {

using boost::math::quadrature::gauss_kronrod;

const std::vector<Profile>& profiles() {
  static const std::vector<Profile> all{parabola(1),
                                        cone(0.3),
                                        power_law(0.4, 1.5),
                                        power_law(0.3, 4),
                                        sphere(3),
                                        rounded_flat(0.4, 1),
                                        truncated_sphere(1, 0.5)};
  return all;
}

// a/H = 1e-5 leaves L - 1 a share of 1e-5: kernel 0.
TEST(LayerContact, OfAThickLayerIsTheHalfSpace) {
  for (const Profile& profile : profiles()) {
    const LayerContact contact = layer_contact(profile, {1e5, 0.5}, 1);
    EXPECT_NEAR(contact.indentation / transform(profile, 1), 1, 2e-5);
    EXPECT_NEAR(normal_force(contact, 2) / mdr::normal_force(profile, 2, transform(profile, 1)), 1, 2e-5);
    for (const double r : {0.1, 0.7, 0.95})
      EXPECT_NEAR(pressure(contact, 2, r) / mdr::pressure(profile, 2, transform(profile, 1), r), 1, 4e-5);
  }
  // Poisson's ratio is in E* alone.
  EXPECT_NEAR(normal_force(layer_contact(parabola(1), {1e5, 0.2}, 1), 1), 8.0 / 3 / 0.8, 1e-4);
}

// Without a kernel the row is one of independent springs, to roundoff.
TEST(LayerContact, OfInfiniteThicknessIsTheHalfSpaceToRoundoff) {
  const Layer half_space{std::numeric_limits<double>::infinity(), 0.5};
  for (const Profile& profile : profiles()) {
    const LayerContact contact = layer_contact(profile, half_space, 1);
    EXPECT_NEAR(contact.indentation / transform(profile, 1), 1, 1e-14);
    EXPECT_NEAR(normal_force(contact, 2) / mdr::normal_force(profile, 2, transform(profile, 1)), 1, 1e-9);
    EXPECT_NEAR(pressure(contact, 2, 0.7), mdr::pressure(profile, 2, transform(profile, 1), 0.7), 1e-13);
  }
  EXPECT_NEAR(layer_punch(half_space, Direction::tangential, 2).load, 2, 1e-14);
}

// What rings of a layer gave, 128 of them, added up one by one: to the digits that were noted.
TEST(LayerContact, DepthForceAndPunchesOnABondedIncompressibleLayer) {
  const auto at = [](double thickness) { return Layer{thickness, 0.5}; };
  const LayerContact thick = layer_contact(parabola(1), at(10), 1), thin = layer_contact(parabola(1), at(2), 1);
  EXPECT_NEAR(thick.indentation, 0.926, 5e-4);
  EXPECT_NEAR(thin.indentation, 0.696, 5e-4);
  EXPECT_NEAR(thick.load * 1.5, 1.001, 5e-4);
  EXPECT_NEAR(thin.load * 1.5, 1.08, 5e-3);
  EXPECT_NEAR(layer_punch(at(10), Direction::normal, 1).load, 1.13, 5e-3);
  EXPECT_NEAR(layer_punch(at(2), Direction::normal, 1).load, 1.93, 5e-3);
  EXPECT_NEAR(layer_punch(at(10), Direction::tangential, 1).load, 1.05, 5e-3);
  EXPECT_NEAR(layer_punch(at(2), Direction::tangential, 1).load, 1.25, 5e-3);
}

// Waves beyond kappa = 8 cost 1e-6 of the change, quadrature of the tables of pressures less.
TEST(LayerContact, PressesTheSurfaceIntoTheShapeOfTheIndenter) {
  for (const Layer& layer : {Layer{1, 0.5}, Layer{0.5, 0.3}, Layer{1.5, 0, LayerBase::frictionless}}) {
    for (const Profile& profile : {parabola(1), power_law(0.3, 4)}) {
      const LayerContact contact = layer_contact(profile, layer, 1);
      for (const double r : {0.0, 0.4, 0.9})
        EXPECT_NEAR(surface_displacement(
                        layer, 1, [&](double s) { return pressure(contact, 1, s); }, r),
                    contact.indentation - shape(profile, r), 3e-6 * contact.indentation);
    }
  }
}

TEST(LayerContact, PressureAddsUpToTheForce) {
  for (const Profile& profile : {parabola(1), sphere(3), power_law(0.3, 4)}) {
    for (const double thickness : {2.0, 0.3}) {
      const LayerContact contact = layer_contact(profile, {thickness, 0.45}, 1);
      const double sum = gauss_kronrod<double, 31>::integrate(
          [&](double angle) {
            return 2 * pi * pressure(contact, 1, std::sin(angle)) * std::sin(angle) * std::cos(angle);
          },
          0, pi / 2, 5, 1e-10);
      EXPECT_NEAR(sum / normal_force(contact, 1), 1, 1e-10);
    }
  }
}

// A compressible thin layer is a mattress of modulus M/H, M = 2 G (1-nu)/(1-2 nu), an incompressible one a film whose
// pressure drives a flow: p = 3 G d (a^2-r^2)/(4 H^3). The edge adds some H to the radius: two radii remove it, and
// leave (H/a)^2, some 1e-3.
TEST(LayerContact, PunchesOnThinLayersAreWinklersAndThatOfAFilm) {
  const auto limit = [](double nu, Direction direction, int power, double leading) {
    const auto edge = [&](double a) {  // a + what the edge adds, for power: F ~ (a + edge)^power
      return std::pow(punch_stiffness(layer_punch({1, nu}, direction, a), 1) / leading, 1.0 / power);
    };
    return (edge(40) - edge(20)) / 20;
  };
  const double nu = 0.3;
  EXPECT_NEAR(limit(nu, Direction::normal, 2, pi * 2 * (1 - nu) / (1 - 2 * nu)), 1, 1e-3);
  EXPECT_NEAR(limit(nu, Direction::tangential, 2, pi), 1, 1e-3);
  EXPECT_NEAR(limit(0.5, Direction::tangential, 2, pi), 1, 1e-3);
  EXPECT_NEAR(limit(0.5, Direction::normal, 4, 3 * pi / 8), 1, 1e-3);
}

// On a mattress a parabola sinks in by a^2/(2R), into a film by a^2/(4R), what it displaces going up around it.
TEST(LayerContact, ParabolasOnThinLayers) {
  const double a = 60;
  const LayerContact mattress = layer_contact(parabola(1), {1, 0}, a), film = layer_contact(parabola(1), {1, 0.5}, a);
  EXPECT_NEAR(mattress.indentation / (a * a / 2), 1, 3 / a);
  EXPECT_NEAR(normal_force(mattress, 1) / (pi / 4 * 2 * std::pow(a, 4)), 1, 4 / a);
  EXPECT_NEAR(film.indentation / (a * a / 4), 1, 4 / a);
  // p = 3 G/(16 H^3 R) (a^2-r^2)^2/4: F = pi a^6/(32 R) G/H^3.
  EXPECT_NEAR(normal_force(film, 1) / (pi / 32 * std::pow(a, 6)), 1, 10 / a);  // six times what the edge adds, 1.5 H
}

TEST(LayerContact, DepthAndForceFindTheirRadius) {
  for (const Profile& profile : profiles()) {
    for (const Layer& layer : {Layer{5, 0.5}, Layer{0.4, 0.3}, Layer{0.4, 0.45, LayerBase::frictionless}}) {
      const LayerContact contact = layer_contact(profile, layer, 0.8);
      EXPECT_NEAR(layer_contact_at_depth(profile, layer, contact.indentation).contact_radius, 0.8, 1e-11);
      EXPECT_NEAR(layer_contact_under_force(profile, layer, 3, normal_force(contact, 3)).contact_radius, 0.8, 1e-11);
    }
  }
}

// The work of pressing the indenter in is the same whether seen from the force or from the depth: F = dU/dd with
// U = int q w dx, which ties both to each other.
TEST(LayerContact, ForceIsTheSlopeOfTheEnergy) {
  const Layer layer{0.7, 0.45};
  const auto energy = [&](double a) {
    const LayerContact contact = layer_contact(parabola(1), layer, a);
    const Eigen::ArrayXd w = contact.indentation - contact.rule.point.square();
    return (contact.rule.weight * w * contact.at_points).sum();  // U/E*, both sides and the half of it
  };
  const double a = 0.9, h = 1e-4;
  const auto depth = [&](double at) { return layer_contact(parabola(1), layer, at).indentation; };
  EXPECT_NEAR((energy(a + h) - energy(a - h)) / (depth(a + h) - depth(a - h)),
              2 * layer_contact(parabola(1), layer, a).load, 1e-7);  // h^2
}

TEST(LayerContact, ConvergesSpectrallyAndKinksCostNothing) {
  for (const Profile& profile : profiles()) {
    const Layer layer{0.5, 0.5};
    const LayerContact coarse = layer_contact(profile, layer, 1), fine = layer_contact(profile, layer, 1, {32});
    EXPECT_NEAR(coarse.load / fine.load, 1, 1e-11);
    EXPECT_NEAR(coarse.indentation / fine.indentation, 1, 1e-11);
  }
}

TEST(LayerContact, FreeSurfaceGoesOnFromTheContact) {
  const LayerContact contact = layer_contact(parabola(1), {1, 0.5}, 1);
  EXPECT_NEAR(spring_depth(contact, 1 - 1e-9), spring_depth(contact, 1 + 1e-9), 1e-8);
  EXPECT_LT(spring_depth(contact, 1.4), 0);  // the volume goes up beside it
  EXPECT_EQ(spring_load(contact, 1.1), 0);
  EXPECT_NEAR(spring_load(contact, 1 - 1e-9), 0, 1e-8);
}

TEST(LayerContact, RejectsBadArguments) {
  const Layer layer{1, 0.5};
  EXPECT_NE(error_of([&] { layer_contact(parabola(1), layer, 0); }).find("contact radius"), std::string::npos);
  EXPECT_NE(error_of([&] { layer_contact_at_depth(parabola(1), layer, 0); }).find("indentation"), std::string::npos);
  EXPECT_NE(error_of([&] { layer_contact_under_force(parabola(1), layer, 1, -1); }).find("force"), std::string::npos);
  EXPECT_NE(error_of([&] { layer_contact(parabola(1), {1, 0.6}, 1); }).find("Poisson"), std::string::npos);
  EXPECT_NE(error_of([&] { layer_contact(parabola(1), {1e-3, 0.5}, 1); }).find("thickness"), std::string::npos);
  EXPECT_NE(error_of([&] {
              layer_punch({1, 0.5, LayerBase::frictionless}, Direction::tangential, 1);
            }).find("frictionless"),
            std::string::npos);
  EXPECT_NE(error_of([&] {
              layer_contact_at_depth(tabulated({0, 0.5, 1, 1.5}, {0, 0.25, 1, 2.25}), {1, 0.5}, 9);
            }).find("end of the profile"),
            std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::layer_contact_test
