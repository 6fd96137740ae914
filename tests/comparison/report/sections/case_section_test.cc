#include <gtest/gtest.h>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

// a / R = 0.2, a parabola is a²/(4R²) = 1 % lower than the arc; k = 1.5 · 0.5 · 2 / 3.
TEST(CaseSection, HasTheSceneWithItsGroups) {
  auto json = stored_result("single");
  json["scene"].erase("sweep");
  json["scene"]["inputs"] = {{{"section", "Indenter"}, {"name", "Radius"}, {"value", 0.01}, {"unit", "m"}},
                             {{"section", "Elastomer"}, {"name", "Branch times"}, {"value", {0.1}}, {"unit", "s"}}};
  json["scene"]["contact_radius_unworn"] = 0.002;
  json["scene"]["friction_coefficient"] = 0.5;
  json["scene"]["normal_amplitude"] = 2;
  json["scene"]["tangential_amplitude"] = 3;
  json["scene"]["frequency"] = 1;
  json["fe"]["stick_radius_shakedown"] = 0.001;
  const auto html = rendered(cases_section({StoredResult{json, {}}}));
  expect_parts(html, {"<dd>10\u00a0mm</dd>", "<dd>100\u00a0ms</dd>", "<dd>0.2</dd>", "<dd>0.5</dd>", "<dd>0.628</dd>",
                      "<dd>0.5000</dd>", "it is 1 % lower"});
}

// The near cycle that stands for a motion without one is as long as its accuracy asks for, and what it loses says
// nothing of the motion.
TEST(CaseSection, HasTheFrictionOfAPeriodAlone) {
  auto json = stored_result("single");
  json["fe"]["friction_work"] = 1e-6;
  json["comparison"].erase("friction_work");
  const auto html = [&] { return rendered(cases_section({StoredResult{json, {}}})); };
  expect_parts(html(), {"energy lost to friction per period", "1 µJ"});
  json["scene"]["has_period"] = false;
  EXPECT_EQ(html().find("energy lost"), std::string::npos);
  json["scene"]["path"] = {{"repeats", "once"}};
  expect_parts(html(), {"<td>energy lost to friction</td>"});
}

TEST(CaseSection, IsOfSingleCasesAlone) {
  EXPECT_TRUE(cases_section({StoredResult{stored_result(), {}}}).is_null());
}

}  // namespace
}  // namespace fretval
