#include "comparison/report/sweep_section.h"

#include <gtest/gtest.h>

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
  expect_parts(html,
               {"Stick radii", "Friction / Coefficient", "\"y\":[0.25,0.5]", "\"y\":[0.5,1.0]", "\"bar\":[0.25,0.25]"});
  EXPECT_TRUE(sweeps_section({point(1, {})}).is_null()) << "a point is no curve";
}

TEST(SweepSection, LeavesThePhaseToTheFiguresOfThePaper) {
  EXPECT_TRUE(sweeps_section({StoredResult{stored_result(), {}}, StoredResult{stored_result(), {}}}).is_null());
}

TEST(SweepSection, WritesItsNumbers) {
  const ScratchFolder folder;
  write_sweeps({point(1, folder.path() / "1"), point(2, folder.path() / "2")});
  const auto text = text_of(folder.path() / "sweep.csv");
  expect_parts(text, {"name,Friction / Coefficient,",
                      "stick_radius_shakedown MDR [m],stick_radius_shakedown FE [m],"
                      "stick_radius_shakedown bar [m]",
                      "\nfamily/1,1,", ",0.25,0.5,0.25", ",0.5,1,0.25"});
}

}  // namespace
}  // namespace fretval
