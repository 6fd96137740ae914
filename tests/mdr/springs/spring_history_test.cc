#include "mdr/springs/spring_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mdr/motion/force_control.h"
#include "mdr/springs/spring_foundation.h"

namespace fretval::mdr::spring_history_test {
namespace {

const double mu = 0.6;
const Profile sphere = parabola(1);

SpringBed bed_for(const Motion& motion, Eigen::Index n) {
  return spring_bed(sphere, 1.01 * inverse_transform(sphere, maximum_indentation(motion)), n);
}

SpringHistory history_of(const PronyBody& body, const Motion& motion, int steps, int ramp_periods, double periodicity,
                         Eigen::Index n_springs = 100) {
  const HistoryControl control{1 / motion.normal_frequency, steps, ramp_periods, 2000, periodicity};
  return spring_history(bed_for(motion, n_springs), body, mu,
                        {ramped_path(harmonic_motion(motion), ramp_periods / motion.normal_frequency), {}, {}},
                        control);
}

// The transient springs know neither M+ nor M-. Elastic: only the sampled extremes of the margins are off, by the
// fourth order of the angle of a step.
TEST(SpringHistory, ElasticSpringsGiveBothStickDepths) {
  for (const double phase : {0.0, 0.7, 1.2, 2.5, -0.7}) {
    const Motion motion{1, 0.15, 0.1, 1, 1, phase};
    const StickDepths expected = stick_depths(elastic(1), mu, motion);
    const SpringHistory history = history_of(elastic(1), motion, 180, 10, 1e-9);
    EXPECT_NEAR(history.depths.first_slip, expected.first_slip, 2e-8) << phase;
    EXPECT_NEAR(history.depths.shakedown, expected.shakedown, 2e-8) << phase;
  }
}

TEST(SpringHistory, ViscoelasticSpringsGiveBothStickDepths) {
  for (const PronyBody& body : {standard_solid(1, 1.5, 0.3), kelvin_voigt(1, 0.15), prony(1, {1, 0.5}, {0.05, 0.4})}) {
    for (const double phase : {0.0, 0.7}) {
      const Motion motion{1, 0.15, 0.1, 1, 1, phase};
      const StickDepths expected = stick_depths(body, mu, motion);
      const SpringHistory history = history_of(body, motion, 360, 40, 1e-6);
      // A ramp over 40 periods overshoots by 1/40^2 of what one over 10 does, which is 5e-5; time steps 1e-5.
      EXPECT_NEAR(history.depths.first_slip, expected.first_slip, 2e-5) << phase;
      EXPECT_NEAR(history.depths.shakedown, expected.shakedown, 2e-5) << phase;
    }
  }
}

// A slow branch takes 500 periods: 5e4 steps, each of which moves a spring that sticks by roundoff.
TEST(SpringHistory, RoundoffOfManyStepsIsNoSlip) {
  const Motion motion{1, 0.08, 0.057, 1, 1, 0.0};
  const PronyBody body = standard_solid(1, 1, 49);
  const SpringHistory history = spring_history(
      bed_for(motion, 5), body, mu, {ramped_path(harmonic_motion(motion), 20), {}, {}}, {1, 90, 20, 4000, 1e-10});
  EXPECT_GT(history.n_periods, 500);
  EXPECT_NEAR(history.depths.first_slip, stick_depths(body, mu, motion).first_slip, 2e-4);  // start: the ramp is short
}

// A body eight times stiffer in motion, in phase, k = 1.02, no first-slip zone: all springs still slip a little when
// their tractions repeat to 1e-6, and none of them sticks. What they would stick at is in their margins.
TEST(SpringHistory, KnowsWhereSpringsThatSettleWillStick) {
  const Motion motion{1, 0.12, 1.5 * mu * 0.12 / 1.02, 1, 1, 0.0};
  const PronyBody body = standard_solid(1, 7, 0.2);
  const SpringHistory history = history_of(body, motion, 360, 20, 1e-6);
  const double exact = stick_depths(body, mu, motion).shakedown;
  EXPECT_GT(exact, 0.2);
  EXPECT_LT(history.depths.shakedown, 0.01);
  EXPECT_NEAR(history.settling_depth, exact, 1e-4);
}

TEST(SpringHistory, NothingSticksUnderAWideMotion) {
  const Motion motion{1, 0.2, 2, 1, 1, 0.7};
  EXPECT_LT(stick_depths(elastic(1), mu, motion).shakedown, 0);
  const SpringHistory history = history_of(elastic(1), motion, 90, 5, 1e-9);
  EXPECT_LE(history.depths.first_slip, 0.01);
  EXPECT_LE(history.depths.shakedown, 0.01);
  EXPECT_GT(history.slip_amplitude[0], 0);
}

// Normal response of the periodic state, computed without marching by mdr/spring_foundation.h.
TEST(SpringHistory, ForceIsThatOfThePeriodicState) {
  const Motion motion{1, 0.4, 0.01, 1, 1, 0.7};
  const double outer = inverse_transform(sphere, maximum_indentation(motion));
  const auto g = [](double x) { return x * x; };
  for (const PronyBody& body : {standard_solid(1, 1.5, 0.3), kelvin_voigt(1, 0.15)}) {
    const NormalResponse periodic = periodic_normal_response(g, outer, body, motion);
    const SpringHistory history =
        spring_history(spring_bed(sphere, outer, 1000), body, 100, {ramped_path(harmonic_motion(motion), 5), {}, {}},
                       {1, 360, 5, 400, 1e-6});
    const auto [least, most] = std::minmax_element(history.normal_force.begin(), history.normal_force.end());
    // Time step and springs: second order in 1/360 and 1/1000; with a dashpot springs touch with a jump.
    const double tolerance = body.viscosity > 0 ? 1e-3 : 2e-5;
    EXPECT_NEAR(*most / periodic.normal_force_max, 1, tolerance);
    EXPECT_NEAR(*least / periodic.normal_force_max, periodic.normal_force_min / periodic.normal_force_max, tolerance);
  }
}

TEST(SpringHistory, WorkOfAPeriodIsHeat) {
  const Motion motion{1, 0.15, 0.3, 1, 1, 0.7};
  const SpringHistory history = history_of(standard_solid(1, 1.5, 0.3), motion, 360, 10, 1e-8, 400);
  EXPECT_GT(history.friction_work, 0);
  EXPECT_GT(history.bulk_work, 0);
  EXPECT_NEAR((history.friction_work + history.bulk_work) / history.indenter_work, 1, 5e-5);  // (2 pi/360)^2/6
}

// Springs that touch inside a step are free until then; held from its start on, they make this the first order.
// Measured 1.5e-3, 4.3e-4, 1.1e-4 with elastic springs, 1.5e-4, 5.9e-5, 2.9e-6 with a branch.
TEST(SpringHistory, FrictionWorkIsOfSecondOrderInTimeWhereContactComesAndGoes) {
  const Motion motion{1, 0.25, 0.17, 1, 1, 1.0};
  for (const PronyBody& body : {elastic(1), standard_solid(1, 1.5, 0.3)}) {
    const auto work = [&](int steps) { return history_of(body, motion, steps, 10, 1e-8).friction_work; };
    const double exact = (4 * work(1440) - work(720)) / 3;
    for (const int n : {60, 120, 240}) EXPECT_LT(std::abs(work(n) / exact - 1), 8.0 / n / n) << n;
  }
}

// The offset of a spring that has shaken down: the traction that makes both margins equal, (M+ - M-)/2 in depth.
TEST(SpringHistory, LockedInTractionIsTheBestOffset) {
  const Motion motion{1, 0.15, 0.1, 1, 1, 0.4};
  const SpringBed bed = bed_for(motion, 100);
  const SpringHistory history = history_of(elastic(1), motion, 360, 10, 1e-9);
  const double forward = std::hypot(0.1 / (1.5 * mu) * std::cos(0.4) - 0.15, 0.1 / (1.5 * mu) * std::sin(0.4));
  const double backward = std::hypot(0.1 / (1.5 * mu) * std::cos(0.4) + 0.15, 0.1 / (1.5 * mu) * std::sin(0.4));
  // The outermost spring inside the shakedown radius was pushed furthest.
  Eigen::Index j = 0;
  while (bed.depth[j + 1] < history.depths.shakedown) ++j;
  const double best = 1.5 * mu * (forward - backward) / 2;
  EXPECT_NEAR(history.mean_traction[j], -best, 0.03 * std::abs(best));  // one spring of 100 short of the edge
  EXPECT_NEAR(history.mean_traction[0], 0, 1e-3 * std::abs(best));
}

// Barber, Davies and Hills (2011): under two forces the elastic contact sticks for good where the unworn contact under
// the force of the two tangents would reach, whatever the indenter does meanwhile. It holds for viscoelastic bodies as
// well: at the two instants that decide, all springs outside slip the same way, so that the oscillation of F_x -+ mu
// F_z is that of the springs inside, whose rheology cancels.
TEST(SpringHistory, ForceControlledContactFollowsTheTwoTangentsForAnyRheology) {
  const double F0 = 1, swing = 0.2, pull = 0.1, G = 1;
  const SpringBed bed =
      spring_bed(sphere, 1.01 * inverse_transform(sphere, indentation_for_force(sphere, G, F0 + swing)), 800);
  for (const PronyBody& body : {elastic(G), standard_solid(G, 1.5, 0.3)}) {
    for (const double phase : {0.0, 0.9}) {
      const Loading loading{{}, ramped_force(F0, swing, 1, 0, 5), ramped_force(0, pull, 1, phase, 5)};
      const SpringHistory history = spring_history(bed, body, mu, loading, {1, 90, 5, 100, 1e-6});
      const double x = pull / mu * std::cos(phase), y = pull / mu * std::sin(phase);
      const double tangents = F0 - (std::hypot(x - swing, y) + std::hypot(x + swing, y)) / 2;
      // Springs: second order in 1/800; time: the fourth order of a step, for a body with branches the second.
      EXPECT_NEAR(history.depths.shakedown / indentation_for_force(sphere, G, tangents), 1,
                  body.branch_moduli.empty() ? 1e-5 : 1e-4)
          << phase;
      EXPECT_NEAR(*std::max_element(history.normal_force.begin(), history.normal_force.end()), F0 + swing, 1e-9);
      // Nothing slips at phase 0, up to the springs at the edge; else the time step counts, (2 pi/90)^2.
      EXPECT_NEAR(history.friction_work + history.bulk_work, history.indenter_work,
                  5e-3 * history.indenter_work + 1e-6);
    }
  }
}

// The normal force that a prescribed motion takes, prescribed in turn, gives the same stick depth.
TEST(SpringHistory, ForceControlOfAViscoelasticBodyGivesItsMotionBack) {
  const Motion motion{1, 0.15, 0.1, 1, 1, 0.7};
  const PronyBody body = standard_solid(1, 1.5, 0.3);
  const SpringBed bed = bed_for(motion, 100);
  const HistoryControl control{1, 90, 10, 400, 1e-7};
  const SpringHistory free = spring_history(bed, body, mu, {ramped_path(harmonic_motion(motion), 10), {}, {}}, control);
  const auto force_at = [&](const std::vector<double>& force) {
    return [force](double time) {
      return force[static_cast<std::size_t>(std::lround(90 * (time - std::floor(time)))) % 90];
    };
  };
  const SpringHistory driven = spring_history(
      bed, body, mu, {ramped_path(harmonic_motion(motion), 10), force_at(free.normal_force), {}}, control);
  EXPECT_NEAR(driven.depths.shakedown, free.depths.shakedown, 1e-5);
}

TEST(SpringHistory, SaysWhenTheContactSlidesUnderAForce) {
  const SpringBed bed = spring_bed(sphere, 1, 50);
  const Loading loading{{}, ramped_force(1, 0, 1, 0, 5), ramped_force(0, 0.7, 1, 0, 5)};
  EXPECT_THROW(spring_history(bed, elastic(1), mu, loading, {1, 90, 5, 100, 1e-7}), std::runtime_error);
  EXPECT_THROW(spring_history(bed, elastic(1), mu, {{}, ramped_force(1, 0, 1, 0, 5), {}}, {1, 90}),
               std::invalid_argument);
}

TEST(SpringHistory, RejectsBadArgumentsAndSaysWhenItIsNotPeriodic) {
  const Motion motion{1, 0.15, 0.1, 1, 1, 0.4};
  const Loading path{ramped_path(harmonic_motion(motion), 1), {}, {}};
  const SpringBed bed = bed_for(motion, 10);
  EXPECT_THROW(spring_history(bed, elastic(1), mu, path, {0, 360}), std::invalid_argument);
  EXPECT_THROW(spring_history(bed, elastic(1), mu, path, {1, 2}), std::invalid_argument);
  EXPECT_THROW(spring_history(bed, elastic(1), mu, path, {1, 360, 10, 5}), std::invalid_argument);
  EXPECT_THROW(spring_history(bed, prony(1, {1}, {300}), mu, path, {1, 60, 1, 4, 1e-12}), std::runtime_error);
}

TEST(PeriodsOfCreep, AreAnIntegerOfAnyBodyAndNotTooManyToStep) {
  const PronyBody slow{1, {1}, {1e300}, 0};
  EXPECT_GT(periods_of_creep(slow, 1), 10'000);
  EXPECT_EQ(periods_of_creep({2, {1}, {30}, 0}, 1), 150);
  EXPECT_EQ(most_periods_with(150), 2000);
  EXPECT_EQ(most_periods_with(3000), 6000);
  try {
    most_periods_with(10'001);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("set the Duration of the test"), std::string::npos) << error.what();
  }
}

// Before the motion begins the body has rested at its mean indentation for long: nothing of that is left to settle,
// which would take some 70 periods here.
TEST(SpringHistory, BeginsWithARelaxedBodyAtTheMeanIndentation) {
  const Motion motion{1, 1e-5, 1e-5, 1, 1, 0.0};
  const SpringHistory history = history_of(standard_solid(1, 1, 10), motion, 90, 2, 1e-3);
  EXPECT_LE(history.n_periods, 6);
}

}  // namespace
}  // namespace fretval::mdr::spring_history_test
