#include "fem/wear/wear_course.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"
#include "tests/fem/wear/wearing_half_space.h"

namespace fretval::fem::wear_course_test {
namespace {

constexpr WearLaw archard{1e-3};

// docs/theory.md: where nothing wears any more, the indenter is the limiting profile. Second order in the rings.
TEST(WearCourse, EndsInTheLimitingProfileWithSecondOrder) {
  const auto error = [](unsigned n_per_radius) {
    const WearingHalfSpace half_space(n_per_radius);
    return half_space.distance_from_limit(half_space.course(archard).worn.back());
  };
  const double fine = error(32);
  EXPECT_LT(fine, 5e-4);
  EXPECT_GT(error(16) / fine, 3);
}

// In the state that no law wears any more.
TEST(WearCourse, EndsThereWhateverTheLaw) {
  const WearingHalfSpace half_space;
  const auto reference = half_space.course(archard).worn.back();
  for (const WearLaw& law : {WearLaw{1e-2}, WearLaw{1e-3, 0.5}, WearLaw{1e-3, 2}})
    EXPECT_LT((half_space.course(law).worn.back() - reference).cwiseAbs().maxCoeff(), 2e-4) << law.exponent;
}

// A standard solid with |G|/G0 = 1.2 has the same c under motions 1.2 times smaller. Of the motion the limit knows c
// and the largest indentation alone.
TEST(WearCourse, EndsThereWhateverTheRheology) {
  WearingHalfSpace half_space;
  const double rho = 1.2;
  half_space.body = {1, {std::sqrt(2 * rho * rho - 1) - 1}, {1}, 0};
  half_space.motion.normal[0].amplitude /= rho;
  half_space.motion.tangential[0].amplitude /= rho;
  half_space.motion.n_ramp_cycles = 8;
  const auto course = half_space.course(archard);
  EXPECT_EQ(course.curve.back().stick_radius, WearingHalfSpace::stick_radius);
  EXPECT_LT(half_space.distance_from_limit(course.worn.back()), 5e-4);
}

// Reye: volume = k/mu times the work of friction, summed over the cycles by trapezoids. Second order in the jumps.
TEST(WearCourse, VolumeIsTheWorkOfFrictionTimesItsCoefficient) {
  WearingHalfSpace half_space;
  half_space.n_steps = 192;
  const auto error = [&](double jump) {
    const auto course = half_space.course(archard, jump, 2e3);
    double work = 0;
    for (std::size_t i = 1; i < course.curve.size(); ++i) {
      const auto &before = course.curve[i - 1], &after = course.curve[i];
      work += (after.cycles - before.cycles) * (before.friction_work + after.friction_work) / 2;
    }
    return std::abs(work * archard.coefficient / WearingHalfSpace::mu / course.curve.back().volume - 1);
  };
  EXPECT_LT(error(5e-3), 1e-3);
  EXPECT_GT(error(1e-2) / error(2.5e-3), 7);
}

TEST(WearCourse, LeavesTheStickZoneAloneAndNeverGrows) {
  const WearingHalfSpace half_space;
  const auto course = half_space.course(archard);
  const auto n_stuck = static_cast<Eigen::Index>(WearingHalfSpace::stick_radius * 32);
  ASSERT_GT(course.worn.size(), 10u);
  for (std::size_t i = 1; i < course.worn.size(); ++i) {
    EXPECT_TRUE(course.worn[i].head(n_stuck).isZero(0)) << i;
    EXPECT_GE((course.worn[i] - course.worn[i - 1]).minCoeff(), 0) << i;
  }
  EXPECT_GT(course.worn.back()[n_stuck + 1], 0.05);
  EXPECT_EQ(course.curve.back().stick_radius, WearingHalfSpace::stick_radius);
}

// What is pressed at the end does not slip: the singular pressure of the limiting state ends at c.
TEST(WearCourse, BearsNothingOutsideInTheEnd) {
  const auto course = WearingHalfSpace().course(archard);
  const auto n_stuck = static_cast<Eigen::Index>(WearingHalfSpace::stick_radius * 32);
  const auto& pressure = course.last.largest_pressure;
  EXPECT_LT(pressure.tail(pressure.size() - n_stuck).maxCoeff(), 1e-5 * pressure.maxCoeff());
  EXPECT_GT(pressure[n_stuck - 1], 2 * course.first.largest_pressure[n_stuck - 1]);
}

// Jumps over many cycles against each cycle by itself, which wears with the slip of the one before: they differ by
// what a cycle wears off.
TEST(WearCourse, JumpsAreTheLimitOfTheCyclesOneByOne) {
  const WearingHalfSpace half_space;
  const auto difference = [&](int n) {
    const WearLaw law{1.6 / n};
    auto one_by_one = half_space.contact(law);
    one_by_one.settle();
    for (int cycle = 0; cycle < n; ++cycle) one_by_one.wear_off(1);
    const auto jumps = half_space.course(law, 8e-3, n);
    EXPECT_LT(jumps.n_jumps, n / 6);
    EXPECT_GT(jumps.worn.back().maxCoeff(), 0.1);
    return (jumps.worn.back() - one_by_one.worn()).cwiseAbs().maxCoeff();
  };
  const double many = difference(320);
  EXPECT_LT(many, 3e-4);
  EXPECT_GT(difference(160) / many, 1.8);
}

// What both ways of a jump differ by is of the second order in its length.
TEST(WearCourse, JumpsTellHowFarTheyAreOff) {
  const WearingHalfSpace half_space;
  const auto error = [&](double jump) { return half_space.course(archard, jump, 2e3).largest_jump_error; };
  const double small = error(2.5e-3);
  EXPECT_GT(small, 0);
  EXPECT_LT(small, 2.5e-3);
  EXPECT_GT(error(1e-2) / small, 8);
}

// A constant normal force F and an oscillating tangential one Q: Cattaneo and Mindlin's stick radius is that of the
// worn contact too, which sinks in until the disc bears F = 8 (c d - c^3/3) by itself, here with d = 1.
TEST(WearCourse, UnderForcesSinksIntoTheLimitingState) {
  WearingHalfSpace half_space;
  const double c = half_space.effective_stick_radius(), cubed = c * c * c, force = 8 * (c - cubed / 3),
               tangential = WearingHalfSpace::mu * force * (1 - cubed / (3 * force / 16));
  half_space.motion = one_frequency(force, 0, tangential, pi / 2);
  half_space.motion.normal_force = half_space.motion.tangential_force = true;
  const auto course = half_space.course(archard);
  EXPECT_NEAR(course.first.largest_indentation, std::cbrt(3 * force / 16) * std::cbrt(3 * force / 16), 1e-3);
  EXPECT_NEAR(course.last.largest_indentation, 1, 1e-3);
  EXPECT_NEAR(course.curve.back().stick_radius, WearingHalfSpace::stick_radius, 1.0 / 32);
  EXPECT_LT(half_space.distance_from_limit(course.worn.back()), 1e-3);
}

// Under a normal force and a tangential displacement more and more sticks as the indenter sinks in, and what was worn
// off before stays so.
TEST(WearCourse, UnderANormalForceTheStickZoneGrows) {
  WearingHalfSpace half_space;
  constexpr double force = 2, displacement = 0.35, ring = 1.0 / 32;
  half_space.motion = one_frequency(force, 0, displacement, 0);
  half_space.motion.normal_force = true;
  const auto course = half_space.course(archard, 0.02);
  // What sticks follows: c^2 = d - A, A = 2 u/(3 mu). Unworn F = 16/3 d^(3/2); a disc that bears it alone,
  // F = 8 (c d - c^3/3), would have c = 0.425.
  const double demand = 2 * displacement / (3 * WearingHalfSpace::mu), unworn = std::pow(3 * force / 16, 2.0 / 3);
  const double before = course.curve.front().stick_radius, after = course.curve.back().stick_radius;
  EXPECT_NEAR(before, std::sqrt(unworn - demand), ring);
  EXPECT_GT(after, before + 1.5 * ring);
  EXPECT_LT(after, 0.425 - 2 * ring);
  const auto outermost_stuck = static_cast<Eigen::Index>(after / ring + 0.5) - 1;
  EXPECT_GT(course.worn.back()[outermost_stuck], 1e-3);
}

// Sliding all the way under a constant force: a cycle wears off k F times its path, less what the body gives way at
// each turn, 2 mu F/(8 a^3 ...) of the path, which falls as the contact grows. So the rate rises towards k F 4 u.
TEST(WearCourse, GoesOnForEverWhereNothingSticksUnderAForce) {
  WearingHalfSpace half_space;
  constexpr double force = 0.5, displacement = 10;
  half_space.motion = one_frequency(force, 0, displacement, 0);
  half_space.motion.normal_force = true;
  const auto course = half_space.course(archard, 0.02);
  EXPECT_EQ(course.end, WearEnd::progressive);
  EXPECT_EQ(course.curve.back().stick_radius, 0);
  EXPECT_GT(course.curve.back().deepest, course.first.largest_indentation);
  const double most = archard.coefficient * force * 4 * displacement;
  EXPECT_LT(course.curve.back().volume_rate, most);
  EXPECT_GT(course.curve.back().volume_rate, 0.95 * most);
  EXPECT_GE(course.curve.back().volume_rate, course.curve[1].volume_rate);
}

// At an indentation of 1 a disc that sticks bears a tangential force of up to 8 mu c (1 - c^2), at most 3.08 mu, and
// the unworn contact slides at 16/3 mu. Under 4 mu there is no limit, and the indenter wears until it bears a normal
// force of no more than 4.
TEST(WearCourse, EndsWhereTheContactNoLongerBearsTheTangentialForce) {
  WearingHalfSpace half_space(16);
  constexpr double least_force = 4, jump = 0.01;
  half_space.n_steps = 36;
  half_space.motion = one_frequency(1, 0, least_force * WearingHalfSpace::mu, 0);
  half_space.motion.tangential_force = true;
  const auto course = half_space.course(archard, jump);
  EXPECT_EQ(course.end, WearEnd::slides);
  const double force = half_space.normal.compliance.areas.dot(course.last.largest_pressure);
  EXPECT_GT(force, least_force);
  EXPECT_LT(force, least_force + 8 * jump / 10);  // the depth by which the worn flank loses 8 times as much force
}

// On the way, at the same number of cycles; its end does not depend on the step.
TEST(WearCourse, IsOfSecondOrderInTheTimeStepAndItsEndOfNone) {
  WearingHalfSpace half_space;
  half_space.body = {1, {0.5}, {1}, 0};
  half_space.motion.n_ramp_cycles = 8;
  const auto volume = [&half_space](int n_steps, double most_cycles) {
    half_space.n_steps = n_steps;
    return half_space.course(archard, 5e-3, most_cycles).curve.back().volume;
  };
  const double coarse = volume(36, 500), middle = volume(72, 500), fine = volume(144, 500);
  EXPECT_GT(std::abs(coarse - middle), 3 * std::abs(middle - fine));
  EXPECT_LT(std::abs(middle - fine), 3e-3 * fine);
  EXPECT_NEAR(volume(36, infinity) / volume(72, infinity), 1, 1e-3);
}

TEST(WearCourse, EndsWhereItIsTold) {
  const WearingHalfSpace half_space;
  const auto by_cycles = half_space.course(archard, 0.01, 700);
  EXPECT_EQ(by_cycles.end, WearEnd::cycles);
  EXPECT_EQ(by_cycles.curve.back().cycles, 700);
  const auto by_rate = half_space.course(archard, 0.01, infinity, 0.1);
  EXPECT_EQ(by_rate.end, WearEnd::rate);
  EXPECT_LE(by_rate.curve.back().volume_rate, 0.1 * by_rate.curve.front().volume_rate);
  EXPECT_GT(by_rate.curve[by_rate.curve.size() - 2].volume_rate, 0.1 * by_rate.curve.front().volume_rate);
  const auto never = half_space.course({0});
  EXPECT_EQ(never.end, WearEnd::nothing_left);
  EXPECT_EQ(never.n_jumps, 0);
  EXPECT_EQ(never.curve.size(), 1u);
}

// By a law of less than the first power the last pressures are worn off altogether, so that points lose nothing.
TEST(WearCourse, EndsByItsRateOnlyWhereThatIsAskedFor) {
  const WearingHalfSpace half_space;
  const auto course = half_space.course({archard.coefficient, 0.5});
  EXPECT_EQ(course.curve.back().volume_rate, 0);
  EXPECT_EQ(course.end, WearEnd::nothing_left);
}

// As many cycles again as there have been have to wear off nothing before nothing is left.
TEST(WearCourse, GoesOnAfterAShortJumpThatWearsOffNothing) {
  const WearingHalfSpace half_space;
  WearState state{half_space.contact_at_rest(archard)};
  wear_on(state, {10, 0, 0.01, 1e-6});
  ASSERT_EQ(state.course.end, WearEnd::cycles);
  state.goes_on = true;
  state.next_jump = 1e-3;
  const WearPoint before = state.course.curve.back();
  wear_on(state, {20, 0, 0.01, 1e-6});
  EXPECT_EQ(state.course.end, WearEnd::cycles);
  EXPECT_EQ(state.course.curve.back().cycles, 20);
  EXPECT_NEAR((state.course.curve.back().volume - before.volume) / (10 * before.volume_rate), 1, 0.1);
}

}  // namespace
}  // namespace fretval::fem::wear_course_test
