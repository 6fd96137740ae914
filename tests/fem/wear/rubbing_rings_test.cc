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

}  // namespace
}  // namespace fretval::fem
