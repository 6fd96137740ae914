#include "fem/wear/rubbing_rings.h"

#include <gtest/gtest.h>

#include "tests/fem/wear/wearing_half_space.h"

namespace fretval::fem {
namespace {

TEST(RubbingRings, AreMovedAndWornApartFromTheirClones) {
  const WearingHalfSpace half_space(8);
  const WornProfile shape{half_space.profile, Eigen::VectorXd::Zero(half_space.profile.size())};
  RubbingRings rings(half_space.normal, half_space.tangential, half_space.body, half_space.motion, 24, shape,
                     half_space.mu);
  rings.step({});
  const auto clone = rings.clone();
  const Eigen::VectorXd worn = 1e-3 * half_space.profile;
  clone->take_worn(worn);
  clone->step({});
  EXPECT_EQ(rings.n_steps(), 1);
  EXPECT_EQ(clone->n_steps(), 2);
  EXPECT_TRUE(rings.worn().isZero(0));
  EXPECT_LT((clone->worn() - worn).norm(), 1e-15);
}

// A ring that lifts off in a step, and stuck before, has no pressure left by the time it slips.
TEST(RubbingRings, DoNotRubWhereTheyLiftFromSticking) {
  const WearingHalfSpace half_space(8);
  RubbingRings rings(half_space.normal, half_space.tangential, half_space.body, half_space.motion, 24,
                     {half_space.profile, Eigen::VectorXd::Zero(half_space.profile.size())}, half_space.mu);
  Eigen::VectorXd slip_before = Eigen::VectorXd::Zero(half_space.profile.size()), before = rings.pressure();
  int n_lifted = 0;
  for (int k = 0; k < 72; ++k) {
    const Eigen::VectorXd slip = rings.step({}), pressure = rings.pressure();
    for (Eigen::Index i = 0; i < slip.size(); ++i) {
      if (before[i] == 0 || pressure[i] > 0 || slip_before[i] != 0) continue;
      EXPECT_EQ(slip[i], 0) << k << ", " << i;
      ++n_lifted;
    }
    slip_before = slip;
    before = pressure;
  }
  EXPECT_GT(n_lifted, 0);
}

}  // namespace
}  // namespace fretval::fem
