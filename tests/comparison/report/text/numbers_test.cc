#include "comparison/report/text/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

TEST(NumberText, IsADashForWhatIsNoFiniteNumber) {
  EXPECT_EQ(number_text(1.25e-3), "1.3e-03");
  EXPECT_EQ(number_text(2, "{:g}"), "2");
  for (const nlohmann::ordered_json& none : {nlohmann::ordered_json(nullptr), nlohmann::ordered_json(std::nan(""))})
    EXPECT_EQ(number_text(none), "–");
}

TEST(Counted, HasTheTruePlural) {
  EXPECT_EQ(counted(1, "case"), "1 case");
  EXPECT_EQ(counted(0, "case"), "0 cases");
}

TEST(Differences, AreDashesWhereNothingIsCompared) {
  StoredResult result{stored_result(), {}};
  result.json["comparison"]["normal_force_max"] = {{"difference", 3e-5}, {"error_bar", 4e-5}};
  result.json["comparison"]["contact_radius_max"] = {{"difference", nullptr}};
  EXPECT_EQ(difference_with_bar(result, "normal_force_max"), "+3.0e-05 ± 4e-05");
  EXPECT_EQ(difference_with_bar(result, "contact_radius_max"), "– ± –");
  EXPECT_EQ(difference_with_bar(result, "indentation_max"), "–");
}

TEST(LengthText, IsTheLengthOfTheSideThatIsAskedFor) {
  StoredResult result{stored_result(), {}};
  result.json["mdr"]["stick_radius_shakedown"] = 7.5e-4;
  result.json["fe"]["stick_radius_shakedown"] = nullptr;
  EXPECT_EQ(length_text(result, "mdr", "stick_radius_shakedown"), "750.000 µm");
  EXPECT_EQ(length_text(result, "fe", "stick_radius_shakedown"), "–");
}

TEST(InputNumber, IsAnEntryThatHasANumber) {
  StoredResult result{stored_result(), {}};
  result.json["scene"]["inputs"] = {{{"name", "Phase"}, {"value", "free"}}, {{"name", "Radius"}, {"value", 0.01}}};
  EXPECT_EQ(input_number(result, "Radius"), 0.01);
  EXPECT_TRUE(std::isnan(input_number(result, "Phase")));
  EXPECT_TRUE(std::isnan(input_number(result, "Exponent")));
}

}  // namespace
}  // namespace fretval
