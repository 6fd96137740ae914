#include "mdr/springs/spring_stick.h"

#include <gtest/gtest.h>

namespace fretval::mdr::spring_stick_test {
namespace {

const SpringBed bed{Eigen::ArrayXd::LinSpaced(3, 1, 3), Eigen::ArrayXd::Ones(3),
                    Eigen::ArrayXd::LinSpaced(3, 0.1, 0.3)};

// g + margin/(3 mu/2) of the outermost spring that sticks.
TEST(StickDepth, IsThatOfTheOutermostSpringThatSticks) {
  const Eigen::Array3d margin(0.3, 0.15, -0.1), slip(0, 0, 1);
  EXPECT_NEAR(stick_depth(bed, 0.5, margin, slip, 0), 0.2 + 0.15 / 0.75, 1e-15);
  EXPECT_NEAR(stick_depth(bed, 0.5, margin, Eigen::Array3d(0, 0.2, 1), 0.1), 0.1 + 0.3 / 0.75, 1e-15);
}

TEST(StickDepth, IsNotMoreThanTheInnermostDepthWhereNothingSticks) {
  EXPECT_NEAR(stick_depth(bed, 0.5, Eigen::Array3d(-0.15, -1, -1), Eigen::Array3d::Ones(), 0), 0.1 - 0.2, 1e-15);
  EXPECT_EQ(stick_depth(bed, 0.5, Eigen::Array3d::Ones(), Eigen::Array3d::Ones(), 0), 0.1);
}

}  // namespace
}  // namespace fretval::mdr::spring_stick_test
