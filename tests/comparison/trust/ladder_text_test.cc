#include "comparison/trust/ladder_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/comparison/expect_parts.h"

namespace fretval::ladder_text_test {
namespace {

using nlohmann::ordered_json;

/// MDR has 0.8 mm where finite elements have 1 mm for the body alone, and 0.9 mm for the whole.
Ladder made_up(std::size_t n_rungs) {
  constexpr auto radius = Quantity::stick_radius_shakedown;
  const auto at = [&](double truth) { return OffBys{{radius, OffBy{{truth, 1e-6}, 8e-4 / truth - 1, 1e-6 / truth}}}; };
  Ladder ladder;
  ladder.mdr[radius] = {8e-4};
  Case layer;
  layer.body = {Case::Body::Shape::layer, 2e-3, 0, true};
  const std::vector<RungAnswer> rungs{{{"body", "a layer 2 mm thick", layer}, at(1e-3)},
                                      {{"poisson_ratio", "nu = 0.4", {}}, at(7.6e-4)}};
  ladder.rungs.assign(rungs.begin(), rungs.begin() + static_cast<std::ptrdiff_t>(n_rungs));
  ladder.whole = {{"whole", "the case as it is", {}}, at(n_rungs == 2 ? 9e-4 : 1e-3)};
  ladder.contact_radius = 1.2e-3;
  ladder.not_computed = {{"finite strains", "0.1"}};
  return ladder;
}

TEST(LadderText, BeginsWithWhatADesignerAsks) {
  EXPECT_EQ(headline_of(made_up(1)),
            "MDR's shakedown radius is 20 % ± 0.1 % too small here: a layer 2 mm thick, a/H = 0.6 (-20 %)");
  expect_parts(headline_of(made_up(2)),
               {"11.1 % ± 0.1 % too small", "a layer 2 mm thick, a/H = 0.6 (-20 %); nu = 0.4 (+5.26 %)"});
}

// The shakedown radius is off by -11.1 % with a bar of 0.1 %; the contact radius, which is too large, by +6 +- 1 %; a
// force is no radius.
TEST(LadderText, NamesTheRadiiThatAreOffByMoreThanTheirBarsLeaveOpen) {
  auto ladder = made_up(2);
  ladder.whole.off_by[Quantity::contact_radius_max] = {{1e-3}, 0.06, 0.01};
  ladder.whole.off_by[Quantity::normal_force_max] = {{1}, 0.5, 0};
  EXPECT_EQ(radii_beyond(0.049, ladder), "stick radius, shakedown, largest contact radius");
  EXPECT_EQ(radii_beyond(0.051, ladder), "stick radius, shakedown");
  EXPECT_EQ(radii_beyond(0.1105, ladder), "");
  EXPECT_EQ(radii_beyond(0.1095, ladder), "stick radius, shakedown");
}

TEST(LadderText, SaysSoWhereNothingIsResolved) {
  auto ladder = made_up(1);
  ladder.whole.off_by.begin()->second = {{8e-4, 1e-6}, 1e-4, 1e-3};
  expect_parts(headline_of(ladder), {"nothing is resolved beyond numerics", "0.1 %"});
}

TEST(LadderText, ShowsRungsAndWhatTheyAreNotTheSumOf) {
  const auto text = ladder_text("rig", made_up(2));
  expect_parts(text, {"rig: MDR's", "body alone", "nu alone", "beyond the sum", "800.000 µm", "900 ± 1 µm", "-11.1 %",
                      "-20 %", "+5.26 %", "+3.63 %", "not computed:\n  finite strains (0.1)"});
  EXPECT_EQ(ladder_text("rig", made_up(1)).find("body alone"), std::string::npos);
}

TEST(LadderJson, HasTheWholeAndEachRung) {
  Case rig;
  rig.name = "rig";
  const auto json = ladder_json(rig, made_up(2));
  EXPECT_EQ(json.at("name"), "rig");
  EXPECT_EQ(json.at("headline_quantity"), "stick_radius_shakedown");
  EXPECT_EQ(json.at("at").at("poisson_ratio"), 0.5);
  EXPECT_NEAR(json.at("mdr_off_by").at("stick_radius_shakedown").at("value").get<double>(), 8.0 / 9 - 1, 1e-15);
  EXPECT_TRUE(json.at("mdr_off_by").at("stick_radius_shakedown").at("resolved").get<bool>());
  EXPECT_DOUBLE_EQ(json.at("rungs").at("body").at("mdr_off_by").at("stick_radius_shakedown").at("value").get<double>(),
                   -0.2);
  EXPECT_DOUBLE_EQ(json.at("rungs").at("body").at("fe").at("stick_radius_shakedown").at("uncertainty").get<double>(),
                   1e-6);
  const auto interaction = json.at("interaction").at("stick_radius_shakedown");
  EXPECT_NEAR(interaction.at("value").get<double>(), (8.0 / 9 - 1) + 0.2 - (8 / 7.6 - 1), 1e-12);
  EXPECT_NEAR(interaction.at("uncertainty").get<double>(), 1e-6 * (1 / 9e-4 + 1 / 1e-3 + 1 / 7.6e-4), 1e-12);
  EXPECT_TRUE(interaction.at("resolved").get<bool>());
  EXPECT_FALSE(json.contains("zones"));
  EXPECT_EQ(json.at("not_computed").at(0).at("assumption"), "finite strains");
}

TEST(LadderJson, HasTheEdgesOfTheZones) {
  auto ladder = made_up(2);
  ladder.edges = PlaneEdges{{0, 1}, {3, 4}, {1, 2}, {}};
  auto zones = ladder_json({}, ladder).at("zones");
  EXPECT_EQ(zones.at("never_slipped"), ordered_json({1.0, 2.0}));
  EXPECT_FALSE(zones.contains("sticks_in_a_cycle")) << "of a single pass";
  ladder.edges->sticks_in_a_cycle = {2, 3};
  EXPECT_EQ(ladder_json({}, ladder).at("zones").at("sticks_in_a_cycle"), ordered_json({2.0, 3.0}));
}

// By MDR's own model a is 1 mm, and the body 4 mm thick.
TEST(LadderJson, HasThePlaceOnTheMapsByMdr) {
  auto ladder = made_up(1);
  ladder.mdr[Quantity::contact_radius_max] = {1e-3};
  Case layer;
  layer.body = {Case::Body::Shape::layer, 4e-3, 0, true};
  layer.motion.phase = 30;
  const auto at = ladder_json(layer, ladder).at("at");
  EXPECT_NEAR(at.at("radius_over_thickness").get<double>(), 0.25, 1e-12);
  EXPECT_NEAR(at.at("stick_radius_shakedown").get<double>(), 0.8, 1e-12);
  EXPECT_EQ(at.at("phase"), 30);
  layer.body = {};
  EXPECT_EQ(ladder_json(layer, ladder).at("at").at("radius_over_thickness"), 0);
}

}  // namespace
}  // namespace fretval::ladder_text_test
