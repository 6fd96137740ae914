#include "comparison/results/unit_text.h"

#include <gtest/gtest.h>

namespace fretval {
namespace {

TEST(UnitText, ShowsAsManyDigitsAsTheBarAllows) {
  EXPECT_EQ(with_unit(6.92107e-4, 4.3e-8, "m"), "692.11 ± 0.04 µm");
  EXPECT_EQ(with_unit(0.83377217, 6e-5, "N"), "833.77 ± 0.06 mN");
  EXPECT_EQ(with_unit(12.6, 3, "N"), "13 ± 3 N");
  EXPECT_EQ(with_unit(1.1165058563648615e-3, 0, "m"), "1.11651 mm");
  EXPECT_EQ(with_unit(2.5e4, 0, "N"), "25.0000 kN");
  EXPECT_EQ(with_unit(0, 0, "N"), "0 nN");
  EXPECT_EQ(with_unit(0, 2e-10, "m"), "0.0 ± 0.2 nm");
  EXPECT_EQ(with_unit(5.43573e-4, 9.7e-9, "m"), "543.57 ± 0.01 µm");
  EXPECT_EQ(with_unit(5.43573e-4, 9.4e-9, "m"), "543.573 ± 0.009 µm");
  EXPECT_EQ(with_unit(-9.06e-5, 4.17e-4, "N"), "-0.1 ± 0.4 mN");
  EXPECT_EQ(with_unit(-9.06e-5, 1.17e-3, "N"), "0 ± 1 mN");
  EXPECT_EQ(with_unit(-3e-10, 7.84e-7, "N"), "0.0 ± 0.8 µN");
  EXPECT_EQ(with_unit(0.11109, 1e-17, "N"), "111.090 mN");
  EXPECT_EQ(with_unit(3.05e-16, 0, "J"), "305.000 aJ");
  EXPECT_EQ(with_unit(2.5e-13, 3e-15, "N"), "250 ± 3 fN");
}

TEST(UnitText, OfAVolumeIsInCubicMillimetres) {
  EXPECT_EQ(volume_text(1e-9), "1 mm³");
  EXPECT_EQ(volume_text(1.25e-11), "0.0125 mm³");
}

TEST(UnitText, OfATestIsInTheUnitThatPeopleCountIn) {
  EXPECT_EQ(time_text(90), "90 s");
  EXPECT_EQ(time_text(3000), "50 min");
  EXPECT_EQ(time_text(2e5), "2.31 days");
  EXPECT_EQ(time_text(3e4), "8.33 h");
  EXPECT_EQ(time_text(1e8), "3.17 years");
  EXPECT_EQ(time_text(1e12), "3.2e+04 years");
}

}  // namespace
}  // namespace fretval
