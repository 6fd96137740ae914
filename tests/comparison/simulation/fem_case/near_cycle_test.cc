#include "comparison/simulation/fem_case/near_cycle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace fretval {
namespace {

constexpr double friction = 0.5, normal_amplitude = 2e-5, tangential_amplitude = 1.5e-5;
const double golden = (1 + std::sqrt(5)) / 2;

/// Normal frequency 2 Hz.
mdr::HarmonicMotion with_ratio(double ratio) {
  return {1e-4, {{normal_amplitude, 2, 0}}, {{tangential_amplitude, 2 * ratio, 0}, {0, 1, 0}}};
}

double elastic(double /*frequency*/) {
  return 1;
}

/// Of a Kelvin-Voigt body.
double stiffening(double frequency) {
  return std::hypot(1, 0.1 * frequency);
}

/// Displacements.
NearCycle cycle_near(const mdr::HarmonicMotion& motion, double (*stiffening_at)(double), bool scaled = false) {
  const auto demand = [stiffening_at](double per_amplitude) {
    return [=](double amplitude, double frequency) { return per_amplitude * amplitude * stiffening_at(frequency); };
  };
  return near_cycle(motion, stiffening_at, {demand(1), demand(1 / (1.5 * friction)), scaled}, 48);
}

int order_of(const NearCycle& near) {
  return near.cycle.tangential_orders.front();
}

// Convergents of the golden ratio are ... 55/34, 89/55, 144/89 ... For p/q the lags are off by
// (pi^2/2) A D/(A p^2 + D q^2), A = 2 u_x0/(3 mu), see mdr/motion/commensurability.h, and |G| by its rounding.
TEST(NearCycle, IsAConvergentOfTheGoldenRatio) {
  const auto near = cycle_near(with_ratio(golden), stiffening);
  EXPECT_EQ(near.cycle.tangential_orders, (std::vector<int>{89, 0}));
  EXPECT_EQ(near.cycle.normal_orders.front(), 55);
  EXPECT_DOUBLE_EQ(near.cycle.frequency, 2.0 / 55);
  EXPECT_FALSE(near.creeps);
  const double pi = std::acos(-1.0), rounded = 2.0 * 89 / 55, A = tangential_amplitude / 0.75 * stiffening(rounded),
               D = normal_amplitude * stiffening(2);
  const double lags = pi * pi / 2 * A * D / (A * 89 * 89 + D * 55 * 55),
               rounding = std::abs(A - tangential_amplitude / 0.75 * stiffening(2 * golden));
  EXPECT_NEAR(near.error_of_demand, lags + rounding, 1e-9 * normal_amplitude);
}

// The frequency does not matter to an elastic body: the longest cycle in lowest terms has the finest lags.
TEST(NearCycle, HasTheFinestLagsWhereTheBodyIsElastic) {
  const auto near = cycle_near(with_ratio(golden), elastic);
  EXPECT_EQ(order_of(near), 95);
  EXPECT_EQ(near.cycle.normal_orders.front(), 59);
}

// Second harmonics are locked to the first ones, and stay so: lags are those of the first ones alone.
TEST(NearCycle, KeepsHarmonicsOfOneDirectionTogether) {
  auto motion = with_ratio(golden);
  motion.tangential.push_back({1e-6, 6 * golden, 1});
  motion.normal.push_back({1e-6, 4, 1});
  const auto near = cycle_near(motion, stiffening);
  EXPECT_EQ(near.cycle.tangential_orders[2], 3 * near.cycle.tangential_orders[0]);
  EXPECT_EQ(near.cycle.normal_orders[1], 2 * near.cycle.normal_orders[0]);
  EXPECT_LE(near.cycle.highest_order(), 96);
}

// The first normal frequency is kept, the second one rounded.
TEST(NearCycle, KnowsWhatTheRoundingOfNormalFrequenciesMakes) {
  const auto near = cycle_near({1e-4, {{2e-5, 1, 0}, {1e-5, std::sqrt(2), 0}}, {{0, 1, 0}}}, stiffening);
  const double rounded = 1.0 * near.cycle.normal_orders[1] / near.cycle.normal_orders[0];
  EXPECT_NEAR(near.error_of_normal, 1e-5 * std::abs(stiffening(std::sqrt(2)) - stiffening(rounded)), 1e-20);
  EXPECT_GT(near.error_of_normal, 0);
  EXPECT_EQ(cycle_near(with_ratio(golden), stiffening).error_of_normal, 0);
}

// Two generators that drift apart slowly go through all lags of a single cycle.
TEST(NearCycle, CreepsWhereTheFrequenciesAreNearlyEqual) {
  const auto near = cycle_near(with_ratio(1.00001), stiffening);
  EXPECT_EQ(order_of(near), 1);
  EXPECT_TRUE(near.creeps);
}

// A cycle of 1001 and 1000 oscillations is too long: its directions are rounded as if they had no common period.
TEST(NearCycle, TakesTheDirectionsOfALongCycleForIndependent) {
  const auto near = cycle_near(with_ratio(1.001), elastic);
  EXPECT_EQ(order_of(near), 1);
  EXPECT_TRUE(near.creeps);
}

// The tangential motion has twice the frequency of the second normal harmonic, and keeps it; nothing can creep.
TEST(NearCycle, KeepsWhatIsTiedAcrossTheDirections) {
  const auto near =
      cycle_near({1e-4, {{2e-5, 1, 0}, {1e-5, std::sqrt(2), 0}}, {{1.5e-5, 2 * std::sqrt(2), 0}}}, elastic);
  EXPECT_EQ(order_of(near), 2 * near.cycle.normal_orders[1]);
  EXPECT_EQ(near.cycle.normal_orders[1], std::lround(std::sqrt(2) * near.cycle.normal_orders[0]));
  EXPECT_FALSE(near.creeps);
  EXPECT_EQ(near.error_of_normal, 0) << "elastic";
  EXPECT_THROW(cycle_near({1e-4, {{2e-5, 1, 0}, {1e-5, std::sqrt(2), 0}}, {{1.5e-5, std::sqrt(3), 0}}}, elastic),
               std::invalid_argument);
}

// Both are tangential, and would creep together: what one period of them leaves open is in the error.
TEST(NearCycle, DoesNotCreepInOneDirection) {
  const auto near = cycle_near({1e-4, {{0, 1, 0}}, {{1.5e-5, 1, 0}, {1.5e-5, 1.00001, 3}}}, elastic);
  EXPECT_FALSE(near.creeps);
  EXPECT_GT(near.error_of_demand, 1.5e-5 / (1.5 * friction));
}

// Their forces are as large at any frequency: lags alone are left.
TEST(NearCycle, OfScaledDisplacementsLosesNothingByRounding) {
  const auto near = cycle_near(with_ratio(golden), stiffening, true);
  EXPECT_EQ(order_of(near), 95);
  const double pi = std::acos(-1.0), A = tangential_amplitude / 0.75 * stiffening(2 * golden),
               D = normal_amplitude * stiffening(2);
  EXPECT_NEAR(near.error_of_demand, pi * pi / 2 * A * D / (A * 95 * 95 + D * 59 * 59), 1e-9 * normal_amplitude);
}

TEST(NearCycle, BringsScaledDisplacementsThatAreFarFromTheNormalOnesToTheGoldenRatio) {
  for (const auto& [ratio, near_ratio] : std::vector<std::pair<double, double>>{
           {300.4, golden}, {8.1, golden}, {7.9, 7.9}, {1 / 7.9, 1 / 7.9}, {1 / 8.1, 1 / golden}, {1e-3, 1 / golden}}) {
    const auto near = cycle_near(with_ratio(ratio), stiffening, true);
    EXPECT_NEAR(1.0 * order_of(near) / near.cycle.normal_orders.front(), near_ratio, 0.02 * near_ratio) << ratio;
    EXPECT_LE(near.cycle.highest_order(), 96) << ratio;
    EXPECT_LT(near.error_of_demand, 2e-3 * normal_amplitude) << ratio;
  }
}

TEST(NearCycle, IsTheShortestWhereThatIsTooLong) {
  const auto near = cycle_near(with_ratio(300.4), stiffening);
  EXPECT_EQ(order_of(near), 300);
  EXPECT_EQ(near.cycle.normal_orders.front(), 1);
  EXPECT_FALSE(near.creeps);
}

}  // namespace
}  // namespace fretval
