#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/history/friction_history.h"
#include "fem/ring_contact/contact_force.h"
#include "fem/ring_contact/stick_zone/edge_radius.h"
#include "fem/ring_contact/stick_zone/stick_radius.h"
#include "tests/fem/convergence.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"
#include "tests/fem/recorded_history.h"
#include "tests/fem/stiffened_half_space.h"
#include "tests/worse.h"

namespace fretval::fem::cattaneo_mindlin_test {
namespace {

constexpr double friction_coefficient = 0.4;

struct Sliding {
  double force;
  EdgeRadius stick_radius;
};

/// A parabola pressed to a = 1, d = 1, then displaced by u_x: one box problem.
Sliding slide(unsigned n_per_radius, double displacement, double mu) {
  const auto& normal = normal_half_space(n_per_radius);
  const auto& tangential = tangential_half_space(n_per_radius);
  const Eigen::VectorXd profile = ring_means(normal.compliance, [](double r) { return r * r / 2; });
  const Eigen::VectorXd limit = mu * static_contact(normal, profile, 1).pressure;
  const auto& areas = tangential.compliance.areas;
  std::vector<BoxState> states(static_cast<std::size_t>(limit.size()), BoxState::interior);
  const auto solution = tangential.solver.solve(displacement * areas, -limit, limit, states);
  Eigen::Index n_stuck = 0;
  while (n_stuck < limit.size() && limit[n_stuck] > 0 &&
         states[static_cast<std::size_t>(n_stuck)] == BoxState::interior)
    ++n_stuck;
  return {solution.x.dot(areas),
          stick_radius(tangential.compliance, tangential.series.depths(limit - solution.x), n_stuck)};
}

/// `u_x = (3 mu/2)(d - g(c))`, g(c) = c^2.
double displacement_for(double c) {
  return 1.5 * friction_coefficient * (1 - c * c);
}

/// `F_x = mu F (1 - c^3)`, F = 16/3.
double force_for(double c) {
  return friction_coefficient * 16.0 / 3 * (1 - c * c * c);
}

struct Errors {
  double radius = 0, force = 0;
};

/// Largest errors over stick radii from c_min to 0.9: where the edge lies in its ring matters.
Errors errors_of(unsigned n_per_radius, double c_min) {
  Errors errors;
  for (int k = 0; k < 29; ++k) {
    const double c = c_min + (0.9 - c_min) * k / 28;
    const auto sliding = slide(n_per_radius, displacement_for(c), friction_coefficient);
    errors.radius = worse(errors.radius, std::abs(sliding.stick_radius.radius - c));
    errors.force = worse(errors.force, std::abs(sliding.force / force_for(c) - 1));
  }
  return errors;
}

// Measured at 16, 32, 64, 128 rings per radius: stick radius 7.5e-5, 1.3e-5, 1.4e-6, 1.6e-7, order 2.9; force 4.7e-3,
// 1.0e-3, 1.9e-4, 5.3e-5, order 2.2.
TEST(CattaneoMindlin, StickRadiusAndForceConverge) {
  std::vector<double> radius, force;
  for (const unsigned n : {16U, 32U, 64U, 128U}) {
    const Errors errors = errors_of(n, 0.55);
    radius.push_back(errors.radius);
    force.push_back(errors.force);
  }
  EXPECT_LT(radius[2], 3e-6);
  EXPECT_LT(radius[3], 4e-7);
  EXPECT_GT(observed_order(radius), 2.5);
  EXPECT_LT(force[3], 1e-4);
  EXPECT_GT(observed_order(force), 1.5);
}

// Measured 3e-7 at c = 0.4 to 1e-6 at 0.9, and 1e-5 at 0.97, two rings from the edge of the contact.
TEST(CattaneoMindlin, StickRadiusFollowsTheForce) {
  for (const double load : {0.1, 0.3, 0.5, 0.7, 0.9, 0.95}) {
    const double c = std::cbrt(1 - load);
    EXPECT_NEAR(slide(64, displacement_for(c), friction_coefficient).stick_radius.radius, c, 2e-5) << "load " << load;
  }
}

// The largest error is half the uncertainty, the mean one a tenth.
TEST(CattaneoMindlin, UncertaintyOfTheStickRadiusCoversItsError) {
  for (const unsigned n : {32U, 64U, 128U})
    for (int k = 0; k <= 48; ++k) {
      const double c = 0.3 + 0.0125 * k;
      const auto sliding = slide(n, displacement_for(c), friction_coefficient);
      const double ratio = std::abs(sliding.stick_radius.radius - c) / sliding.stick_radius.uncertainty;
      EXPECT_LT(ratio, 1) << "n " << n << " c " << c;
    }
}

TEST(CattaneoMindlin, FullSlidingIsFriction) {
  const auto sliding = slide(64, displacement_for(0) * 1.05, friction_coefficient);
  EXPECT_EQ(sliding.stick_radius.radius, 0);
  EXPECT_NEAR(sliding.force / force_for(0), 1, 1e-4);
}

TEST(CattaneoMindlin, FrictionCoefficientMatters) {
  const double u = displacement_for(0.6);
  // 10 % more friction: 1 - c^2 falls by 1/1.1, c grows from 0.6 to 0.646.
  EXPECT_NEAR(slide(64, u, 1.1 * friction_coefficient).stick_radius.radius, std::sqrt(1 - 0.64 / 1.1), 1e-3);
  EXPECT_GT(slide(64, u, 1.1 * friction_coefficient).stick_radius.radius - 0.6, 0.04);
}

// The tangential problem is a half-space, the normal one is not: the pressure is that of Hertz for another parabola.
// With the pressures of the rings as they are the radius would be up to 7e-5 off.
TEST(CattaneoMindlin, HoldsBesideAnotherBodyThanAHalfSpace) {
  constexpr unsigned n = 32;
  constexpr double contact_radius = 0.93;
  const StiffenedHalfSpace body(n);
  const ContactProblem normal(body.compliance());
  const auto& tangential = tangential_half_space(n);
  const double indentation = body.indentation_of_parabola(contact_radius);
  const auto contact = hertz_contact(normal, indentation);
  const double force = contact_force(normal.series, contact.pressure, contact.gap).force,
               slope = 3 * force / (2 * tangential.series.force_per_radius() * std::pow(contact_radius, 3));
  for (const double c : {0.35, 0.5, 0.65, 0.8}) {
    Motion motion = one_frequency(indentation, 0, 0, 0.0);
    motion.tangential[0].amplitude = friction_coefficient * slope * (contact_radius * contact_radius - c * c);
    const HistoryControl control{48, 100, 1e-7};
    const auto history =
        contact_history({normal, elastic_body(), parabola_means(normal), motion, control.steps_per_cycle},
                        {tangential, elastic_body(), friction_coefficient, motion, control.steps_per_cycle}, control);
    Eigen::Index n_stuck = 0;
    while (history.friction.slip_path[n_stuck] <= 1e-9 * motion.tangential[0].amplitude) ++n_stuck;
    const auto found = stick_radius(tangential.compliance, history.friction.first_slip_reserve, n_stuck);
    EXPECT_NEAR(found.radius, c, 2e-5);
  }
}

}  // namespace
}  // namespace fretval::fem::cattaneo_mindlin_test
