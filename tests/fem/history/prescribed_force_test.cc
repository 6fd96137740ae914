#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/contact/gross_slip.h"
#include "fem/ring_contact/stick_zone/stick_zones.h"
#include "fem/support/constants.h"
#include "tests/fem/convergence.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::prescribed_force_test {
namespace {

constexpr double full = 16.0 / 3;  // force at d = a = 1

Motion under_normal_force(double mean, double amplitude, double phase) {
  Motion motion{mean, {{amplitude, 1, phase}}, {{0}}};
  motion.n_ramp_cycles = 0;
  motion.normal_force = true;
  return motion;
}

// F = (16/3) d^1.5 there and back. Of the rings, third order: 1e-6 of the force.
TEST(NormalForce, OfAnElasticBodyIndentsLikeHertz) {
  const auto& problem = normal_half_space(32);
  const Eigen::VectorXd profile = parabola_means(problem);
  const auto body = elastic_body();
  const Motion motion = under_normal_force(0.5 * full, 0.45 * full, 0);
  NormalContact contact(problem, body, profile, motion, 36);
  EXPECT_NEAR(contact.indentation, std::pow(0.95, 2.0 / 3), 3e-6);
  for (int k = 1; k <= 36; ++k) {
    contact.step();
    const double force = 0.5 + 0.45 * std::cos(2 * pi * k / 36);
    EXPECT_NEAR(contact.indentation / std::pow(force, 2.0 / 3), 1, 3e-6) << k;
    EXPECT_NEAR(contact.reading.force / full, force, 1e-12) << k;
  }
}

/// `int_0^t J(t - s) cos s ds` of 1 - share e^(-t/time).
double creep(double share, double time, double t) {
  return std::sin(t) - share * time / (1 + time * time) * (std::cos(t) + time * std::sin(t) - std::exp(-t / time));
}

/// Compliance in creep, `J(t) = 1 - share e^(-t/time)`, of a standard solid and of Kelvin-Voigt.
struct Creep {
  RelaxationModel model;
  double share, time;
};
std::vector<Creep> creeping_bodies() {
  const auto solid = standard_solid();
  const double g = solid.moduli[0];
  return {{solid, g / (1 + g), solid.times[0] * (1 + g)}, {kelvin_voigt(), 1, kelvin_voigt().viscosity}};
}

/// Error of the indentation after F = F0 + F1 sin t has grown from rest to its largest, relative.
double error_after_growth(const Creep& body, int steps_per_cycle) {
  constexpr double mean = 0.4, growth = 0.5;
  const auto& problem = normal_half_space(64);
  const Eigen::VectorXd profile = parabola_means(problem);
  const Motion motion = under_normal_force(mean * full, growth * full, -pi / 2);
  NormalContact contact(problem, body.model, profile, motion, steps_per_cycle);
  for (int k = 0; k < steps_per_cycle / 4; ++k) contact.step();
  const double load = mean + growth * creep(body.share, body.time, pi / 2);
  return std::abs(contact.indentation / std::pow(load, 2.0 / 3) - 1);
}

// Lee and Radok: while the contact grows, d^1.5 creeps like the load on a linear body. Measured at 48, 96, 192 steps:
// standard solid 9.2e-5, 2.3e-5, 4.5e-6, Kelvin-Voigt 2.1e-4, 5.2e-5, 1.3e-5.
TEST(NormalForce, CreepsLikeLeeAndRadokInTheSecondOrder) {
  for (const auto& body : creeping_bodies()) {
    std::vector<double> errors;
    for (const int n : {48, 96, 192}) errors.push_back(error_after_growth(body, n));
    EXPECT_GT(observed_order(errors), 1.9);
    EXPECT_LT(errors.back(), 2e-5);
  }
}

// A flat punch under F0 + F1 cos t moves by F1/(8 a |G|), and lags behind by the loss angle. Of second order.
TEST(NormalForce, OfAFlatPunchIsLinear) {
  const auto& problem = normal_half_space(32);
  const Eigen::VectorXd profile = ring_means(problem.compliance, [](double r) { return r < 0.5 ? 0.0 : 10.0; });
  const double mean = 2, amplitude = 0.5, unit = problem.series.force_per_radius() * problem.series.edges()[16];
  for (const auto& body : {elastic_body(), standard_solid(), kelvin_voigt()}) {
    Motion motion = under_normal_force(mean, amplitude, 0);
    motion.n_ramp_cycles = 2;
    const auto history = normal_history(NormalContact(problem, body, profile, motion, 72), {72, 400, 1e-9});
    const auto modulus = complex_modulus(body);
    for (Eigen::Index k = 0; k < 72; ++k) {
      const double exact =
          (mean + amplitude / std::abs(modulus) * std::cos(history.time[k] - std::arg(modulus))) / unit;
      EXPECT_NEAR(history.indentation[k], exact, 4e-4 * mean / unit) << k;
    }
  }
}

constexpr double mu = 0.4;

Motion under_tangential_force(double amplitude, double phase) {
  Motion motion{1, {{0}}, {{amplitude, 1, phase}}};
  motion.n_ramp_cycles = 0;
  motion.tangential_force = true;
  return motion;
}

/// Friction under the pressures of a Hertzian contact with a = d = 1.
struct UnderHertz {
  StaticContact contact = hertz_contact(normal_half_space(32), 1);
  ContactForce reading = contact_force(normal_half_space(32).series, contact.pressure, contact.gap);

  [[nodiscard]] NormalInstant instant() const {
    return {normal_half_space(32).series.radii(), reading.radius, reading.force};
  }
};

// u = (3 mu/2)(1 - (c/a)^2), c/a = (1 - F_x/(mu F))^(1/3), on the way out; back the same between the reversals,
// (Mindlin and Deresiewicz): half of what is left, u(F) = u* - 2 u((F* - F)/2). Of the rings: 1e-5 of 3 mu/2.
TEST(TangentialForce, OfAnElasticBodySlidesLikeCattaneoAndMindlin) {
  const UnderHertz hertz;
  const auto body = elastic_body();
  const double share = 0.9;
  const Motion motion = under_tangential_force(share * mu * hertz.reading.force, -pi / 2);
  FrictionContact contact(tangential_half_space(32), body, mu, motion, 36);
  const auto displacement = [](double load) { return 1 - std::pow(1 - load, 2.0 / 3); };
  for (int k = 1; k <= 27; ++k) {
    contact.step(hertz.contact.pressure, hertz.instant());
    const double load = share * std::sin(2 * pi * k / 36);
    const double exact = k <= 9 ? displacement(load) : displacement(share) - 2 * displacement((share - load) / 2);
    EXPECT_NEAR(contact.displacement / (1.5 * mu), exact, 1e-5) << k;
  }
}

// All slides from sin t = 1/1.2 on. Found between two steps by a straight line: (dt^2/8) tan t.
TEST(TangentialForce, AboveMuTimesTheNormalForceIsGrossSlip) {
  const UnderHertz hertz;
  const auto body = elastic_body();
  Motion motion = under_tangential_force(1.2 * mu * hertz.reading.force, -pi / 2);
  FrictionContact contact(tangential_half_space(32), body, mu, motion, 36);
  try {
    for (int k = 0; k < 36; ++k) contact.step(hertz.contact.pressure, hertz.instant());
    FAIL() << "no gross slip";
  } catch (const GrossSlip& slip) {
    const double start = std::asin(1 / 1.2), dt = 2 * pi / 36;
    EXPECT_NEAR(slip.time, start, dt * dt / 8 * std::tan(start));
    EXPECT_EQ(slip.amplitude, 1);
    EXPECT_EQ(contact.n_steps, 5);
  }
}

/// Both forces, |F_x| e^(i phase) ahead of the normal one.
Motion under_both_forces(double mean, double normal, double tangential, double phase) {
  Motion motion{mean, {{normal}}, {{tangential, 1, phase}}};
  motion.normal_force = motion.tangential_force = true;
  return motion;
}

// Barber, Davies and Hills: (16/3) c^3 = F0 - (|F_x/mu e^(i phase) - F1| + |F_x/mu e^(i phase) + F1|)/2, in an elastic
// body. In a viscoelastic one, whose displacements differ by a third, all the same.
TEST(BothForces, ShakeDownToARadiusWithoutTheRheology) {
  const double mean = 0.7 * full, normal = 0.15 * full, tangential = 0.25 * full;
  const auto &pressed = normal_half_space(48), &sheared = tangential_half_space(48);
  const Eigen::VectorXd profile = parabola_means(pressed);
  for (const double phase : {0.0, pi / 4, pi / 2}) {
    const std::complex<double> force = std::polar(tangential, phase);
    const double demand = (std::abs(force - normal) + std::abs(force + normal)) / 2,
                 exact = std::cbrt((mean - demand) / full);
    const Motion motion = under_both_forces(mean, normal, mu * tangential, phase);
    for (const auto& body : {elastic_body(), standard_solid(), kelvin_voigt()}) {
      const HistoryControl control{48, 800, 1e-6};
      const auto history = contact_history(NormalContact(pressed, body, profile, motion, 48),
                                           WatchedFriction(sheared, body, mu, motion, 48), control);
      const auto stuck = stuck_rings(history.friction, motion);
      const auto zones = stick_zones(sheared.compliance, history.friction, stuck);
      EXPECT_NEAR(zones.shakedown.radius, exact, 1e-4) << phase << " " << body.viscosity << " " << body.times.size();
    }
  }
}

}  // namespace
}  // namespace fretval::fem::prescribed_force_test
