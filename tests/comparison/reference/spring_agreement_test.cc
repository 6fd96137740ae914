#include "comparison/reference/spring_agreement.h"

#include <gtest/gtest.h>

#include "comparison/reference/mdr_document.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

/// Eight times stiffer in motion than at rest, in phase, k = 1.02.
std::string settling_case() {
  auto text = replace(valid_case, "Branch moduli = 1e6\n  set Branch times = 0.1",
                      "Branch moduli = 7e6\n  set Branch times = 0.5");
  text = replace(text, "Normal amplitude = 2e-5", "Normal amplitude = 1.2e-5");
  return replace(replace(text, "1.5e-5", "8.823529e-6"), "Phase = 60", "Phase = 0");
}

// Springs alone print the radius of the innermost of 400, which looks like a result.
TEST(SpringAgreement, WarnsWhereSlipDiesOutSlowlyAndSaysWhichToTrust) {
  const auto json = mdr_document(read_case(settling_case()), true).json;
  const auto& springs = json.at("springs");
  const double a = json.at("mdr").at("contact_radius_max"), c = json.at("mdr").at("stick_radius_shakedown");
  EXPECT_LT(springs.at("stick_radius_shakedown").get<double>(), 0.01 * a);
  EXPECT_NEAR(springs.at("difference_shakedown"), (springs.at("stick_radius_shakedown").get<double>() - c) / a, 1e-3);
  EXPECT_GT(springs.at("slip_inside"), 1e-6);
  EXPECT_LT(springs.at("slip_inside"), 1e-4);
  ASSERT_EQ(springs.at("warnings").size(), 1U);
  expect_parts(springs.at("warnings")[0].get<std::string>(),
               {"shakedown radius 0.001", "0.2744", "dies out slowly", "Trust the closed formula"});
}

TEST(SpringAgreement, IsWithinASpringWhereTheyAgree) {
  const auto springs = mdr_document(read_case(), true).json.at("springs");
  EXPECT_TRUE(springs.at("warnings").empty());
  EXPECT_LT(std::abs(springs.at("difference_first_slip").get<double>()), 1e-3);
  EXPECT_LT(std::abs(springs.at("difference_shakedown").get<double>()), 1e-3);
}

// Four springs of width 1 under a parabola g = x^2/4: all depths are made up.
TEST(SpringAgreement, HasAReasonForEachDifference) {
  mdr::SpringBed bed{Eigen::Array4d(0.5, 1.5, 2.5, 3.5), Eigen::Array4d::Ones(), Eigen::Array4d(0, 0.5, 1.5, 3)};
  mdr::SpringHistory history{};
  history.n_periods = 7;
  history.largest_shift = 2;
  history.slip_amplitude = Eigen::Array4d(0.5, 1, 3, 4);
  history.depths = {4.0 / 4, 0};
  history.settling_depth = 9.0 / 4;
  const auto profile = mdr::parabola(4);
  const auto settling = spring_agreement(bed, history, profile, {2, 3});
  EXPECT_EQ(settling.first_slip, 0);
  EXPECT_EQ(settling.shakedown, -0.75);
  EXPECT_EQ(settling.slip_inside, 0.5);  // the third spring reaches up to the edge
  ASSERT_EQ(settling.warnings.size(), 1U);
  expect_parts(settling.warnings[0],
               {"none by the springs, 0.75 a by", "after 7 periods", "up to 5.0e-01", "to 0.75 a"});

  history.settling_depth = 0;
  const auto other = spring_agreement(bed, history, profile, {std::nullopt, 3});
  ASSERT_EQ(other.warnings.size(), 2U);
  expect_parts(other.warnings[0], {"no settling", "Trust neither"});
  expect_parts(other.warnings[1], {"first-slip radius 0.5 a by the springs, none by", "the start"});

  EXPECT_FALSE(spring_agreement(bed, history, profile, {2, 3, false}).first_slip);
}

}  // namespace
}  // namespace fretval
