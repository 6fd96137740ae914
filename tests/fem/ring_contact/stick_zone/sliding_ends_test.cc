#include "fem/ring_contact/stick_zone/sliding_ends.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"

namespace fretval::fem::sliding_ends_test {
namespace {

/// One ring of stiffness 1 under an oscillating pressure, moved to and fro by steps of the law that FrictionContact
/// has: it sticks unless that exceeds the limit at the end of the step.
struct OneRing {
  NormalHistory normal;
  FrictionHistory friction;
  Eigen::VectorXd along;
  double work;
};

constexpr double mu = 0.5;

OneRing stepped(int n) {
  const auto press = [](double t) { return 1 + 0.5 * std::cos(t + 0.4); };
  const auto move = [](double t) { return 2 * std::sin(t); };
  OneRing ring;
  const double dt = 2 * pi / n;
  ring.normal.steps_per_cycle = n;
  ring.normal.pressure.resize(1, n);
  ring.friction.traction.resize(1, n);
  ring.along.resize(n);
  double force = 0;
  for (int k = -n; k < n; ++k) {
    const double t = k * dt, limit = mu * press(t);
    force = std::min(std::max(force + move(t) - move(t - dt), -limit), limit);
    if (k < 0) continue;
    ring.normal.pressure(0, k) = press(t);
    ring.friction.traction(0, k) = force;
    ring.along[k] = 2 * std::cos(t) * dt;
  }
  ring.normal.force = ring.normal.pressure.row(0);
  ring.normal.force_beyond = Eigen::VectorXd::Zero(n);
  ring.friction.force = ring.friction.traction.row(0);
  ring.friction.n_steps = 2L * n;
  ring.work = ring.friction.force.dot(ring.along);
  return ring;
}

SlidingEnds ends_of(const OneRing& ring) {
  return sliding_ends(mu, ring.normal, ring.friction, ring.along, true);
}

// The work of very small steps; coarse steps are off by what their number makes of the instants, 0 among them.
TEST(SlidingEnds, BoundWhatStepsLockIn) {
  const double exact = stepped(40000).work;
  double largest = 0;
  for (int n = 24; n <= 120; n += 3) {
    const auto ring = stepped(n);
    const double error = std::abs(ring.work - exact), bound = ends_of(ring).work;
    EXPECT_LT(error, 1.5 * bound) << n;  // the sum over the steps is of second order as well
    largest = std::max(largest, error / bound);
  }
  EXPECT_GT(largest, 0.3) << "no order of magnitude too much";
}

TEST(SlidingEnds, FallWithTheSecondPowerOfTheSteps) {
  const auto coarse = ends_of(stepped(100)), fine = ends_of(stepped(400));
  EXPECT_NEAR(coarse.work / fine.work, 16, 3);
  EXPECT_NEAR(coarse.force / fine.force, 16, 3);
  EXPECT_LT(fine.mean_force, fine.force);
  EXPECT_GT(fine.mean_force, 0);
}

TEST(SlidingEnds, AreNoneWhereSomethingSticksThroughout) {
  auto ring = stepped(60);
  ring.normal.pressure.conservativeResize(2, Eigen::NoChange);
  ring.friction.traction.conservativeResize(2, Eigen::NoChange);
  ring.normal.pressure.row(1).setOnes();
  ring.friction.traction.row(1).setZero();
  EXPECT_EQ(ends_of(ring).work, 0);
  EXPECT_EQ(sliding_ends(mu, {}, {}, {}, true).force, 0) << "no steps";
}

}  // namespace
}  // namespace fretval::fem::sliding_ends_test
