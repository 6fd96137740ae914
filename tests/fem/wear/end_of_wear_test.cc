#include "fem/wear/end_of_wear.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/fem/wear/wearing_half_space.h"

namespace fretval::fem::end_of_wear_test {
namespace {

constexpr WearLaw archard{1e-3};
constexpr double coarse_jump = 0.02;  // where wear ends does not depend on it

/// A scene that sticks within another radius: by the tangential amplitude, as WearingHalfSpace has it.
WearingHalfSpace sticking_within(double c, unsigned n_per_radius = 32) {
  WearingHalfSpace scene(n_per_radius);
  const double both = WearingHalfSpace::mean_indentation - c * c;
  scene.motion.tangential[0].amplitude =
      1.5 * WearingHalfSpace::mu * std::sqrt(both * both - std::pow(WearingHalfSpace::normal_amplitude, 2));
  return scene;
}

EndOfWear end_of(const WearingHalfSpace& scene, const WearCourse& course) {
  return end_of_wear({scene.normal, scene.tangential, scene.body, scene.motion, scene.n_steps, WearingHalfSpace::mu},
                     scene.profile, course);
}

/// Volume up to the limiting profile of a stick radius.
double volume_of_limit(const WearingHalfSpace& scene, double c) {
  const auto worn = ring_means(scene.normal.compliance, [&](double r) { return scene.limit(r, c) - r * r / 2; }, {c});
  return scene.normal.compliance.areas.dot(worn);
}

/// By how much a volume is off that of the limit, and the radius off c, while c goes through parts of a ring of 1/32.
struct Staircase {
  std::vector<double> whole, shared;
  double radius_error = 0;

  void add(const WearingHalfSpace& scene, double c) {
    const auto course = scene.course(archard, coarse_jump);
    const auto end = end_of(scene, course);
    EXPECT_TRUE(end.is_shared);
    const double limit = volume_of_limit(scene, c);
    whole.push_back(course.curve.back().volume / limit - 1);
    shared.push_back(scene.normal.compliance.areas.dot(end.worn) / limit - 1);
    radius_error = std::max(radius_error, std::abs(end.stick.radius - c));
  }
};

double largest_step(const std::vector<double>& values) {
  double largest = 0;
  for (std::size_t i = 1; i < values.size(); ++i) largest = std::max(largest, std::abs(values[i] - values[i - 1]));
  return largest;
}

constexpr double eighth_of_ring = 1.0 / 8 / 32;

// The closed form of the limit changes smoothly with c. By whole rings the volume is off by up to half a ring and jumps
// by one; what is left is of the second order in the rings, most of it at the outer edge.
TEST(EndOfWear, IsASmoothFunctionOfTheData) {
  Staircase stairs;
  for (int k = -6; k <= 6; ++k) {
    const double c = WearingHalfSpace::stick_radius + k * eighth_of_ring;
    stairs.add(sticking_within(c), c);
  }
  EXPECT_GT(largest_step(stairs.whole), 0.1);
  EXPECT_LT(largest_step(stairs.shared), 2e-3);
  for (const double error : stairs.shared) EXPECT_LT(std::abs(error), 3e-3);
  EXPECT_LT(stairs.radius_error, 2e-6);
}

// The edge does not depend on where the data have put it among the rings: the same end to roundoff but for that.
TEST(EndOfWear, FindsTheEdgeWithThirdOrder) {
  const auto error = [](unsigned n_per_radius) {
    const auto scene = sticking_within(WearingHalfSpace::stick_radius, n_per_radius);
    const auto end = end_of(scene, scene.course(archard, coarse_jump));
    return std::abs(end.stick.radius - WearingHalfSpace::stick_radius);
  };
  EXPECT_GT(error(16) / error(32), 6);
}

// A constant normal force and an oscillating tangential one, as in WearCourse.UnderForcesSinksIntoTheLimitingState: in
// its end the indenter is pressed in by 1. Discs of whole rings bear the force at another depth.
TEST(EndOfWear, UnderForcesIsThatOfTheDiscWhichBearsThem) {
  Staircase stairs;
  for (int k = -4; k <= -1; ++k) {
    WearingHalfSpace scene;
    const double c = scene.effective_stick_radius() + k * eighth_of_ring, cubed = c * c * c,
                 force = 8 * (c - cubed / 3),
                 tangential = WearingHalfSpace::mu * force * (1 - cubed / (3 * force / 16));
    scene.motion = one_frequency(force, 0, tangential, pi / 2);
    scene.motion.normal_force = scene.motion.tangential_force = true;
    stairs.add(scene, c);
  }
  EXPECT_GT(largest_step(stairs.whole), 0.2);
  EXPECT_LT(largest_step(stairs.shared), 1e-2);
  EXPECT_LT(stairs.radius_error, 2e-3);
}

// Rings that slip are pressed as well while wear goes on, and in phase all that touches sticks.
TEST(EndOfWear, IsThatOfWholeRingsWhereItIsNotTheLimit) {
  const WearingHalfSpace scene;
  const auto on_its_way = scene.course(archard, coarse_jump, 500);
  WearingHalfSpace in_phase;
  in_phase.motion = one_frequency(WearingHalfSpace::mean_indentation, WearingHalfSpace::normal_amplitude, 0.05, 0);
  const auto sticks = in_phase.course(archard, coarse_jump, 500);
  const auto expect_whole_rings = [](const WearingHalfSpace& of, const WearCourse& course) {
    const auto end = end_of(of, course);
    EXPECT_FALSE(end.is_shared);
    EXPECT_EQ(end.stick.radius, course.curve.back().stick_radius);
    EXPECT_NEAR(end.stick.uncertainty, 1.0 / 32, 1e-12);
    EXPECT_EQ(end.worn, course.worn.back());
  };
  expect_whole_rings(scene, on_its_way);
  expect_whole_rings(in_phase, sticks);
}

}  // namespace
}  // namespace fretval::fem::end_of_wear_test
