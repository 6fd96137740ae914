#include "mdr/springs/spring_bed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/mdr/error_of.h"

namespace fretval::mdr::spring_bed_test {
namespace {

TEST(SpringBed, IntervalsFollowEachOtherFromTheAxis) {
  const SpringBed bed = spring_bed([](double x) { return 3 * x; }, 2, 4);
  for (Eigen::Index j = 0; j < 4; ++j) {
    EXPECT_DOUBLE_EQ(bed.width[j], 0.5);
    EXPECT_DOUBLE_EQ(bed.position[j], 0.25 + 0.5 * static_cast<double>(j));
    EXPECT_DOUBLE_EQ(bed.depth[j], 3 * bed.position[j]);
  }
  EXPECT_DOUBLE_EQ(spring_bed(parabola(1), 2, 1).position[0], 1);
}

// g = x^2 over [x - w/2, x + w/2] has the mean x^2 + w^2/12, not the value in the middle.
TEST(SpringBed, DepthIsTheMeanOverTheInterval) {
  const SpringBed bed = spring_bed(parabola(1), 1, 5);
  for (Eigen::Index j = 0; j < 5; ++j)
    EXPECT_NEAR(bed.depth[j], bed.position[j] * bed.position[j] + 0.2 * 0.2 / 12, 1e-15);
}

TEST(SpringBed, MeanDepthMakesTheFullContactExact) {
  const SpringBed bed = spring_bed(parabola(2), 0.5, 7);
  EXPECT_NEAR((bed.width * bed.depth).sum(), transform_integral(parabola(2), 0.5), 1e-15);
  EXPECT_NEAR(bed.position[6] + bed.width[6] / 2, 0.5, 1e-15);
}

TEST(SpringBed, NamesBadArgumentsAndAProfileThatEnds) {
  const Profile table = tabulated({0, 1, 2, 3}, {0, 1, 4, 9});
  EXPECT_NO_THROW(spring_bed(table, 3, 7));
  EXPECT_NE(error_of([&] { spring_bed(table, 3.1, 7); }).find("must lie between 0 and 3"), std::string::npos);
  const auto g = [](double) { return 0.0; };
  for (const double radius : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_NE(error_of([&] { spring_bed(g, radius, 5); }).find("outer radius of the springs"), std::string::npos);
  for (const Eigen::Index n : {0, -1})
    EXPECT_NE(error_of([&] { spring_bed(parabola(1), 1, n); }).find("number of springs"), std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::spring_bed_test
