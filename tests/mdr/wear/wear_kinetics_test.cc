#include "mdr/wear/wear_kinetics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "mdr/stick/limiting_profile.h"
#include "mdr/stick/stick_radius.h"
#include "mdr/support/constants.h"
#include "mdr/wear/abel_matrices.h"
#include "mdr/wear/wear_cycle.h"

namespace fretval::mdr::wear_kinetics_test {
namespace {

const double mu = 0.6;
const Profile sphere = parabola(1);
const Motion tangential{1, 0, 0.3, 1, 1, pi / 2}, both{1, 0.15, 0.3, 1, 1, 0.7}, both_small{1, 0.15, 0.15, 1, 1, 0.7};
const PronyBody solid = standard_solid(1, 1, 0.1);
const double k = 1e-2;

double spacing(const WearKinetics& wear) {
  return wear.radius[1] - wear.radius[0];
}

// Mean |w - w_inf| over the mean of w_inf, over the area; w_inf averaged over the rings.
double distance_from_limit(const WearKinetics& wear, const Profile& profile, const PronyBody& body,
                           const Motion& motion) {
  const std::optional<double> c = stick_radii(profile, body, mu, motion).shakedown;
  const double d_max = maximum_indentation(motion);
  std::optional<LimitingProfile> limit;
  if (c) limit = limiting_profile(profile, *c, d_max);
  double off = 0, all = 0;
  for (Eigen::Index i = 0; i < wear.radius.size(); ++i) {
    double mean = 0;
    for (int point = 0; point < 20; ++point) {
      const double r = wear.radius[i] + ((point + 0.5) / 20 - 0.5) * spacing(wear);
      mean += (limit ? worn_depth(*limit, r) : std::max(d_max - shape(profile, r), 0.0)) / 20;
    }
    off += wear.radius[i] * std::abs(wear.worn_depth[i] - mean);
    all += wear.radius[i] * mean;
  }
  return off / all;
}

struct Limit {
  const char* name;
  Profile profile;
  PronyBody body;
  Motion motion;
  double error;  // at 60 springs: measured, rounded up; a stick radius that is off by half a spring makes 0.15
};

// 1e6 cycles, 1000 times what wear takes here. The errors come from the root of the worn depth at the stick radius, of
// the power 3/2 of the spacing in the mean; from 30 to 60 springs by 2.8, where the outer edge falls differently by 2.
TEST(WearKinetics, TendsToTheShakedownProfile) {
  const Limit limits[] = {{"tangential", sphere, elastic(1), tangential, 0.045},
                          {"both", sphere, elastic(1), both, 0.035},
                          {"standard solid", sphere, solid, both_small, 0.04},
                          {"Kelvin-Voigt", sphere, kelvin_voigt(1, 0.05), both_small, 0.05},
                          {"cone", cone(std::atan(0.5)), elastic(1), both, 0.02},
                          {"nothing sticks", sphere, elastic(1), {1, 0, 2, 1, 1, 0.}, 0.004}};
  for (const Limit& limit : limits) {
    const WearKinetics coarse = wear_kinetics(limit.profile, limit.body, mu, limit.motion, {k, 1e6, 30});
    const WearKinetics fine = wear_kinetics(limit.profile, limit.body, mu, limit.motion, {k, 1e6, 60});
    const double error = distance_from_limit(fine, limit.profile, limit.body, limit.motion);
    EXPECT_LT(error, limit.error) << limit.name;
    EXPECT_LT(error, distance_from_limit(coarse, limit.profile, limit.body, limit.motion) / 2) << limit.name;
    // As of 1000 times the cycles, in a contact that lasts ever shorter: their number to the power -2.
    EXPECT_LT(fine.curve.back().friction_work, 1e-5 * fine.curve.front().friction_work) << limit.name;
    EXPECT_LT(fine.curve.size(), 500U) << limit.name;
  }
}

// On its way a spring of this body loses contact for an instant, and its tractions repeat in four cycles only.
TEST(WearKinetics, FollowsSpringsThatRepeatInSeveralCycles) {
  const PronyBody body = prony(1, {1, 1}, {0.05, 0.5}, 0.02);
  const WearKinetics wear = wear_kinetics(sphere, body, mu, both_small, {k, 1e6, 100});
  EXPECT_LT(distance_from_limit(wear, sphere, body, both_small), 0.01);  // 60 springs' 0.02 to the power 3/2
}

TEST(WearKinetics, StaysInTheLimit) {
  for (const Motion& motion : {tangential, both}) {
    const WearKinetics wear = wear_kinetics(sphere, elastic(1), mu, motion, {k, 1e15, 80, 60, 0.02, {1e6}});
    // Wear of the last cycles falls like their number to the power -2 at least, where contact is ever shorter; what
    // is left like the number itself.
    EXPECT_LT((wear.worn_depth - wear.snapshots[0]).abs().maxCoeff(), 1e-5);
    EXPECT_LT(wear.curve.size(), 250U);
  }
}

TEST(WearKinetics, NothingWearsInsideTheStickRadius) {
  for (const PronyBody& body : {elastic(1), solid}) {
    const WearKinetics wear = wear_kinetics(sphere, body, mu, both_small, {k, 1e6, 80});
    const double c = *stick_radii(sphere, body, mu, both_small).shakedown;
    // The sampled cycle misses the extremes of the tractions by (pi/90)^2/2.
    EXPECT_NEAR(wear.curve.back().stick_radius, c, 6e-4);
    for (Eigen::Index i = 0; i < wear.radius.size(); ++i) {
      if (wear.radius[i] < c - spacing(wear)) {
        EXPECT_EQ(wear.worn_depth[i], 0) << wear.radius[i];
      }
    }
    EXPECT_GT(wear.worn_depth.maxCoeff(), 0.05);
  }
}

// The oracle: every cycle on its own, explicit, on the same bed, with pressures and slips of every instant.
TEST(WearKinetics, IsWearCycleByCycle) {
  const int n_cycles = 40, steps = 30;
  const WearKinetics wear = wear_kinetics(sphere, elastic(1), mu, both, {k, n_cycles, 40, steps, 0.0005});
  const Eigen::Index n = wear.radius.size();
  const SpringBed bed = spring_bed(sphere, static_cast<double>(n) * spacing(wear), n);
  const AbelMatrices matrices = abel_matrices(bed);
  SpringBed worn_bed = bed;
  SpringState state = relaxed_state(bed, elastic(1), 1);
  const SpringStep step(elastic(1), mu, 1.0 / steps);
  const IndenterPath path = ramped_path(harmonic_motion(both), 3);
  const auto pressure = [&] { return Eigen::VectorXd((4 * matrices.stress * state.normal_load.matrix()).cwiseMax(0)); };
  Eigen::ArrayXd worn = Eigen::ArrayXd::Zero(n);
  for (int cycle = 0; cycle < n_cycles + 5; ++cycle) {
    Eigen::ArrayXd more = Eigen::ArrayXd::Zero(n);
    for (int i = 1; i <= steps; ++i) {
      const SpringState before = state;
      const Eigen::VectorXd p = pressure();
      step.advance(state, worn_bed, path(cycle + static_cast<double>(i) / steps));
      const double shift = state.indenter.tangential - before.indenter.tangential;
      const Eigen::VectorXd move = (shift - (state.tangential_shift - before.tangential_shift)).matrix();
      more += k * ((p + pressure()).array() / 2) * (matrices.displacement * move).array().abs();
    }
    if (cycle < 5) continue;  // ramp and settling
    worn += more;
    worn_bed.depth = bed.depth + (matrices.image * worn.matrix()).array();
  }
  // Measured 0.01: at this k a cycle relieves the pressure by a fiftieth, which explicit cycles do not see.
  EXPECT_GT(worn.maxCoeff(), 0.02);
  EXPECT_LT((wear.worn_depth - worn).abs().maxCoeff(), 0.02 * worn.maxCoeff());
}

// Of second order but for rings that begin to wear inside a jump.
TEST(WearKinetics, SmallerJumpsAreCloser) {
  const auto volume = [](double largest_jump) {
    return wear_kinetics(sphere, elastic(1), mu, both, {k, 100, 40, 30, largest_jump}).curve.back().volume;
  };
  const double coarse = volume(0.008), middle = volume(0.004), fine = volume(0.002);
  EXPECT_LT(std::abs(middle - fine), 2e-3 * fine);
  EXPECT_GT((coarse - middle) / (middle - fine), 2.5);
}

// Springs that touch inside a step are held from then on.
TEST(WearKinetics, IsOfSecondOrderInTheTimeStep) {
  for (const PronyBody& body : {elastic(1), solid}) {
    const auto volume = [&body](int steps) {
      return wear_kinetics(sphere, body, mu, both_small, {k, 300, 60, steps, 0.005}).curve.back().volume;
    };
    const double coarse = volume(45), middle = volume(90), fine = volume(180);
    EXPECT_LT(std::abs(middle - fine), 3e-3 * fine);
    EXPECT_GT((coarse - middle) / (middle - fine), 3.5);
  }
}

TEST(WearKinetics, OnlyWearCoefficientTimesCyclesMatters) {
  const WearKinetics slow = wear_kinetics(sphere, solid, mu, both_small, {k, 500, 50});
  const WearKinetics fast = wear_kinetics(sphere, solid, mu, both_small, {10 * k, 50, 50});
  // The same jumps but for roundoff.
  EXPECT_EQ(slow.curve.size(), fast.curve.size());
  EXPECT_LT((slow.worn_depth - fast.worn_depth).abs().maxCoeff(), 1e-12);
}

TEST(WearKinetics, UnitsDoNotMatter) {
  const double nano = 1e9, giga = 1e-9;
  const PronyBody small_body = standard_solid(giga, giga, 0.1);
  Motion motion = both_small;
  motion.indentation *= nano, motion.normal_amplitude *= nano, motion.tangential_amplitude *= nano;
  const WearKinetics si = wear_kinetics(sphere, solid, mu, both_small, {k, 500, 50});
  const WearKinetics nm = wear_kinetics(parabola(nano), small_body, mu, motion, {k / giga, 500, 50});
  EXPECT_LT((nm.worn_depth / nano - si.worn_depth).abs().maxCoeff(), 1e-10);
  EXPECT_NEAR(nm.curve.back().volume / std::pow(nano, 3), si.curve.back().volume, 1e-10);
  EXPECT_NEAR(nm.curve.back().friction_work / (giga * std::pow(nano, 3)), si.curve.back().friction_work, 1e-10);
}

TEST(WearKinetics, CurvesAreMonotone) {
  for (const PronyBody& body : {elastic(1), solid}) {
    const WearKinetics wear = wear_kinetics(sphere, body, mu, both, {k, 1e5, 60});
    const double most = wear.curve.front().friction_work;
    for (std::size_t i = 1; i < wear.curve.size(); ++i) {
      EXPECT_GT(wear.curve[i].cycles, wear.curve[i - 1].cycles);
      EXPECT_GE(wear.curve[i].volume, wear.curve[i - 1].volume);
      EXPECT_GE(wear.curve[i].deepest, wear.curve[i - 1].deepest);
      EXPECT_EQ(wear.curve[i].stick_radius, wear.curve[0].stick_radius);
      // Bounded by the first, not below the one before: slip grows while pressure falls.
      EXPECT_LT(wear.curve[i].friction_work, 1.2 * most);
    }
    EXPECT_EQ(wear.curve.back().cycles, 1e5);
    EXPECT_LT(wear.curve.back().friction_work, 1e-5 * most);
  }
}

// Reye: volume times mu/k is the friction work, summed over the cycles by the trapezoidal rule.
TEST(WearKinetics, VolumeIsFrictionWork) {
  const WearKinetics wear = wear_kinetics(sphere, elastic(1), mu, tangential, {k, 400, 60, 60, 0.001});
  double work = 0;
  for (std::size_t i = 1; i < wear.curve.size(); ++i)
    work += (wear.curve[i].cycles - wear.curve[i - 1].cycles) *
            (wear.curve[i].friction_work + wear.curve[i - 1].friction_work) / 2;
  // First order in the jumps: a hundredth each of the one before, and of d_max/1000.
  EXPECT_NEAR(wear.curve.back().volume * mu / (k * work), 1, 0.02);
}

TEST(WearKinetics, SnapshotsAreStatesOnTheWay) {
  const WearKinetics wear = wear_kinetics(sphere, elastic(1), mu, both, {k, 300, 50, 60, 0.002, {30, 100, 300}});
  ASSERT_EQ(wear.snapshots.size(), 3U);
  EXPECT_TRUE((wear.snapshots[2] == wear.worn_depth).all());
  EXPECT_EQ(wear.curve.back().deepest, wear.worn_depth.maxCoeff());
  EXPECT_TRUE((wear.snapshots[1] >= wear.snapshots[0]).all());
  const WearKinetics alone = wear_kinetics(sphere, elastic(1), mu, both, {k, 100, 50, 60, 0.002});
  // The jumps fall a little differently: within their own error.
  EXPECT_LT((wear.snapshots[1] - alone.worn_depth).abs().maxCoeff(), 0.002);
}

TEST(WearKinetics, NothingWearsWithoutSlip) {
  const Motion normal{1, 0.3, 0, 1, 1, 0.}, still{1, 0, 0, 1, 1, 0.};
  for (const PronyBody& body : {elastic(1), solid}) {
    for (const Motion& motion : {normal, still}) {
      const WearKinetics wear = wear_kinetics(sphere, body, mu, motion, {k, 1e6, 40});
      EXPECT_EQ(wear.worn_depth.maxCoeff(), 0);
      EXPECT_EQ(wear.curve.back().cycles, 1e6);
      EXPECT_EQ(wear.curve.back().friction_work, 0);
    }
  }
  EXPECT_EQ(wear_kinetics(sphere, elastic(1), mu, both, {0, 1e6, 40}).worn_depth.maxCoeff(), 0);
  EXPECT_EQ(wear_kinetics(sphere, elastic(1), mu, both, {k, 0, 40}).curve.size(), 1U);
}

// Phase 0, 2 u_x0 < 3 mu Delta d: what touches sticks at once and until it leaves.
TEST(WearKinetics, InPhaseNothingWears) {
  const Motion motion{1, 0.3, 0.2, 1, 1, 0.};
  for (const PronyBody& body : {elastic(1), solid, kelvin_voigt(1, 0.05)})
    EXPECT_EQ(wear_kinetics(sphere, body, mu, motion, {k, 1e6, 60}).worn_depth.maxCoeff(), 0);
}

void expect_rejected(const Motion& motion, const WearControl& control, const std::string& name) {
  try {
    wear_kinetics(sphere, elastic(1), mu, motion, control);
    ADD_FAILURE() << name << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

TEST(WearKinetics, BadArgumentsAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_rejected(both, {-1, 10}, "wear coefficient");
  expect_rejected(both, {k, nan}, "number of cycles");
  expect_rejected(both, {k, 10, 5}, "number of springs");
  expect_rejected(both, {k, 10, 50, 4}, "steps per cycle");
  expect_rejected(both, {k, 10, 50, 90, 0}, "largest jump");
  expect_rejected(both, {k, 10, 50, 90, 0.01, {11}}, "snapshot");
  expect_rejected(both, {k, 10, 50, 90, 0.01, {5, 4}}, "snapshot");
  expect_rejected({1, 0.1, 0.1, 1, 2, 0.}, {k, 10}, "equal frequencies");
  expect_rejected({1, 0.1, 0.1, 1, 1, {}}, {k, 10}, "locked phase");
  EXPECT_THROW(wear_kinetics(sphere, elastic(1), 0, both, {k, 10}), std::invalid_argument);
  EXPECT_THROW(wear_kinetics(tabulated({0, 0.5, 1.1}, {0, 0.125, 0.605}), elastic(1), mu, both, {k, 10}),
               std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::wear_kinetics_test
