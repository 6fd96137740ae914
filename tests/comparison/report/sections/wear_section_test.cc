#include <gtest/gtest.h>

#include <map>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

StoredResult wearing(bool ends_in_limit) {
  auto json = stored_result();
  json["scene"]["wear_law"] = {
      {"law", "power"}, {"coefficient", 1e-12}, {"exponent", 0.5}, {"cycles", nullptr}, {"until", 0}};
  json["scene"]["indentation_max"] = 1e-4;
  json["fe"]["wear"] = {{"cycles", {0, 1e6}},
                        {"volume", {0, 1.5e-11}},
                        {"r", {2.5e-4, 7.5e-4}},
                        {"end", "nothing left"},
                        {"ends_in_limit", ends_in_limit},
                        {"volume_of_limit", 3e-11},
                        {"distance_to_limit", {{"shakedown", 2.5e-4}, {"first_slip", 0.125}}},
                        {"distance_to_shakedown_limit", {0.2, 2.5e-4}},
                        {"distance_to_first_slip_limit", {0.3, 0.125}},
                        {"zones", {{"start", {"sf"}}, {"end", {"so"}}}},
                        {"cost", {{"seconds", 1.25}}}};
  json["comparison"]["worn_volume"] = {{"difference", 1e-5}, {"error_bar", 2e-4}, {"tolerance", 2e-3}, {"pass", true}};
  return {json, "nowhere"};
}

TEST(WearSection, IsEmptyWithoutWear) {
  EXPECT_TRUE(wear_section({{stored_result(), "nowhere"}}).is_null());
}

TEST(WearSection, SaysWhereItEnds) {
  const auto section = wear_section({wearing(true), wearing(false)});
  expect_parts(section.dump(), {"Worn volume", "0.015 mm³, 0.50000", "start of the wear", "end of the wear"});
  expect_parts(rendered(section),
               {"1 of 2 indenters have worn to it", "2.5e-04 from the limiting profile", "at least 0.12 away",
                "standard solid, p^0.5</td>", "0.015 mm³, 0.50000</td>", "+1.0e-05 ± 2e-04",
                "nothing wears any more</td>", "all that is pressed sticks</td>"});
}

// Half of the limit's volume of 3e-11 m³ by finite elements, 0.4 of it by MDR.
TEST(WearSection, HasBothVolumesOverThatOfTheLimit) {
  auto result = wearing(false);
  result.json["mdr"]["wear"] = {{"cycles", {0, 1e6}}, {"volume", {0, 1.2e-11}}};
  const auto figures = wear_section({result}).at("courses").at(0).at("figures").at("figures");
  std::map<std::string, double> last;
  for (const auto& figure : figures)
    if (figure.at("plot").value("title", "") == "Worn volume")
      for (const auto& series : figure.at("plot").at("series"))
        last[series.at("label").get<std::string>()] = series.at("y").back().get<double>();
  EXPECT_NEAR(last["finite elements"], 0.5, 1e-12);
  EXPECT_NEAR(last["MDR"], 0.4, 1e-12);
}

TEST(WearSection, SaysWhyItEnds) {
  auto fallen = wearing(false), stuck = wearing(true), unproved = stuck, progressive = wearing(false);
  fallen.json["fe"]["wear"]["end"] = "rate fallen";
  stuck.json["fe"]["wear"]["slip_is_proved"] = false;
  stuck.json["fe"]["wear"]["sticks_throughout"] = true;
  unproved.json["fe"]["wear"]["slip_is_proved"] = false;
  stuck.json["fe"]["wear"]["springs_difference"] = 0.0125;
  progressive.json["fe"]["wear"]["end"] = "progressive";
  progressive.json["fe"]["wear"]["limit_is_reached"] = false;
  const auto section = wear_section({fallen, stuck, unproved, progressive});
  expect_parts(rendered(section),
               {"0 of 4 indenters have worn to it", "the rate has fallen</td>", "all that touches sticks</td>",
                "no slip is proved</td>", "it goes on for ever</td>", "In 1 nothing wears", "In 1 no slip is proved",
                "1 under a normal force wear for ever"});
  EXPECT_EQ(rendered(section).find("with a tangential displacement"), std::string::npos);
}

TEST(WearSection, SaysWhereMdrHasNoLimit) {
  auto elsewhere = wearing(true);
  elsewhere.json["fe"]["wear"]["limit_is_reached"] = false;
  const auto text = rendered(wear_section({elsewhere}));
  expect_parts(text, {"0 of 1 indenter has worn to it", "1 under a normal force with a tangential displacement"});
  EXPECT_EQ(text.find("from the limiting profile of the shakedown"), std::string::npos);
}

// The nearest of all cases, whichever comes last.
TEST(WearSection, SaysHowNearTheLimitOfTheFirstSlipRadiusAnyCaseComes) {
  auto far = wearing(true);
  far.json["fe"]["wear"]["distance_to_limit"]["first_slip"] = 0.5;
  expect_parts(rendered(wear_section({wearing(true), far})), {"at least 0.12 away"});
  expect_parts(rendered(wear_section({far, wearing(true)})), {"at least 0.12 away"});
}

// 1e6 cycles at 2 Hz are 5e5 s, of 86400 s a day.
TEST(WearSection, SaysHowLongTheCyclesTake) {
  auto result = wearing(true);
  result.json["scene"]["frequency"] = result.json["scene"]["tangential_frequency"] = 2;
  expect_parts(rendered(wear_section({result})), {"1e+06, 5.79 days"});
}

}  // namespace
}  // namespace fretval
