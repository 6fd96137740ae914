#include "comparison/report/drawing/axis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

TEST(Axis, HasThePrefixOfTheLargestValue) {
  const std::vector<double> small{1e-6, -2e-3, std::nan("")}, nothing{0};
  const auto axis = axis_for({&small, &nothing}, "m");
  EXPECT_EQ(axis.unit, "mm");
  EXPECT_NEAR(axis.of(small)[1], -2, 1e-15);
  EXPECT_EQ(axis_for({&nothing}, "N").unit, "N");
}

TEST(Axis, MarksTheRadiiThatThereAre) {
  StoredResult result{stored_result(), {}};
  result.json["scene"]["contact_radius_unworn"] = 2;
  result.json["fe"]["stick_radius_shakedown"] = 0.5;
  const auto marks = radius_marks(result, {"mm", 1e-3});
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0], (std::pair<std::string, double>("c", 500)));
  EXPECT_EQ(marks[1], (std::pair<std::string, double>("a", 2000)));
  result.json["fe"]["stick_radius_shakedown"] = nullptr;
  EXPECT_EQ(radius_marks(result, {"m", 1}).size(), 1U);
}

}  // namespace
}  // namespace fretval
