#include <gtest/gtest.h>

#include <vector>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

// a / R = 0.2: a²/(4R²) = 1 %; a layer of 1.133 a / 0.01 = 113 a = 227 mm adds 1 % to the force.
TEST(Assumptions, HaveTheNumbersOfTheCase) {
  const ScratchFolder folder;
  folder.write("run.json", R"({"resolution": {"far_radius": 12}})");
  folder.write("profile.csv", "r [m],f unworn [m]\n0,0\n0.001,0\n0.003,0.002\n");
  auto json = stored_result();
  json["scene"]["inputs"] = {{{"section", "Indenter"}, {"name", "Radius"}, {"value", 0.01}, {"unit", "m"}}};
  json["scene"]["contact_radius_unworn"] = 0.002;
  json["scene"]["indentation"] = 4;
  json["scene"]["normal_amplitude"] = 1;
  json["fe"]["error_estimate"] = {
      {"stick_radius_shakedown", {{"total", 1}, {"shares", {{"far field", {{"estimate", 2e-5}, {"order", nullptr}}}}}}},
      {"normal_force_max", {{"total", 1}, {"shares", {{"far field", {{"estimate", 1e-5}, {"order", nullptr}}}}}}}};
  json["comparison"]["stick_radius_shakedown"]["tolerance"] = 1e-3;
  json["comparison"]["normal_force_max"]["tolerance"] = 1e-4;
  expect_parts(rendered(assumptions_of({json, folder.path()})),
               {"it is 1 % lower", "the normal amplitude is 0.25 of", "rises at 45°", "has to be 227 mm deep, 113 a",
                "The finite elements end at 12 a on", "makes up 10 % of a tolerance at most (largest normal force)"});
}

TEST(Assumptions, AreThoseOfTheContactOnRingsAndAngles) {
  auto json = stored_result();
  expect_parts(rendered(assumptions_of({json, {}})), {"its traction in the direction of the motion"});
  json["scene"]["inputs"] = {{{"section", "Contact"}, {"name", "Friction"}, {"value", "vector"}, {"unit", ""}}};
  const auto html = rendered(assumptions_of({json, {}}));
  EXPECT_EQ(html.find("its traction in the direction of the motion"), std::string::npos);
  expect_parts(html, {"has any direction along the surface"});
}

TEST(Assumptions, NameWhatTheBodyWouldCouple) {
  const auto of = [](const std::vector<nlohmann::ordered_json>& inputs, bool mesh = false) {
    auto json = stored_result();
    json["scene"]["inputs"] = inputs;
    json["scene"]["contact_radius_unworn"] = 0.002;
    if (mesh) json["scene"]["mesh"] = nlohmann::ordered_json::object();
    return assumptions_of({json, {}});
  };
  const nlohmann::ordered_json compressible{{"section", "Elastomer"}, {"name", "Poisson ratio"}, {"value", 0.4}},
      layer{{"section", "Body"}, {"name", "Thickness"}, {"value", 0.01}},
      on{{"section", "Contact"}, {"name", "Coupling"}, {"value", "on"}};
  EXPECT_FALSE(of({}).contains("uncoupled"));
  EXPECT_TRUE(of({compressible}).contains("uncoupled"));
  EXPECT_TRUE(of({layer}).contains("uncoupled"));
  EXPECT_TRUE(of({}, true).contains("uncoupled"));
  EXPECT_FALSE(of({compressible, on}).contains("uncoupled"));
  EXPECT_TRUE(of({compressible}).contains("depth"));
  EXPECT_FALSE(of({layer}).contains("depth"));
  EXPECT_FALSE(of({}, true).contains("depth"));
}

// A cone has no arc, and along a path the amplitude over the indentation is none of lifting off.
TEST(Assumptions, AreOfTheShapeAndTheMotion) {
  auto json = stored_result();
  json["scene"]["inputs"] = {{{"section", "Indenter"}, {"name", "Radius"}, {"value", 0.01}}};
  json["scene"]["shape"] = "parabola";
  EXPECT_TRUE(assumptions_of({json, {}}).contains("arc"));
  EXPECT_TRUE(assumptions_of({json, {}}).contains("lift_off"));
  json["scene"]["shape"] = "sphere";
  json["scene"]["path"] = {{"repeats", "forever"}};
  EXPECT_FALSE(assumptions_of({json, {}}).contains("arc"));
  EXPECT_FALSE(assumptions_of({json, {}}).contains("lift_off"));
}

TEST(Assumptions, SayNothingOfWhatIsNotKnown) {
  auto json = stored_result();
  json["fe"]["error_estimate"] = nlohmann::ordered_json::object();
  const auto html = rendered(assumptions_of({json, {}}));
  for (const char* absent : {"The finite elements end", "Small slopes"})
    EXPECT_EQ(html.find(absent), std::string::npos) << absent;
}

}  // namespace
}  // namespace fretval
