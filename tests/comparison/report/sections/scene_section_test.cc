#include <gtest/gtest.h>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

nlohmann::ordered_json input(const char* section, const char* name, const nlohmann::ordered_json& value,
                             const char* unit) {
  return {{"section", section}, {"name", name}, {"value", value}, {"unit", unit}};
}

StoredResult with_inputs(const std::vector<nlohmann::ordered_json>& inputs) {
  StoredResult result{stored_result(), {}};
  result.json["scene"]["inputs"] = inputs;
  return result;
}

TEST(Scene, HasInputsInUnitsThatPeopleUse) {
  const auto html = rendered(scene_of(
      with_inputs({input("Motion", "Phase", 0, "°"), input("Motion", "Normal amplitude", 0, "m"),
                   input("Motion", "Indentation", 2e-5, "m"), input("Motion", "Normal harmonics", {"a", "b"}, ""),
                   input("Elastomer", "Temperature", 40, "degC"), input("Elastomer", "Branch moduli", {1e6, 5e5}, "Pa"),
                   input("Wear", "Coefficient", 1e-13, "1/Pa")})));
  expect_parts(html, {"<dd>0°</dd>", "<dd>0\u00a0m</dd>", "<dd>20\u00a0µm</dd>", "<dd>a, b</dd>", "<dd>40\u00a0°C</dd>",
                      "<dd>1\u00a0MPa, 500\u00a0kPa</dd>", "<dd>1e-13\u00a01/Pa</dd>"});
}

// E*/G* is 1.5 at nu = 1/2 and (2 - 0.25)/(2 - 0.5) at a quarter; a mesh tells its own thickness.
TEST(Scene, HasTheGroupsOfItsBody) {
  auto result = with_inputs({input("Body", "Thickness", 2e-3, "m")});
  auto& scene = result.json["scene"];
  scene["friction_coefficient"] = 0.5;
  scene["normal_amplitude"] = 3e-5;
  scene["tangential_amplitude"] = 1e-5;
  scene["contact_radius_unworn"] = 1e-3;
  expect_parts(rendered(scene_of(result)), {"<dd>2.25</dd>", "<dd>0.5</dd>"});
  scene["inputs"] = nlohmann::ordered_json::array({input("Elastomer", "Poisson ratio", 0.25, "")});
  scene["mesh"] = {{"thickness", 4e-3}};
  expect_parts(rendered(scene_of(result)), {"<dd>1.75</dd>", "<dd>0.25</dd>"});
}

TEST(Scene, HoldsTheContactAgainstIndenterAndCylinder) {
  auto result = with_inputs({input("Indenter", "Radius", 1e-2, "m"), input("Body", "Radius", 8e-3, "m"),
                             input("Body", "Thickness", 2e-3, "m")});
  result.json["scene"]["contact_radius_unworn"] = 1e-3;
  const auto scene = scene_of(result);
  EXPECT_EQ(scene.at("a_over_r"), "0.1");
  EXPECT_EQ(scene.at("a_over_h"), "0.5");
  EXPECT_EQ(scene.at("a_over_b"), "0.125");
}

// Of times that were fitted or shifted, too.
TEST(Scene, TakesTheBranchTimesByWhateverName) {
  auto result = with_inputs({input("Elastomer", "Branch times, fitted", {0.5}, "s")});
  result.json["scene"]["frequency"] = 1;
  expect_parts(rendered(scene_of(result)), {"<dd>3.14</dd>"});
}

TEST(ScenesSection, ShowsTheFirstOfEachSweep) {
  auto first = with_inputs({input("Friction", "Coefficient", 0.25, "")}), second = first, single = first;
  first.json["scene"]["sweep"] = {{"family", "mine"}, {"entry", "Friction / Coefficient"}, {"value", 0.25}};
  second.json["scene"]["sweep"] = {{"family", "mine"}, {"entry", "Friction / Coefficient"}, {"value", 0.5}};
  second.json["scene"]["inputs"] = nlohmann::ordered_json::array({input("Friction", "Coefficient", 0.5, "")});
  single.json["scene"].erase("sweep");
  const auto html = rendered(scenes_section({first, second, single}));
  expect_parts(html, {"mine: the first of 2 cases over Friction / Coefficient", "<dd>0.25</dd>", "What is assumed"});
  EXPECT_EQ(html.find("<dd>0.5</dd>"), std::string::npos);
  EXPECT_TRUE(scenes_section({single}).is_null());
}

}  // namespace
}  // namespace fretval
