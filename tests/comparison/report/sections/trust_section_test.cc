#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"

namespace fretval::trust_section_test {
namespace {

using nlohmann::ordered_json;

/// MDR has 0.8 mm; over the body alone 1 mm, of a vector 0.76 mm, of both 0.9 mm.
ordered_json made_up_trust() {
  const auto off = [](double truth) {
    return ordered_json{{"stick_radius_shakedown", {{"value", 8e-4 / truth - 1}, {"uncertainty", 1e-3}}}};
  };
  return {{"name", "rig"},
          {"headline", "MDR's shakedown radius is 11 % too small here"},
          {"headline_quantity", "stick_radius_shakedown"},
          {"mdr", {{"stick_radius_shakedown", 8e-4}}},
          {"mdr_off_by", off(9e-4)},
          {"fe", {{"stick_radius_shakedown", {{"value", 9e-4}, {"uncertainty", 1e-6}}}}},
          {"rungs",
           {{"body", {{"title", "a layer 2 mm thick"}, {"mdr_off_by", off(1e-3)}}},
            {"friction", {{"title", "friction as a vector"}, {"mdr_off_by", off(7.6e-4)}}}}},
          {"not_computed", {{{"assumption", "finite strains"}, {"order", "about 0.0815"}}}},
          {"inputs", ordered_json::array()},
          {"at",
           {{"phase", -60}, {"poisson_ratio", 0.5}, {"radius_over_thickness", 0.5}, {"stick_radius_shakedown", 0.6}}}};
}

TEST(TrustSection, HasTheLadderAsAWaterfall) {
  const auto section = trust_section(made_up_trust());
  const auto& plot = section.at("waterfall").at("figures").at(0).at("plot");
  EXPECT_EQ(plot.at("sources").at(0), "larger than MDR has it");
  EXPECT_EQ(plot.at("sources").at(1), "smaller");
  const auto& rows = plot.at("rows");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].at("label"), "a layer 2 mm thick");
  EXPECT_NEAR(rows[0].at("shares").at(0).get<double>(), 25, 1e-9);
  EXPECT_NEAR(rows[1].at("start").get<double>(), 25, 1e-9);
  EXPECT_NEAR(rows[1].at("shares").at(1).get<double>(), -5, 1e-9);
  EXPECT_NEAR(rows[2].at("shares").at(1).get<double>(), 12.5 - 20, 1e-9);
  EXPECT_NEAR(rows[2].at("bar").get<double>(), 0.1 / 0.64 + 0.1 * 0.9025 + 0.1 * 81 / 64, 2e-3) << "of all three";
  EXPECT_NEAR(rows[3].at("shares").at(0).get<double>(), 12.5, 1e-9);
  EXPECT_EQ(rows[3].at("start").get<double>(), 0);
}

TEST(TrustSection, MarksTheCaseOnTheMaps) {
  const auto section = trust_section(made_up_trust());
  const auto& figures = section.at("maps").at("figures");
  ASSERT_EQ(figures.size(), 3U);
  const auto& series = figures[0].at("plot").at("series").back();
  EXPECT_EQ(series.at("label"), "this case");
  EXPECT_EQ(series.at("x").at(0), 0.6);
  EXPECT_EQ(series.at("y").at(0), 120);
}

TEST(TrustSection, ShowsTheZonesBesideThoseOfMdr) {
  auto trust = made_up_trust();
  EXPECT_FALSE(trust_section(trust).contains("zones"));
  trust["zones"] = {{"angle", {0, 3.14159265}},
                    {"contact", {1.2e-3, 1.2e-3}},
                    {"never_slipped", {5e-4, 5e-4}},
                    {"sticks_in_a_cycle", {9e-4, 9e-4}}};
  const auto section = trust_section(trust);
  const auto& series = section.at("zones").at("figures").at(0).at("plot").at("series");
  ASSERT_EQ(series.size(), 4U);
  EXPECT_EQ(series[3].at("label"), "sticks in a cycle by MDR");
  EXPECT_NEAR(series[3].at("x").at(0).get<double>(), 0.8, 1e-9);
}

TEST(TrustSection, IsFilledIn) {
  const auto html = rendered(trust_section(made_up_trust()));
  expect_parts(html, {"How far MDR can be trusted: rig", "11 % too small", "a layer 2 mm thick", "finite strains", "about 0.0815",
                      "800.000 µm", "900 ± 1 µm", "+12.5 ± 0.1 %", "Roache"});
}

TEST(TrustSection, SaysSoWithoutAContact) {
  auto trust = made_up_trust();
  trust.erase("headline_quantity");
  trust["fe"] = trust["mdr_off_by"] = ordered_json::object();
  EXPECT_FALSE(trust_section(trust).contains("waterfall"));
}

}  // namespace
}  // namespace fretval::trust_section_test
