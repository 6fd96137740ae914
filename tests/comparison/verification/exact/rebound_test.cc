#include "comparison/verification/exact/rebound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace fretval {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Hertz' impact: `m v^2/2 = (32/15) G d^(5/2)`, F = (16/3) G d^(3/2), duration `(2 d/v) int_0^1 dx/sqrt(1 - x^(5/2))`.
Rebound hertz(double modulus, const Impact& impact) {
  const double kinetic = impact.mass * impact.velocity * impact.velocity / 2;
  const double depth = std::pow(15 * kinetic / (32 * modulus), 0.4);
  const double integral = std::sqrt(pi) * std::tgamma(1.4) / std::tgamma(0.9);
  return {1, 16.0 / 3 * modulus * std::pow(depth, 1.5), 2 * depth / impact.velocity * integral};
}

void expect_near(const Rebound& rebound, const Rebound& expected, double tolerance) {
  EXPECT_NEAR(rebound.restitution, expected.restitution, tolerance);
  EXPECT_NEAR(rebound.largest_force, expected.largest_force, tolerance * expected.largest_force);
  EXPECT_NEAR(rebound.duration, expected.duration, tolerance * expected.duration);
}

// 1e-9 of the Runge-Kutta steps at the end of the contact, where the force is not smooth.
TEST(Rebound, IsHertzianFromAnElasticBody) {
  for (const Impact& impact : {Impact{1, 1}, Impact{3, 0.2}})
    expect_near(exact_rebound(mdr::elastic(2), impact), hertz(2, impact), 3e-9);
}

// A branch much slower than the contact adds its modulus and dissipates in proportion to duration over its time.
TEST(Rebound, IsHertzianFromABranchThatIsTooSlow) {
  const Impact impact{1, 1};
  expect_near(exact_rebound(mdr::standard_solid(1, 2, 1e6), impact), hertz(3, impact), 3e-6);
}

// A branch much faster than the contact dissipates in proportion to its time over the duration.
TEST(Rebound, TendsToHertzForAFastBranch) {
  const Impact impact{1, 1};
  const auto loss = [&](double time) {
    return 1 - exact_rebound(mdr::standard_solid(1, 2, time), impact, 4000).restitution;
  };
  EXPECT_LT(loss(1e-2), 0.1);
  EXPECT_NEAR(loss(1e-2) / loss(5e-3), 2, 0.1);
}

TEST(Rebound, DoesNotDependOnItsSteps) {
  for (const auto& body : {mdr::standard_solid(1, 2, 0.4), mdr::prony(1, {1, 1}, {0.1, 2})}) {
    const Impact impact{1, 2.8};
    const auto rebound = exact_rebound(body, impact);
    EXPECT_LT(rebound.restitution, 0.8);
    EXPECT_GT(rebound.restitution, 0.4);
    expect_near(exact_rebound(body, impact, 2000), rebound, 1e-9);
  }
}

TEST(Rebound, RefusesWhatItDoesNotCover) {
  EXPECT_THROW(exact_rebound(mdr::kelvin_voigt(1, 1), {1, 1}), std::invalid_argument);
  EXPECT_THROW(exact_rebound(mdr::elastic(1), {0, 1}), std::invalid_argument);
  EXPECT_THROW(exact_rebound(mdr::elastic(1), {1, -1}), std::invalid_argument);
}

}  // namespace
}  // namespace fretval
