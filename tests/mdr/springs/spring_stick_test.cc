#include "mdr/springs/spring_stick.h"

#include <gtest/gtest.h>

namespace fretval::mdr::spring_stick_test {
namespace {

const SpringBed bed{Eigen::ArrayXd::LinSpaced(3, 1, 3), Eigen::ArrayXd::Ones(3),
                    Eigen::ArrayXd::LinSpaced(3, 0.1, 0.3)};

// g + margin/(3 mu/2) of the outermost spring that sticks.
TEST(StickDepth, IsThatOfTheOutermostSpringThatSticks) {
  const Eigen::ArrayXd margin = Eigen::Array3d(0.3, 0.15, -0.1), slip = Eigen::Array3d(0, 0, 1),
                       early = Eigen::Array3d(0, 0.2, 1);
  EXPECT_NEAR(stick_depth(bed, 0.5, margin, {slip, 0, 1}), 0.2 + 0.15 / 0.75, 1e-15);
  EXPECT_NEAR(stick_depth(bed, 0.5, margin, {early, 0.1, 1}), 0.1 + 0.3 / 0.75, 1e-15);
}

// A spring at its limit has no margin, and slips by what it lacks.
TEST(StickDepth, IsWhatTheInnermostSpringLacksWhereNoneSticks) {
  const Eigen::ArrayXd margin = Eigen::ArrayXd::Zero(3), slip = Eigen::Array3d(0.6, 1, 1);
  EXPECT_NEAR(stick_depth(bed, 0.5, margin, {slip, 0, 1}), 0.1 - 0.6 / 0.75, 1e-15);
  EXPECT_NEAR(stick_depth(bed, 0.5, margin, {slip, 0, to_and_fro}), 0.1 - 0.15 / 0.75, 1e-15);
}

}  // namespace
}  // namespace fretval::mdr::spring_stick_test
