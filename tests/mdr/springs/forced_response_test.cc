#include "mdr/springs/forced_response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "mdr/motion/force_control.h"
#include "mdr/profiles/indentation.h"
#include "mdr/rheology/rheology.h"
#include "mdr/stick/limiting_state.h"

namespace fretval::mdr::forced_response_test {
namespace {

constexpr double mu = 0.5, mean = 0.5, amplitude = 0.1, tangential = 0.05;
const double pi = std::acos(-1.0);

const Profile profiles[] = {parabola(1e-2), cone(0.05)};

Prescribed both_forces(double phase) {
  return {{mean, {{amplitude, 1, 0}}, {{tangential, 1, phase}}, true}, true, true};
}

// Hertz and the cone. Extrapolated springs: fourth order.
TEST(ForcedResponse, OfAnElasticBodyIndentsLikeTheElasticContact) {
  for (const auto& profile : profiles) {
    const auto body = elastic(1e6);
    const auto response = forced_response(profile, body, mu, both_forces(0)).response;
    const double deepest = indentation_for_force(profile, 1e6, mean + amplitude);
    EXPECT_NEAR(response.largest_indentation / deepest, 1, 1e-6);
    EXPECT_NEAR(response.normal.contact_radius_max / inverse_transform(profile, deepest), 1, 1e-6);
    EXPECT_NEAR(response.normal.normal_force_max, mean + amplitude, 1e-6 * mean);
    EXPECT_NEAR(response.normal.normal_force_min, mean - amplitude, 1e-6 * mean);
  }
}

TEST(ForcedResponse, KnowsBothExtremesOfTheNormalForce) {
  const Prescribed prescribed{{1e-3, {{3e-4, 1, 0}}, {{0.01, 1, 0}}, true}, false, true};
  const auto normal = forced_response(parabola(1e-2), elastic(1e6), mu, prescribed).response.normal;
  const auto hertz = [](double depth) { return 16. / 3 * 1e6 * std::sqrt(1e-2 * depth) * depth; };
  EXPECT_NEAR(normal.normal_force_max / hertz(1.3e-3), 1, 1e-6);
  EXPECT_NEAR(normal.normal_force_min / hertz(0.7e-3), 1, 1e-6);
}

// Under a steady normal force: Cattaneo and Mindlin, (3 mu/2)(d - g(c)) on either side. Where the slip ends inside its
// spring, 2e-5 are left.
TEST(ForcedResponse, SlidesLikeCattaneoAndMindlin) {
  for (const auto& profile : profiles) {
    Prescribed prescribed = both_forces(0);
    prescribed.motion.normal[0].amplitude = 0;
    const auto response = forced_response(profile, elastic(1e6), mu, prescribed).response;
    const double exact = tangential_displacement_for_force(profile, 1e6, mu, mean, tangential);
    EXPECT_NEAR(response.tangential_amplitude / exact, 1, 4e-5);
    const double stick_depth = indentation_for_force(profile, 1e6, mean - tangential / mu);
    EXPECT_NEAR(response.depths.first_slip / stick_depth, 1, 1e-5);
    EXPECT_NEAR(response.depths.shakedown / stick_depth, 1, 1e-5);
  }
}

// Cattaneo and Mindlin again, with rings that slip from twice to a fiftieth of a spring wide.
TEST(ForcedResponse, KnowsThatItsSpringsDoNotSeeANarrowRingThatSlips) {
  for (const double share : {0.01, 0.003, 0.001, 1e-4}) {
    Prescribed prescribed = both_forces(0);
    prescribed.motion.normal[0].amplitude = 0;
    const double force = prescribed.motion.tangential[0].amplitude = share * mu * mean;
    const auto [response, error] = forced_response(profiles[0], elastic(1e6), mu, prescribed);
    const double exact = tangential_displacement_for_force(profiles[0], 1e6, mu, mean, force);
    EXPECT_LT(std::abs(response.tangential_amplitude - exact), error.tangential_amplitude) << share;
    EXPECT_LT(error.tangential_amplitude, 5e-3 * exact) << share;
  }
}

// The closed form of the worn contact is that of the unworn one, whatever the body: g(c) with
// N(g(c)) = F0 - (|F_x/mu e^(i phase) - F1| + |F_x/mu e^(i phase) + F1|)/2. With a dashpot 4e-4 of c at worst, the
// others 1e-6; the error says so.
TEST(ForcedResponse, ShakesDownToTheRadiusOfTheLimitingState) {
  for (const auto& profile : profiles)
    for (const double phase : {0.0, pi / 4})
      for (const auto& body : {elastic(1e6), standard_solid(1e6, 1e6, 0.1), kelvin_voigt(1e6, 2e5)}) {
        const FrettingControl control{NormalForceControl{mean, amplitude}, TangentialForceControl{tangential}, 1, 1,
                                      phase};
        const double exact = limiting_state(profile, body, mu, control, StickCriterion::shakedown)->stick_radius;
        const auto [response, error] = forced_response(profile, body, mu, both_forces(phase));
        const double found = inverse_transform(profile, response.depths.shakedown);
        const double tolerance = body.viscosity > 0 ? 1e-3 : 1e-5;
        EXPECT_NEAR(found / exact, 1, tolerance) << phase << " " << body.viscosity;
        EXPECT_LT(error.depths.shakedown, tolerance * response.depths.shakedown);
      }
}

// Two forces, unlocked or of the golden ratio of frequencies: whatever is prescribed comes by in every relation of the
// phases, and the stick radius is where N(g(c)) = F0 - F1 - F_x/mu, whatever the body.
TEST(ForcedResponse, WithoutAPeriodShakesDownWhereTheLargestForcesMeet) {
  const double golden = (1 + std::sqrt(5)) / 2;
  auto unlocked = both_forces(0), incommensurate = both_forces(0.3);
  unlocked.motion.phase_locked = false;
  incommensurate.motion.tangential[0].frequency = golden;
  const double exact = indentation_for_force(profiles[0], 1e6, mean - amplitude - tangential / mu);
  for (const auto& body : {elastic(1e6), standard_solid(1e6, 1e6, 0.1)})
    for (const auto& prescribed : {unlocked, incommensurate}) {
      const auto [response, error] = forced_response(profiles[0], body, mu, prescribed, {100, 60, 10, 1e-8});
      EXPECT_LE(std::abs(response.depths.shakedown - exact), error.depths.shakedown) << prescribed.motion.phase_locked;
      EXPECT_LT(error.depths.shakedown, 5e-3 * exact);
    }
}

// A creep compliance that rises: no body goes deeper than the relaxed one, and one that is stiff in motion less deep.
TEST(ForcedResponse, GoesNoDeeperThanTheRelaxedBody) {
  const auto prescribed = both_forces(pi / 2);
  for (const auto& body : {standard_solid(1e6, 1e6, 0.1), kelvin_voigt(1e6, 2e5)}) {
    const double bound = deepest_indentation(profiles[0], body, prescribed);
    const auto response = forced_response(profiles[0], body, mu, prescribed).response;
    EXPECT_LT(response.largest_indentation, bound * (1 - 1e-3));
    EXPECT_GT(response.largest_indentation, indentation_for_force(profiles[0], 1e6, mean));
  }
}

// A cone on a body with a dashpot, whose load jumps at the edge.
TEST(ForcedResponse, KnowsTheErrorOfABodyWithADashpot) {
  double most_off = 0, largest_error = 0;  // of energies that are lost
  for (const double phase : {0.0, pi / 4, pi / 2}) {
    const Prescribed displacements{{8e-5, {{2e-5, 1, 0}}, {{3e-5, 1, phase}}, true}};
    const auto stepped_with = [&](int times) {
      return forced_response(cone(3.643 * pi / 180), kelvin_voigt(1e6, 8e4), mu, displacements,
                             {100 * times, 90 * times, 5 * times, 1e-5});
    };
    const auto coarse = stepped_with(1), fine = stepped_with(3);
    const auto see = [&](double ForcedResponse::*part) {
      const double off = std::abs(coarse.response.*part - fine.response.*part), error = coarse.error.*part;
      EXPECT_LE(off, error);
      most_off = std::max(most_off, off);
      largest_error = std::max(largest_error, error);
    };
    see(&ForcedResponse::tangential_work);
    see(&ForcedResponse::friction_work);
    see(&ForcedResponse::bulk_work);
  }
  EXPECT_LE(largest_error, 10 * most_off);
}

// Neither the difference of two extrapolations nor the last correction alone is as much as these are off.
TEST(ForcedResponse, KnowsTheErrorOfABodyWithoutADashpot) {
  for (const double phase : {0.3, 1.0, 1.7, 2.4}) {
    const Prescribed displacements{{8e-5, {{2e-5, 1, 0}}, {{1.5e-5, 1, phase}}, true}};
    const auto stepped_with = [&](Eigen::Index n, int n_ramp) {
      return forced_response(profiles[0], standard_solid(1e6, 1e6, 0.1), mu, displacements,
                             {n, static_cast<int>(n) * 9 / 10, n_ramp, 1e-8});
    };
    const auto coarse = stepped_with(60, 6), fine = stepped_with(240, 24);
    const auto see = [&](double ForcedResponse::*part) {
      EXPECT_LE(std::abs(coarse.response.*part - fine.response.*part), coarse.error.*part) << phase;
    };
    see(&ForcedResponse::tangential_force_max);
    see(&ForcedResponse::axis_pressure_max);
    see(&ForcedResponse::friction_work);
    see(&ForcedResponse::bulk_work);
  }
}

// Whichever way they rise, oscillations come to the same cycle, in which slip dies out slowly.
TEST(ForcedResponse, OfABodyWithADashpotHasSettledWhateverTheRamp) {
  const Prescribed displacements{{1e-4, {{2e-5, 1, 0}}, {{1.5e-5, 1, 0}, {5e-6, 2, pi / 2}}, true}};
  const auto stepped_with = [&](int n_ramp) {
    return forced_response(cone(5 * pi / 180), kelvin_voigt(1e6, 5e4), mu, displacements, {100, 90, n_ramp, 1e-5});
  };
  const auto fast = stepped_with(5), slow = stepped_with(40);
  const auto agree = [&](double ForcedResponse::*part) {
    return std::abs(fast.response.*part - slow.response.*part) <= std::max(fast.error.*part, slow.error.*part) / 2;
  };
  EXPECT_TRUE(agree(&ForcedResponse::tangential_work));
  EXPECT_TRUE(agree(&ForcedResponse::friction_work));
  EXPECT_TRUE(agree(&ForcedResponse::tangential_force_mean));
}

// A small oscillation against a dashpot, which holds the outermost 0.3 % of the contact back for a part of the period:
// 200 springs do not see that these lose less, and 64 times as many do.
TEST(ForcedResponse, KnowsThatSpringsWhichLetGoAreFewerThanOne) {
  const auto body = kelvin_voigt(1e6, 1e6);
  const double indentation = 1e-4, small = 7e-8;
  const Prescribed prescribed{{indentation, {{small, 1, 0}}, {{small / 100, 1, 1}}, true}, false, false};
  const auto stepped = forced_response(parabola(1e-2), body, mu, prescribed, {100, 90, 5, 1e-5}),
             resolved = forced_response(parabola(1e-2), body, mu, prescribed, {6400, 90, 5, 1e-5});
  const double off = std::abs(stepped.response.bulk_work - resolved.response.bulk_work);
  EXPECT_GT(off, 5e-4 * resolved.response.bulk_work);
  EXPECT_LT(off, stepped.error.bulk_work);
  EXPECT_LT(stepped.error.bulk_work, 5e-3 * resolved.response.bulk_work);
  EXPECT_LT(resolved.error.bulk_work, stepped.error.bulk_work / 4) << "which sees them";
}

TEST(ForcedResponse, SaysThatTheContactSlides) {
  auto prescribed = both_forces(0);
  prescribed.motion.tangential[0].amplitude = 0.4;
  EXPECT_THROW(forced_response(profiles[0], elastic(1e6), mu, prescribed), std::runtime_error);
}

/// Load of a spring at g = 0 that is pressed throughout, over its relaxed stiffness: the linear response to the
/// indentations of a period, both ends included, by their Fourier series.
std::vector<double> load_at_centre(const PronyBody& body, const std::vector<double>& indentation, double frequency) {
  constexpr int n_harmonics = 30;
  const std::size_t n = indentation.size() - 1;
  std::vector<double> load(n, 0);
  for (int h = 0; h <= n_harmonics; ++h) {
    std::complex<double> coefficient = 0;
    for (std::size_t k = 0; k < n; ++k)
      coefficient += indentation[k] * std::polar(h == 0 ? 1. : 2., -2 * pi * h * static_cast<double>(k) / n);
    coefficient *= complex_modulus_ratio(body, 2 * pi * h * frequency) / static_cast<double>(n);
    for (std::size_t k = 0; k < n; ++k)
      load[k] += (coefficient * std::polar(1., 2 * pi * h * static_cast<double>(k) / n)).real();
  }
  return load;
}

// 33 times as stiff in motion as at rest: slip inside the stick zone goes on for 1,000 periods, long after tractions
// seem to repeat. What sticks in the end follows from the indentation alone, by linear response: the means of the least
// margins mu (p_0(t) - g) -+ t(t).
TEST(ForcedResponse, WaitsForSlipThatDiesOutSlowly) {
  const PronyBody body{1, {32}, {0.94}, 2.8};
  const double f = 0.353, u = 2.06e-3, phase = 5.476;
  const Prescribed prescribed{{0.0391, {{0.0254, f, 0}}, {{u, f, phase}}, true}, true, false};
  const auto response = forced_response(parabola(1), body, 1.81, prescribed, {50, 180, 4, 1e-7, 48}).response;
  const auto pressed = load_at_centre(body, response.normal.indentation, f);
  const auto ratio = complex_modulus_ratio(body, 2 * pi * f);
  double forward = 1e300, backward = 1e300;
  for (std::size_t k = 0; k < pressed.size(); ++k) {
    const double angle = 2 * pi * static_cast<double>(k) / pressed.size() + phase,
                 pull = (u * ratio * std::polar(1., angle)).real() / (1.5 * 1.81);
    forward = std::min(forward, pressed[k] - pull);
    backward = std::min(backward, pressed[k] + pull);
  }
  EXPECT_NEAR(response.depths.shakedown / ((forward + backward) / 2), 1, 2e-3);
}

}  // namespace
}  // namespace fretval::mdr::forced_response_test
