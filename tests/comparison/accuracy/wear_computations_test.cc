#include "comparison/accuracy/wear_computations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparison/accuracy/refinement.h"
#include "tests/comparison/wearing_case.h"

namespace fretval::wear_computations_test {
namespace {

Resolution coarse() {
  auto r = with_steps(with_rings(resolution_for_wear(resolution_for(1e-3, false)), 0.25), 0.25);
  r.degree = 2;
  r.wear_jump = 0.02;
  return r;
}

// The share of what is asked for never falls, and ends at all of it; twice as many steps are twice the work, so what
// was there is a third of all that is asked for then. The distance falls to what the rings leave.
TEST(WearComputations, TellTheShareThatIsDoneAndTheDistanceToTheLimit) {
  const auto prepared = wearing_case("  set Coefficient = 1e-12\n");
  const auto limits = wear_limits(prepared.mdr, mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr)));
  const double c = limits.shakedown.stick_radius / prepared.fem.units.length;
  std::vector<double> shares, distances;
  BodyStore bodies;
  WearComputations computed(prepared, {c, 1.5}, limits, bodies, {{}, [&](double share, double distance) {
                                                                   shares.push_back(share);
                                                                   distances.push_back(distance);
                                                                 }});
  const auto first = coarse(), second = with_steps(first, 2);
  for (const auto& [resolution, before] : {std::pair(first, 0.0), {second, 1.0 / 3}}) {
    shares.clear();
    distances.clear();
    computed.compute({resolution});
    EXPECT_GT(shares.size(), 10u);
    EXPECT_GT(shares.front(), before);
    EXPECT_LT(shares.front(), before + 0.15);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_NEAR(shares.back(), 1, 0.02);
    EXPECT_GT(distances.front(), 0.1);
    EXPECT_LT(distances.back(), 0.5 / 16);
    const auto& fe = computed.all.at(resolution).fe;
    EXPECT_EQ(distances.back(), distances_of(fe, prepared.fem.units, limits.shakedown).back());
  }
  EXPECT_EQ(computed.all.size(), 2u);
}

// Over rings of equal areas s = r^2 a depth of 1 + s^2 has means of a twelfth of the squared area more than at their
// centres; the first and the last one are left as they are.
TEST(WearComputations, HaveTheDepthAtTheCentreOfARing) {
  constexpr int n = 10;
  constexpr double area = 0.1;
  WearSimulation wear;
  wear.centre.resize(n);
  wear.unworn = Eigen::VectorXd::Constant(n, 0.5);
  Eigen::VectorXd means(n), there(n);
  wear.radii = {0};
  for (int i = 0; i < n; ++i) {
    const double middle = (i + 0.5) * area;
    wear.radii.push_back(std::sqrt((i + 1) * area));
    wear.centre[i] = std::sqrt(middle);
    there[i] = 1 + middle * middle;
    means[i] = there[i] + area * area / 12;
  }
  const auto chain = chain_of(wear, means, 2);
  ASSERT_EQ(chain.size(), 10U);
  for (int i = 1; i + 1 < n; ++i) EXPECT_NEAR(chain[static_cast<std::size_t>(i)].y(), 2 * (0.5 + there[i]), 1e-12) << i;
  for (const int i : {0, n - 1}) EXPECT_NEAR(chain[static_cast<std::size_t>(i)].y(), 2 * (0.5 + means[i]), 1e-12) << i;
}

TEST(WearComputations, FailuresOfTheNumericsArePartOfTheAnswer) {
  const auto prepared = wearing_case("  set Coefficient = 1e-12\n");
  const auto limits = wear_limits(prepared.mdr, mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr)));
  BodyStore bodies;
  WearComputations computed(prepared, {0.6, 0.85}, limits, bodies, {});
  const auto r = coarse();
  computed.compute({r});
  EXPECT_NE(computed.all.at(r).failure, "");
}

}  // namespace
}  // namespace fretval::wear_computations_test
