#include "comparison/accuracy/wear_computations.h"

#include <gtest/gtest.h>

#include <algorithm>

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

// The share of all that is asked for never falls, and ends at all of it; the distance falls to what the rings leave.
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
  computed.compute({first, second});
  EXPECT_GT(shares.size(), 10u);
  EXPECT_LT(shares.front(), 0.2);
  EXPECT_GT(distances.front(), 0.1);
  EXPECT_LT(distances.back(), 0.5 / 16);
  const auto of_either = [&](const Resolution& r) {
    return distances_of(computed.all.at(r).fe, prepared.fem.units, limits.shakedown).back();
  };
  EXPECT_TRUE(distances.back() == of_either(first) || distances.back() == of_either(second));
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_NEAR(shares.back(), 1, 0.02);
  EXPECT_EQ(computed.all.size(), 2u);
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
