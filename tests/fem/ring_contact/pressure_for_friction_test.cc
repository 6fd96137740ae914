#include "fem/ring_contact/pressure_for_friction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/ring_contact/contact_force.h"
#include "fem/ring_contact/static_contact.h"
#include "tests/fem/convergence.h"
#include "tests/fem/fretting.h"
#include "tests/fem/stiffened_half_space.h"

namespace fretval::fem::pressure_for_friction_test {
namespace {

using Eigen::Index;

constexpr double contact_radius = 0.9;

/// A contact of that radius on a body that is no half-space, beside the half-space as the tangential problem.
struct Contact {
  explicit Contact(unsigned n_per_radius, double radius = contact_radius)
      : body(n_per_radius), normal(body.compliance()), tangential(normal_half_space(n_per_radius)) {
    const auto made = static_contact(normal, parabola_means(normal), body.indentation_of_parabola(radius));
    pressure = made.pressure;
    force = contact_force(normal.series, made.pressure, made.gap).force;
  }

  StiffenedHalfSpace body;
  ContactProblem normal;
  const ContactProblem& tangential;
  Eigen::VectorXd pressure;
  double force;
};

/// The pressure is that of Hertz on the half-space, whose depths are in proportion to a² - r²: how far those of
/// friction's pressure are off inside the contact, of the one at the centre.
double error_of_depths(const Contact& contact, const Eigen::VectorXd& pressure, double radius) {
  const auto& series = contact.tangential.series;
  const Eigen::VectorXd depths = series.depths(pressure);
  const double slope = 3 * contact.force / (2 * series.force_per_radius() * std::pow(radius, 3));
  double worst = 0;
  for (Index i = 1; series.radii()[i] < 0.8 * radius; ++i)
    worst = std::max(worst, std::abs(depths[i] - slope * (radius * radius - std::pow(series.radii()[i], 2))));
  return worst / (slope * radius * radius);
}

TEST(PressureForFriction, HasDepthsOfThirdOrderOnAnotherBodyThanAHalfSpace) {
  std::vector<double> errors, without;
  for (const unsigned n : {16U, 32U, 64U}) {
    double worst = 0, worst_without = 0;
    for (int k = 0; k <= 4; ++k) {
      const double radius = contact_radius + k / (5.0 * n);
      const Contact contact(n, radius);
      const auto pressure =
          pressure_for_friction(contact.normal.series, contact.tangential.series, contact.pressure, contact.force);
      worst = std::max(worst, error_of_depths(contact, pressure, radius));
      worst_without = std::max(worst_without, error_of_depths(contact, contact.pressure, radius));
    }
    errors.push_back(worst);
    without.push_back(worst_without);
  }
  EXPECT_GT(observed_order(errors), 2.7) << testing::PrintToString(errors) << testing::PrintToString(without);
  EXPECT_LT(observed_order(without), 2.3);
  EXPECT_LT(10 * errors[2], without[2]);
}

TEST(PressureForFriction, PressesTheSameRings) {
  const Contact contact(32);
  const auto pressure =
      pressure_for_friction(contact.normal.series, contact.tangential.series, contact.pressure, contact.force);
  for (Index i = 0; i < pressure.size(); ++i) EXPECT_EQ(pressure[i] > 0, contact.pressure[i] > 0) << i;
}

TEST(PressureForFriction, IsThePressureOfOneBodyInBothDirections) {
  const Contact contact(32);
  const auto pressure =
      pressure_for_friction(contact.normal.series, contact.normal.series, contact.pressure, contact.force);
  EXPECT_LT((pressure - contact.pressure).lpNorm<Eigen::Infinity>(), 1e-12 * contact.pressure[0]);
}

TEST(PressureForFriction, IsThePressureOnAHalfSpaceToTheLastBit) {
  const auto& normal = normal_half_space(32);
  const auto made = static_contact(normal, parabola_means(normal), contact_radius * contact_radius);
  EXPECT_EQ(pressure_for_friction(normal.series, tangential_half_space(32).series, made.pressure, 1), made.pressure);
}

// Two rings have no curvature.
TEST(PressureForFriction, LeavesAContactOfAFewRingsAlone) {
  const Contact contact(16, 0.15);
  EXPECT_EQ(pressure_for_friction(contact.normal.series, contact.tangential.series, contact.pressure, contact.force),
            contact.pressure);
}

}  // namespace
}  // namespace fretval::fem::pressure_for_friction_test
