#include "fem/ring_contact/contact_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "fem/ring_contact/ring_courses.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"
#include "tests/worse.h"

namespace fretval::fem::contact_force_test {
namespace {

using Eigen::Index;

class ContactForceTest : public testing::Test {
 protected:
  const ContactProblem& problem_ = normal_half_space(32);
  const PunchSeries& series_ = problem_.series;
  static constexpr double ring_ = 1.0 / 32;
};

// Hertz: F = (16/3) G sqrt(R) d^1.5, R = 1, at eleven positions of the edge within its ring. The plain sum is of second
// order (3e-4), the integral of third (7e-7); without the zone of the free rings it would not find the edge.
TEST_F(ContactForceTest, IsHertzWhereverTheEdgeIs) {
  double worst = 0, worst_sum = 0, worst_without_zones = 0;
  for (int k = 0; k <= 10; ++k) {
    const double radius = 0.9 + ring_ * k / 10, exact = 16.0 / 3 * radius * radius * radius;
    const auto [pressure, gap] = hertz_contact(problem_, radius * radius);
    const auto contact = contact_force(series_, pressure, gap);
    worst = worse(worst, std::abs(contact.force / exact - 1));
    EXPECT_NEAR(contact.radius, radius, 1e-5);  // third order
    EXPECT_LT(contact.uncertainty, 1e-6 * exact);
    worst_sum = worse(worst_sum, std::abs(pressure.dot(problem_.compliance.areas) / exact - 1));
    const std::vector<signed char> one_zone(static_cast<std::size_t>(pressure.size()), 0);
    const double unaware = series_.integral(series_.depths(pressure), one_zone).value;
    worst_without_zones = worse(worst_without_zones, std::abs(unaware / exact - 1));
  }
  EXPECT_LT(worst, 2e-6);
  EXPECT_GT(worst_sum, 1e-4);
  EXPECT_GT(worst_without_zones, 1e-5);
}

// F = 8 G a d, a short of the face by the tenth of a ring by which its rings act like a smaller disc (EffectiveRadii).
TEST_F(ContactForceTest, OfAFlatPunchEndsAtItsFace) {
  const auto profile = ring_means(problem_.compliance, [](double r) { return r < 0.75 ? 0.0 : 10.0; });
  const auto [pressure, gap] = static_contact(problem_, profile, 0.5);
  const auto contact = contact_force(series_, pressure, gap);
  EXPECT_NEAR(contact.force / (8 * contact.radius * 0.5), 1, 2e-6);  // the force per radius, see EffectiveRadii
  EXPECT_NEAR(contact.radius, 0.75 - 0.1 * ring_, 0.02 * ring_);
}

// A sphere with a groove presses inside it and around it.
TEST_F(ContactForceTest, CountsRingsThatPressBeyondAFreeOne) {
  const auto profile =
      ring_means(problem_.compliance, [](double r) { return 0.5 < r && r < 0.6 ? r * r / 2 + 1 : r * r / 2; });
  const auto [pressure, gap] = static_contact(problem_, profile, 0.9);
  const auto contact = contact_force(series_, pressure, gap);
  const Eigen::VectorXd forces = pressure.cwiseProduct(problem_.compliance.areas);
  constexpr Index n_inside = 16;
  EXPECT_EQ(pressure[n_inside], 0);
  EXPECT_GT(forces.tail(forces.size() - n_inside).sum(), 0.2 * forces.sum());
  EXPECT_NEAR(contact.force + contact.beyond.force, forces.sum(), contact.uncertainty + contact.beyond.uncertainty);
  EXPECT_LT(contact.force, 0.9 * forces.sum());
  EXPECT_LT(contact.uncertainty + contact.beyond.uncertainty, 0.1 * forces.sum());
  EXPECT_NEAR(contact.radius, 0.5, ring_ / 2);
}

// Nothing presses at the centre, or on a few rings alone: all the rest is beyond a free ring.
TEST_F(ContactForceTest, CountsEachRingOnceWhereTheCentreIsFree) {
  for (const double pin : {0.0, 0.1}) {
    const auto profile =
        ring_means(problem_.compliance, [pin](double r) { return r < pin || (0.3 < r && r < 0.75) ? 0.0 : 10.0; });
    const auto [pressure, gap] = static_contact(problem_, profile, 0.5);
    const auto contact = contact_force(series_, pressure, gap);
    const double sum = pressure.dot(problem_.compliance.areas);
    EXPECT_NEAR(contact.force + contact.beyond.force, sum, contact.uncertainty + contact.beyond.uncertainty) << pin;
    EXPECT_LT(contact.uncertainty + contact.beyond.uncertainty, 0.5 * sum) << pin;
  }
}

/// Where rings touch within a step, and have not been in contact before.
ContactForce read_instant(const PunchSeries& series, const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap,
                          const Eigen::VectorXd& passing) {
  RingCourses courses;
  courses.passing_depths = passing;
  Eigen::VectorXd depths = series.depths(pressure);
  courses.to_instant(depths);
  return contact_force(series, {pressure, depths, {series.displacements(gap)}});
}

/// A dashpot under a growing parabola: the Hertz pressure and, up to the same edge, that of a flat punch of the speed
/// of the indentation, of which the ring that touched in the step has borne half, on average.
struct Growing {
  static constexpr double speed = 0.3;
  StaticContact hertz;
  Index n_pressed;
  Eigen::VectorXd pressure;

  Growing(const ContactProblem& problem, double radius)
      : hertz(hertz_contact(problem, radius * radius)),
        n_pressed((hertz.pressure.array() > 0).count()),
        pressure(hertz.pressure +
                 speed / 2 * (punch_traction(problem, n_pressed) + punch_traction(problem, n_pressed - 1))) {}

  [[nodiscard]] ContactForce read(const PunchSeries& series) const {
    Eigen::VectorXd passing = Eigen::VectorXd::Zero(pressure.size());
    passing[n_pressed - 1] = speed / 2;
    return read_instant(series, pressure, hertz.gap, passing);
  }
};

// F = (16/3) a^3 + 8 v a. The jump ends anywhere in its ring, where the plain sum is off by half a ring of it.
TEST_F(ContactForceTest, GoesOnToAnEdgeWhereThePressureJumps) {
  double worst = 0, worst_sum = 0;
  for (int k = 0; k <= 10; ++k) {
    const double radius = 0.9 + ring_ * k / 10;
    const double exact = 16.0 / 3 * std::pow(radius, 3) + 8 * Growing::speed * radius;
    const Growing growing(problem_, radius);
    worst = worse(worst, std::abs(growing.read(series_).force / exact - 1));
    worst_sum = worse(worst_sum, std::abs(growing.pressure.dot(problem_.compliance.areas) / exact - 1));
  }
  EXPECT_LT(worst, 5e-6);
  EXPECT_GT(worst_sum, 1e-3);
}

// Rings that bear something on average, as they touched in the step, but none of it yet at its balance time.
TEST_F(ContactForceTest, EndsBeforeRingsThatTouchAfterTheInstant) {
  const auto [pressure, gap] = hertz_contact(problem_, 0.9 * 0.9);
  const Index n_pressed = (pressure.array() > 0).count();
  Eigen::VectorXd late = pressure, passing = Eigen::VectorXd::Zero(pressure.size());
  late += 0.02 * (punch_traction(problem_, n_pressed + 2) - punch_traction(problem_, n_pressed));
  passing.segment(n_pressed, 2).setConstant(-std::numeric_limits<double>::infinity());
  const auto before = contact_force(series_, pressure, gap), with_late = read_instant(series_, late, gap, passing);
  EXPECT_NEAR(with_late.force, before.force, 1e-12);
  EXPECT_NEAR(with_late.radius, before.radius, 1e-12);
  EXPECT_GT(contact_force(series_, late, gap).force, 1.0001 * before.force);
}

// Rings of the areas 1, 2 and 3; one without pressure lies inside the last one that has some.
TEST(SumOfRings, EndsWithTheLastRingThatIsPressed) {
  const Eigen::Vector3d areas(1, 2, 3);
  const auto sum = [&](double first, double second, double third) {
    const auto contact = sum_of_rings({0, 10, 20, 30}, areas, Eigen::Vector3d(first, second, third));
    return std::pair(contact.force, contact.radius);
  };
  EXPECT_EQ(sum(4, 5, 0), std::pair(14.0, 20.0));
  EXPECT_EQ(sum(4, 0, 5), std::pair(19.0, 30.0));
  EXPECT_EQ(sum(0, 0, 0), std::pair(0.0, 0.0));
}

}  // namespace
}  // namespace fretval::fem::contact_force_test
