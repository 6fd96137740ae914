#include <gtest/gtest.h>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

StoredResult point(double value, const std::filesystem::path& folder) {
  auto json = stored_result();
  json["name"] = "family/" + std::to_string(static_cast<int>(value));
  json["scene"]["sweep"] = {{"family", "family"}, {"entry", "Friction / Coefficient"}, {"value", value}};
  json["scene"]["contact_radius_unworn"] = 2;
  json["mdr"]["stick_radius_shakedown"] = 0.25 * value;
  json["fe"]["stick_radius_shakedown"] = 0.5 * value;
  json["comparison"]["stick_radius_shakedown"]["error_bar"] = 0.125;
  return {json, folder};
}

TEST(SweepSection, DrawsAnyEntryWithTheBarsInUnits) {
  const auto filling = sweeps_section({point(1, {}), point(2, {})});
  ASSERT_FALSE(filling.is_null());
  const auto& sweep = filling.at("sweeps")[0];
  EXPECT_EQ(sweep.at("entry"), "Friction / Coefficient");
  const auto html = filling.dump();
  expect_parts(html, {"Stick radii", "Friction / Coefficient, μ", "dashed", "\"y\":[0.25,0.5]", "\"y\":[0.5,1.0]",
                      "\"bar\":[0.25,0.25]"});
  EXPECT_TRUE(sweeps_section({point(1, {})}).is_null()) << "a point is no curve";
}

// Over mu and u_x0: all sticks, in part, and nothing. Between 0.75 a and 0.25 a the square of MDR's radius is that of
// 0.5 a at 1 + 2 (9 - 4)/(9 - 1); between a and nothing at 1 + 2 (1 - 1/4).
TEST(SweepSection, DrawsTwoEntriesAsAMapOfRegimes) {
  const auto at = [](double friction, double amplitude, double ratio) {
    auto result = point(friction, {});
    auto& json = result.json;
    json["scene"]["sweep"]["second_entry"] = "Motion / Tangential amplitude";
    json["scene"]["sweep"]["second_value"] = amplitude;
    for (const char* side : {"fe", "mdr"}) {
      json[side]["contact_radius_max"] = 2;
      json[side]["stick_radius_shakedown"] = ratio > 0 ? nlohmann::ordered_json(2 * ratio) : nullptr;
    }
    return result;
  };
  const auto filling = sweeps_section({at(1, 1e-6, 0.75), at(1, 3e-6, 0.25), at(2, 1e-6, 1), at(2, 3e-6, 0)});
  ASSERT_FALSE(filling.is_null());
  EXPECT_EQ(filling.at("sweeps")[0].at("entry"), "Friction / Coefficient and Motion / Tangential amplitude");
  expect_parts(filling.dump(), {"Fretting map", "Motion / Tangential amplitude, u_{x0} in µm", "all sticks",
                                "partial slip", "gross slip", "c = 0.5 a, MDR", "\"x\":[1.0,2.0],\"y\":[2.25,2.5]"});
}

// A line through points of its own, where a run has left one.
TEST(SweepSection, DrawsMdrBetweenThePoints) {
  const ScratchFolder folder;
  folder.write("mdr.csv",
               "Friction / Coefficient [1],stick radius (shakedown) [m]\n1,0.25\n1.25,0.375\n1.5,nan\n2,0.5\n");
  const auto html =
      sweeps_section({point(1, folder.path() / "1"), point(2, folder.path() / "2")}).at("sweeps")[0].dump();
  expect_parts(html, {"\"x\":[1.0,1.25,1.5,2.0],\"y\":[0.25,0.375,null,0.5]", "\"x\":[1.0,2.0],\"y\":[0.5,1.0]"});
}

TEST(SweepSection, SaysTheEntryInAUnitThatPeopleUse) {
  const auto at = [](double radius) {
    auto result = point(1, {});
    result.json["scene"]["sweep"] = {{"family", "family"}, {"entry", "Indenter / Radius"}, {"value", radius}};
    return result;
  };
  const auto html = sweeps_section({at(2e-3), at(4e-3)}).dump();
  expect_parts(html, {"Indenter / Radius, R in mm", "\"x\":[2.0,4.0]"});
}

TEST(SweepSection, LeavesThePhaseToTheFiguresOfThePaper) {
  EXPECT_TRUE(sweeps_section({StoredResult{stored_result(), {}}, StoredResult{stored_result(), {}}}).is_null());
}

// Whose figures show radii alone.
TEST(SweepSection, DrawsTheForcesOfTheOnlyPhaseSweep) {
  const auto at = [](double phase, double force, const std::string& family) {
    auto json = stored_result();
    json["scene"]["sweep"] = {{"family", family}, {"entry", "Motion / Phase"}, {"value", phase}};
    json["mdr"]["tangential_force_max"] = force;
    return StoredResult{json, {}};
  };
  const auto html = sweeps_section({at(0, 1, "one"), at(90, 2, "one")}).dump();
  expect_parts(html, {"Largest tangential force", "\"y\":[1.0,2.0]"});
  EXPECT_EQ(html.find("Stick radii"), std::string::npos);
  EXPECT_TRUE(sweeps_section({at(0, 1, "one"), at(90, 2, "one"), at(0, 1, "two"), at(90, 2, "two")}).is_null());
}

TEST(SweepSection, WritesItsNumbers) {
  const ScratchFolder folder;
  write_sweeps({point(1, folder.path() / "1"), point(2, folder.path() / "2")});
  const auto text = text_of(folder.path() / "sweep.csv");
  expect_parts(text, {"case,Friction / Coefficient [1],",
                      "stick radius (shakedown) by MDR [m],stick radius (shakedown) by finite elements [m],"
                      "stick radius (shakedown) error bar [m]",
                      "\nfamily/1,1,", ",0.25,0.5,0.25", ",0.5,1,0.25"});
}

// Radii of 1 and 2 mm with a bar of 0.125 of a contact radius of 2 mm.
TEST(SweepSection, DrawsBarsInTheUnitOfTheValues) {
  const auto in_mm = [](double value) {
    auto one = point(value, {});
    one.json["scene"]["contact_radius_unworn"] = 2e-3;
    one.json["mdr"]["stick_radius_shakedown"] = 1.5e-3 * value;
    one.json["fe"]["stick_radius_shakedown"] = 1e-3 * value;
    for (const char* side : {"mdr", "fe"}) one.json[side]["stick_radius_first_slip"] = nullptr;
    return one;
  };
  const auto plot = sweeps_section({in_mm(1), in_mm(2)}).at("sweeps")[0].at("figures").at("figures")[0].at("plot");
  std::size_t n = 0;
  for (const auto& series : plot.at("series")) {
    if (series.at("label") != "stick radius, shakedown, finite elements") continue;
    ++n;
    EXPECT_NEAR(series.at("y")[1].get<double>(), 2, 1e-12);
    EXPECT_NEAR(series.at("bar")[1].get<double>(), 0.25, 1e-12);
  }
  EXPECT_EQ(n, 1U) << plot.dump();
}

}  // namespace
}  // namespace fretval
