#include "mdr/stick/limiting_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <random>
#include <stdexcept>
#include <vector>

#include "mdr/motion/force_control.h"
#include "mdr/profiles/indentation.h"
#include "mdr/stick/element_forces.h"
#include "mdr/stick/stick_radius.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::limiting_state_test {
namespace {

// Roundoff; the largest demands drawn below keep the two radii of the mixed control apart.
constexpr double tolerance = 1e-12;

constexpr StickCriterion criteria[] = {StickCriterion::first_slip, StickCriterion::shakedown};

std::vector<Rheology> bodies() {
  return {elastic(2), kelvin_voigt(1, 0.05), standard_solid(1, 0.5, 0.2), FractionalZener{1, 0.5, 0.1, 0.6}};
}

struct Draw {
  std::mt19937 random{31};
  double operator()() { return std::uniform_real_distribution<double>(0, 1)(random); }
};

FrettingControl displacement_control(const Motion& motion) {
  return {IndentationControl{motion.indentation, motion.normal_amplitude},
          TangentialDisplacementControl{motion.tangential_amplitude}, motion.normal_frequency,
          motion.tangential_frequency, motion.phase};
}

// The other three rigs that show the same state. A force is ahead of its displacement by the angle of the modulus.
std::vector<FrettingControl> other_controls(const LimitingState& state, const Rheology& body) {
  const FrettingControl displacements = displacement_control(state.motion);
  FrettingControl pulled = displacements, pressed = displacements;
  pulled.tangential = TangentialForceControl{state.tangential_force_amplitude};
  pressed.normal = NormalForceControl{state.mean_normal_force, state.normal_force_amplitude};
  FrettingControl forces = pressed;
  forces.tangential = pulled.tangential;
  if (state.motion.phase) {
    const double lag = std::arg(complex_modulus(body, angular_frequency(state.motion.normal_frequency)));
    *pulled.phase += lag;
    *pressed.phase -= lag;
  }
  return {pulled, pressed, forces};
}

void expect_same(const LimitingState& state, const LimitingState& other) {
  EXPECT_NEAR(other.stick_radius, state.stick_radius, tolerance * state.stick_radius);
  EXPECT_NEAR(other.motion.indentation, state.motion.indentation, tolerance);
  EXPECT_NEAR(other.motion.normal_amplitude, state.motion.normal_amplitude, tolerance);
  EXPECT_NEAR(other.motion.tangential_amplitude, state.motion.tangential_amplitude, tolerance);
  EXPECT_NEAR(other.mean_normal_force, state.mean_normal_force, tolerance * state.mean_normal_force);
  EXPECT_NEAR(other.normal_force_amplitude, state.normal_force_amplitude, tolerance * state.mean_normal_force);
  EXPECT_NEAR(other.tangential_force_amplitude, state.tangential_force_amplitude, tolerance * state.mean_normal_force);
  ASSERT_EQ(other.motion.phase.has_value(), state.motion.phase.has_value());
  EXPECT_NEAR(other.motion.phase.value_or(0), state.motion.phase.value_or(0), tolerance);
}

// Demands of at most 0.3 d0 leave g(c) > 0.7 d0, where a smaller edge always sticks: c is the larger of the two radii.
Motion draw_motion(Draw& draw, const Rheology& body, double mu) {
  const double frequency = 0.2 + draw();
  Motion motion{1, 0, 0, frequency, frequency, 2 * pi * draw()};
  if (draw() < 0.3) {
    motion.tangential_frequency = 3 * draw() + 0.1;
    motion.phase.reset();
  }
  motion.normal_amplitude = 0.15 * draw() / modulus_ratio(body, angular_frequency(frequency));
  motion.tangential_amplitude =
      0.15 * draw() * 1.5 * mu / modulus_ratio(body, angular_frequency(motion.tangential_frequency));
  return motion;
}

TEST(LimitingState, AllFourControlsMeetInTheSameState) {
  Draw draw;
  for (int i = 0; i < 400; ++i) {
    const Rheology body = bodies()[i % 4];
    const Profile profile = power_law(0.2 + draw(), 0.5 + 3 * draw());
    const double mu = 0.1 + draw();
    const Motion motion = draw_motion(draw, body, mu);
    for (const StickCriterion criterion : criteria) {
      const auto state = limiting_state(profile, body, mu, displacement_control(motion), criterion);
      ASSERT_TRUE(state);
      const StickRadii radii = stick_radii(profile, body, mu, motion);
      EXPECT_NEAR(state->stick_radius, criterion == StickCriterion::shakedown ? *radii.shakedown : *radii.first_slip,
                  tolerance * state->stick_radius);
      for (const FrettingControl& control : other_controls(*state, body)) {
        const auto other = limiting_state(profile, body, mu, control, criterion);
        ASSERT_TRUE(other);
        expect_same(*state, *other);
      }
    }
  }
}

// The forces of the worn contact, element by element from the paper's (15) and (16), integrated over the stick zone.
TEST(LimitingState, ForcesAreTheSumOverTheElements) {
  Draw draw;
  for (const Rheology& body : bodies()) {
    const Motion motion = draw_motion(draw, body, 0.5);
    Motion locked = motion;
    locked.tangential_frequency = locked.normal_frequency;
    locked.phase = 0.7;
    const auto state = *limiting_state(parabola(2), body, 0.5, displacement_control(locked), StickCriterion::shakedown);
    const double omega = angular_frequency(locked.normal_frequency), lag = std::arg(complex_modulus(body, omega));
    for (const double time : {0.0, 0.3, 1.1}) {
      const auto load = [&](double x) { return element_normal_force(body, locked, transform(parabola(2), x), time); };
      // Exact for the parabola.
      const double normal =
          boost::math::quadrature::gauss<double, 7>::integrate(load, -state.stick_radius, state.stick_radius);
      EXPECT_NEAR(state.mean_normal_force + state.normal_force_amplitude * std::cos(omega * time + lag), normal,
                  tolerance * normal);
      EXPECT_NEAR(state.tangential_force_amplitude * std::cos(omega * time + 0.7 + lag),
                  2 * state.stick_radius * element_tangential_force(body, locked, time), tolerance * normal);
    }
  }
}

FrettingControl force_control(double mean, double normal, double tangential, std::optional<double> phase) {
  return {NormalForceControl{mean, normal}, TangentialForceControl{tangential}, 0.7, 0.7, phase};
}

// Barber, Davies and Hills: of all lines of slope +-mu the outermost that touch the loading loop meet at the normal
// force that the unworn contact of the stick radius carries. Sampling the loop costs (2 pi/n)^2/8 of its size.
TEST(LimitingState, TwoForcesGiveTheTwoTangentConstruction) {
  Draw draw;
  const int n_samples = 20000;
  for (int i = 0; i < 30; ++i) {
    const double mu = 0.1 + draw(), normal = 0.3 * draw(), tangential = 0.3 * mu * draw(), phase = 2 * pi * draw();
    double above = -10, below = 10;  // largest F_x - mu F, smallest F_x + mu F
    for (int j = 0; j < n_samples; ++j) {
      const double angle = 2 * pi * j / n_samples;
      const double push = 1 + normal * std::cos(angle), pull = tangential * std::cos(angle + phase);
      above = std::max(above, pull - mu * push);
      below = std::min(below, pull + mu * push);
    }
    const double meeting_force = (below - above) / (2 * mu);
    const auto state = limiting_state(parabola(2), elastic(3), mu, force_control(1, normal, tangential, phase),
                                      StickCriterion::shakedown);
    const double expected = contact_radius(parabola(2), indentation_for_force(parabola(2), 3, meeting_force));
    EXPECT_NEAR(state->stick_radius, expected, 1e-7 * expected);
  }
}

TEST(LimitingState, TwoForcesOnAParabolaInClosedForm) {
  const double R = 2, G = 3, mu = 0.5, F0 = 1.3, normal = 0.2, tangential = 0.1, phase = 0.9;
  const std::complex<double> pull = std::polar(tangential / mu, phase);
  const double minus = std::abs(pull - normal), plus = std::abs(pull + normal);
  const double demands[] = {std::max(minus, plus), (minus + plus) / 2};
  for (int i = 0; i < 2; ++i) {
    const auto state =
        limiting_state(parabola(R), elastic(G), mu, force_control(F0, normal, tangential, phase), criteria[i]);
    EXPECT_NEAR(state->stick_radius, std::cbrt(3 * R * (F0 - demands[i]) / (16 * G)), tolerance);
  }
}

TEST(LimitingState, TwoForcesLeaveTheRheologyOut) {
  for (const StickCriterion criterion : criteria) {
    const FrettingControl control = force_control(1, 0.2, 0.1, 0.4);
    const auto elastic_state = limiting_state(cone(0.3), elastic(1), 0.5, control, criterion);
    for (const Rheology& body : {Rheology(kelvin_voigt(1, 3)), Rheology(standard_solid(1, 50, 0.2)),
                                 Rheology(FractionalZener{1, 9, 0.1, 0.6})}) {
      const auto state = limiting_state(cone(0.3), body, 0.5, control, criterion);
      EXPECT_NEAR(state->stick_radius, elastic_state->stick_radius, tolerance);
      EXPECT_NEAR(state->motion.indentation, elastic_state->motion.indentation, tolerance);
      // The stiffer body moves less.
      EXPECT_LT(maximum_indentation(state->motion), maximum_indentation(elastic_state->motion) - 1e-3);
    }
  }
}

// Parabola, Delta d = 0: c^3 - R d0 c + R F_x/(8 mu G0) = 0, solved by cosines; its two positive zeros merge at
// F_x/(8 mu G0) = (2 d0/3) sqrt(R d0/3).
TEST(LimitingState, IndentationAndTangentialForceOnAParabola) {
  const double R = 2, G = 3, mu = 0.5, d0 = 0.7;
  const double merging = 16.0 / 3 * mu * G * d0 * std::sqrt(R * d0 / 3);
  const auto state = [&](double fraction) {
    const FrettingControl control{IndentationControl{d0, 0}, TangentialForceControl{fraction * merging}, 1, 1, 0.0};
    return limiting_state(parabola(R), elastic(G), mu, control, StickCriterion::shakedown);
  };
  for (const double fraction : {0.0, 1e-6, 0.1, 0.5, 0.9, 0.99, 0.9999, 1 - 1e-8}) {
    const double expected = 2 * std::sqrt(R * d0 / 3) * std::cos(std::acos(-fraction) / 3);
    ASSERT_TRUE(state(fraction));
    // A double zero turns roundoff into its square root.
    EXPECT_NEAR(state(fraction)->stick_radius, expected, 1e-15 / std::sqrt(1 - fraction) + 4e-15) << fraction;
  }
  for (const double fraction : {1 + 1e-8, 1.01, 2.0, 1e6}) EXPECT_FALSE(state(fraction)) << fraction;
}

// Parabola, Delta F = 0: c^3 + (3/2) R A c - (3 R/16) F0/G0 = 0, A = 2 u_x0/(3 mu), by Cardano.
TEST(LimitingState, NormalForceAndTangentialDisplacementOnAParabola) {
  const double R = 2, G = 3, mu = 0.5, F0 = 1.3;
  for (const double displacement : {0.0, 0.01, 0.1, 1.0}) {
    const double p = R * displacement / mu / 3, q = 3 * R * F0 / (32 * G);
    const double root = std::sqrt(q * q + p * p * p);
    const FrettingControl control{NormalForceControl{F0, 0}, TangentialDisplacementControl{displacement}, 1, 1, 0.3};
    const auto state = limiting_state(parabola(R), elastic(G), mu, control, StickCriterion::first_slip);
    // The two cube roots cancel for a large displacement.
    EXPECT_NEAR(state->stick_radius, std::cbrt(q + root) + std::cbrt(q - root), 1e-13);
    EXPECT_NEAR(state->mean_normal_force, F0, tolerance);
  }
}

TEST(LimitingState, WithoutOscillationIsTheUnwornContact) {
  const FrettingControl pressed{NormalForceControl{2, 0}, TangentialForceControl{0}, 1, 1, 0.0};
  const FrettingControl held{IndentationControl{0.5, 0}, TangentialForceControl{0}, 1, 1, 0.0};
  const auto unworn = limiting_state(parabola(2), elastic(1), 1, pressed, StickCriterion::shakedown);
  EXPECT_NEAR(unworn->motion.indentation, indentation_for_force(parabola(2), 1, 2), tolerance);
  EXPECT_NEAR(unworn->stick_radius, contact_radius(parabola(2), unworn->motion.indentation), tolerance);
  EXPECT_NEAR(limiting_state(parabola(2), elastic(1), 1, held, StickCriterion::shakedown)->stick_radius, 1, tolerance);
}

TEST(LimitingState, IsEmptyWhereWearGoesOn) {
  const auto exists = [](const FrettingControl& control) {
    return limiting_state(parabola(2), elastic(1), 0.5, control, StickCriterion::shakedown).has_value();
  };
  // Two forces, unlocked: F0 against F_x/mu + Delta F.
  EXPECT_TRUE(exists(force_control(1, 0.2, 0.39, std::nullopt)));
  EXPECT_FALSE(exists(force_control(1, 0.2, 0.41, std::nullopt)));
  // The contact opens in every cycle.
  EXPECT_FALSE(exists(force_control(1, 1.1, 0, 0.0)));
  const TangentialDisplacementControl slight{1e-3}, wide{100};
  EXPECT_FALSE(exists({NormalForceControl{1, 1.1}, slight, 1, 1, 0.0}));
  EXPECT_FALSE(exists({IndentationControl{1, 1.1}, slight, 1, 1, 0.0}));
  EXPECT_FALSE(exists({IndentationControl{1, 0.1}, wide, 1, 1, 0.0}));
  EXPECT_FALSE(exists({IndentationControl{1, 0.1}, TangentialForceControl{100}, 1, 1, 0.0}));
  // Under a normal force even a wide motion leaves a small core: the worn contact sinks in.
  EXPECT_TRUE(exists({NormalForceControl{1, 0.1}, wide, 1, 1, 0.0}));
}

TEST(LimitingState, RejectsBadControls) {
  const auto state = [](double mu, const FrettingControl& control) {
    return limiting_state(parabola(2), elastic(1), mu, control, StickCriterion::shakedown);
  };
  const IndentationControl held{1, 0.1};
  const TangentialForceControl pull{0.1};
  EXPECT_THROW(state(0, {held, pull, 1, 1, 0.0}), std::invalid_argument);
  EXPECT_THROW(state(1, {IndentationControl{0, 0.1}, pull, 1, 1, 0.0}), std::invalid_argument);
  EXPECT_THROW(state(1, {NormalForceControl{1, -0.1}, pull, 1, 1, 0.0}), std::invalid_argument);
  EXPECT_THROW(state(1, {held, TangentialForceControl{NAN}, 1, 1, 0.0}), std::invalid_argument);
  EXPECT_THROW(state(1, {held, pull, 0, 1, std::nullopt}), std::invalid_argument);
  EXPECT_THROW(state(1, {held, pull, 1, 1, NAN}), std::invalid_argument);
  EXPECT_THROW(state(1, {held, pull, 1, 2, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::limiting_state_test
