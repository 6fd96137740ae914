#include "comparison/results/changes.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/stored_result.h"

namespace fretval::changes_test {
namespace {

/// A radius of 0.5 mm in a contact of 1 mm, with a bar of 1e-3 a.
StoredResult result(double stick_radius = 5e-4, const std::string& name = "one") {
  return {{{"name", name},
           {"pass", true},
           {"scene", {{"file", "a.prm"}, {"contact_radius_unworn", 1e-3}, {"indentation", 1e-4}}},
           {"mdr", nlohmann::ordered_json::object()},
           {"fe", {{"stick_radius_shakedown", stick_radius}, {"normal_force_max", 2.0}}},
           {"comparison",
            {{"stick_radius_shakedown", {{"error_bar", 1e-3}}}, {"normal_force_max", {{"error_bar", nullptr}}}}}},
          "folder"};
}

const Change& of(const Changes& changes, Quantity quantity) {
  for (const auto& change : changes.values)
    if (change.quantity == quantity) return change;
  throw std::logic_error("not there");
}

TEST(Changes, AreHeldToTheBarsOfBothTogether) {
  const auto within = changes_between({result()}, {result(5.019e-4)});
  EXPECT_NEAR(of(within, Quantity::stick_radius_shakedown).difference, 1.9e-3, 1e-15);
  EXPECT_EQ(of(within, Quantity::stick_radius_shakedown).bars, 2e-3);
  EXPECT_FALSE(within.any());
  const auto beyond = changes_between({result()}, {result(5.021e-4)});
  EXPECT_TRUE(beyond.any());
  expect_parts(changes_text(beyond), {"one: ", "500.000 µm -> 502.100 µm, by 2.1e-03, bars 2.0e-03",
                                      "1 of 2 values moved beyond their bars"});
}

TEST(Changes, OfACaseAreToldByItsName) {
  const auto changes = changes_between({result(), result(5e-4, "two")}, {result(), result(5.021e-4, "two")});
  EXPECT_EQ(changes.of_case("one"), "");
  expect_parts(changes.of_case("two"), {"two: stick radius, shakedown: 500.000 µm -> 502.100 µm"});
  EXPECT_EQ(changes_text(changes_between({result()}, {result()})), "none of 2 values has moved\n");
}

// A tolerance that was loosened, or an error in the judgement: no value moves.
TEST(Changes, OfAVerdictAloneCount) {
  auto other = result();
  other.json["pass"] = false;
  const auto lost = changes_between({result()}, {other}), won = changes_between({other}, {result()});
  EXPECT_TRUE(lost.any());
  EXPECT_TRUE(won.any());
  EXPECT_EQ(lost.of_case("one"), "  one: agree before, now not resolved\n");
  EXPECT_EQ(lost.of_case("two"), "");
  expect_parts(changes_text(won), {"verdicts:\n  one: not resolved before, now agree\n", "none of 2 values has moved"});
}

TEST(Changes, WithoutABarAreHeldToRoundoff) {
  auto other = result();
  other.json["fe"]["normal_force_max"] = 2 * (1 + 1e-10);
  EXPECT_FALSE(changes_between({result()}, {other}).any());
  other.json["fe"]["normal_force_max"] = 2 * (1 + 1e-8);
  EXPECT_TRUE(changes_between({result()}, {other}).any());
}

TEST(Changes, OfARadiusThatIsGoneIsBeyondAnyBar) {
  auto other = result();
  other.json["fe"]["stick_radius_shakedown"] = nullptr;
  EXPECT_TRUE(changes_between({result()}, {other}).any());
  expect_parts(changes_text(changes_between({result()}, {other})), {"500.000 µm -> none"});
}

// Nothing moves beyond a bar, but a radius has moved: by 1.9e-3 of the contact radius of the first folder, inwards. A
// verdict that names another reason for passing is none that has changed.
TEST(Changes, WithinTheBarsAreToldByTheirLargest) {
  auto other = result(4.981e-4);
  other.json["scene"]["contact_radius_unworn"] = 2e-3;
  other.json["verdict"] = "agree";
  auto before = result();
  before.json["verdict"] = "other model";
  const auto changes = changes_between({before}, {other});
  EXPECT_TRUE(changes.verdicts.empty());
  EXPECT_EQ(of(changes, Quantity::normal_force_max).difference, 0);
  EXPECT_EQ(changes_text(changes), "0 of 2 values moved beyond their bars; the others by up to 1.9e-03\n");
  const auto others = changes_between({result(), result(5e-4, "gone")}, {result(), result(5e-4, "new")});
  expect_parts(changes_text(others), {"only in the first folder:\n  gone\nonly in the second folder:\n  new\n"});
}

TEST(Changes, NameOtherInputsVerdictsAndCases) {
  auto other = result();
  const auto entry = [](const char* section, const char* name, const nlohmann::ordered_json& value, const char* unit) {
    return nlohmann::ordered_json{{"section", section}, {"name", name}, {"value", value}, {"unit", unit}};
  };
  auto before = result();
  before.json["scene"]["inputs"] = {entry("Indenter", "Shape", "cone", ""), entry("Motion", "Indentation", 1e-4, "m"),
                                    entry("Motion", "Phase", 60.0, "°"),
                                    entry("Elastomer", "Branch moduli", {1e6, 5e5}, "Pa")};
  other.json["scene"]["inputs"] = {entry("Indenter", "Shape", "cone", ""), entry("Motion", "Indentation", 2e-4, "m"),
                                   entry("Motion", "Phase", "free", ""),
                                   entry("Elastomer", "Branch moduli", {1e6, 2e6}, "Pa"),
                                   entry("Friction", "Coefficient", 0.5, "")};
  other.json["scene"]["indentation"] = 2e-4;
  other.json["scene"]["file"] = "elsewhere/a.prm";
  other.json["pass"] = false;
  const auto changes = changes_between({before, result(5e-4, "gone")}, {other, result(5e-4, "new")});
  EXPECT_EQ(changes.inputs, (std::vector<std::string>{"one: Elastomer / Branch moduli: 1 MPa, 500 kPa -> 1 MPa, 2 MPa",
                                                      "one: Friction / Coefficient: none -> 0.5",
                                                      "one: Motion / Indentation: 100 µm -> 200 µm",
                                                      "one: Motion / Phase: 60° -> free"}));
  EXPECT_EQ(changes.verdicts.count("one"), 1U);
  EXPECT_EQ(changes.only_before, std::vector<std::string>{"gone"});
  EXPECT_EQ(changes.only_after, std::vector<std::string>{"new"});
}

}  // namespace
}  // namespace fretval::changes_test
