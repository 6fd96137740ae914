#include "comparison/simulation/near_cycle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/accuracy/prepared_case.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

FemCase with_ratio(double ratio, const char* rheology = "elastic") {
  Case input = read_case();
  if (std::string(rheology) == "elastic") input.elastomer = {"elastic", 1e6, {}, {}, 0, 0, {}};
  input.motion.tangential_frequency = ratio;
  return prepare({input}).front().fem;
}

int order_of(const NearCycle& near) {
  return near.cycle.tangential_orders.front();
}

// A = 2 u_x0/(3 mu), orders p and q: (pi^2/2) A D/(A p^2 + D q^2), see mdr/motion/commensurability.h.
TEST(NearCycle, IsAConvergentOfTheGoldenRatio) {
  const auto fem = with_ratio((1 + std::sqrt(5)) / 2);
  const auto near = near_cycle(fem, 96);
  EXPECT_EQ(order_of(near), 89);
  EXPECT_EQ(near.cycle.normal_orders.front(), 55);
  EXPECT_DOUBLE_EQ(near.cycle.frequency, 1.0 / 55);
  EXPECT_FALSE(near.creeps);
  const double pi = std::acos(-1.0), A = 1.5e-5 / 0.75 / 1.2e-4, D = 2e-5 / 1.2e-4;
  EXPECT_NEAR(near.error_of_demand, pi * pi / 2 * A * D / (A * 89 * 89 + D * 55 * 55), 1e-12);
}

// Two generators that drift apart slowly go through all lags of a single cycle.
TEST(NearCycle, CreepsWhereTheFrequenciesAreNearlyEqual) {
  const auto near = near_cycle(with_ratio(1.00001), 96);
  EXPECT_EQ(order_of(near), 1);
  EXPECT_TRUE(near.creeps);
}

// With memory the rounded frequency has another |G|; at least by so much may a demand be off.
TEST(NearCycle, RoundingCountsInABodyWithMemory) {
  const auto fem = with_ratio(std::acos(-1.0), "standard solid");
  const auto near = near_cycle(fem, 30);
  const auto& [relaxed, moduli, times, viscosity] = fem.relaxation;
  const auto stiffening = [&](double frequency) {
    const double x = 2 * std::acos(-1.0) * frequency / fem.units.angular_frequency * times[0];
    return std::hypot(1 + moduli[0] * x * x / (1 + x * x), moduli[0] * x / (1 + x * x));
  };
  const double rounded = order_of(near) * near.cycle.frequency, A = 1.5e-5 / 0.75 / 1.2e-4;
  EXPECT_GE(near.error_of_demand, A * std::abs(stiffening(rounded) - stiffening(std::acos(-1.0))));
}

TEST(NearCycle, IsTheShortestWhereThatIsTooLong) {
  EXPECT_EQ(order_of(near_cycle(with_ratio(300.5), 96)), 301);
}

}  // namespace
}  // namespace fretval
