#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "comparison/results/answer_text.h"
#include "comparison/results/case_result.h"
#include "tests/comparison/damaged_case.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/made_up_result.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/shown.h"

namespace fretval::zones_json_test {
namespace {

ErrorBar bar(double total) {
  return {{{ErrorSource::rings, total, std::nullopt}}};
}

TEST(ZonesJson, HasEndsWithBarsInMetres) {
  ZoneAnswer zones;
  zones.contact = {{0, 5e-4}, {7e-4, 1e-3}};
  zones.shakedown = {{7e-4, 8e-4}};
  zones.pressure_max = 2e5;
  const ZoneBudget bars{{{std::nullopt, bar(2e-3)}, {bar(4e-3), std::nullopt}}, {}, {}, bar(0.01)};
  const auto json = zones_json(zones, bars, 1e-3);
  EXPECT_EQ(json.at("contact").size(), 2U);
  EXPECT_EQ(json.at("contact")[1].at("inner"), 7e-4);
  EXPECT_TRUE(json.at("contact")[0].at("inner_bar").is_null());
  EXPECT_NEAR(json.at("contact")[0].at("outer_bar").get<double>(), 2e-6, 1e-18);
  EXPECT_NEAR(json.at("contact")[1].at("inner_bar").get<double>(), 4e-6, 1e-18);
  EXPECT_NEAR(json.at("pressure_max_bar").get<double>(), 2e3, 1e-9);
  EXPECT_EQ(json.at("why_no_radius").at("first_slip"), "nothing sticks");
  EXPECT_EQ(json.at("why_no_radius").at("shakedown"), "an annulus sticks, and no disc");
  EXPECT_EQ(annuli_text(json.at("contact")), "0 to 500 ± 2 µm; 700 ± 4 µm to 1.00000 mm");
  EXPECT_EQ(annuli_text(json.at("first_slip")), "none");
}

// Bars are over a length of 2 m; an area is as uncertain as its edge all around, 2 pi times radius and bar.
TEST(ZonesJson, OfAZoneOnRingsAndAnglesHasTheBarOfEachExtent) {
  auto result = made_up_result();
  SurfaceAnswer surface{};
  surface.contact = {3.5, 1.05, 1.1, 1.0};
  surface.never_slipped = {1.25, 0.625, 0.65, 0.6};
  surface.sticks_in_a_cycle = {2, 0.8, 0.85, 0.75};
  surface.torque_max = 0.3;
  surface.history.second_difference = 1e-7;
  result.fe.fe.of_kind = surface;
  using Q = Quantity;
  double next = 0.01;
  for (const auto quantity :
       {Q::contact_radius_max, Q::contact_along, Q::contact_across, Q::stick_radius_first_slip, Q::first_slip_along,
        Q::first_slip_across, Q::stick_radius_shakedown, Q::shakedown_along, Q::shakedown_across}) {
    result.fe.budget[quantity] = bar(next);
    next += 0.01;
  }
  const auto json = zones_json(result);
  next = 0.02;  // m
  for (const auto& [name, zone] : {std::pair{"contact", surface.contact},
                                   {"never_slipped", surface.never_slipped},
                                   {"sticks_in_a_cycle", surface.sticks_in_a_cycle}}) {
    const auto number = [&, key = name](const char* what) { return json.at(key).at(what).get<double>(); };
    EXPECT_EQ(number("area"), zone.area) << name;
    EXPECT_EQ(number("radius"), zone.radius) << name;
    EXPECT_EQ(number("along"), zone.along) << name;
    EXPECT_EQ(number("across"), zone.across) << name;
    EXPECT_NEAR(number("area_bar"), 2 * std::acos(-1.0) * zone.radius * next, 1e-12) << name;
    EXPECT_NEAR(number("radius_bar"), next, 1e-12) << name;
    EXPECT_NEAR(number("along_bar"), next + 0.02, 1e-12) << name;
    EXPECT_NEAR(number("across_bar"), next + 0.04, 1e-12) << name;
    next += 0.06;
  }
  EXPECT_EQ(json.at("torque_max"), 0.3);
  EXPECT_EQ(json.at("second_algorithm"), 1e-7);
}

// What sticks at the end of a pass stands in the place of what sticks in a cycle; its bars are those of its own edge.
TEST(ZonesJson, OfAPassHasWhatSticksAtItsEnd) {
  auto result = made_up_result();
  SurfaceAnswer surface{};
  surface.sticks_at_the_end = {2, 0.8, 0.85, 0.75, 0.03, 0.07};
  result.fe.fe.of_kind = surface;
  result.fe.fe.motion_kind = MotionKind::pass;
  const auto json = zones_json(result);
  EXPECT_FALSE(json.contains("sticks_in_a_cycle"));
  const auto& end = json.at("sticks_at_the_end");
  EXPECT_EQ(end.at("radius_bar"), 0.03);
  EXPECT_EQ(end.at("along_bar"), 0.07);
  EXPECT_EQ(end.at("across_bar"), 0.07);
  EXPECT_NEAR(end.at("area_bar").get<double>(), 2 * std::acos(-1.0) * 0.8 * 0.03, 1e-15);
  EXPECT_TRUE(json.at("contact").at("radius_bar").is_null());
}

// A bar that is infinite says nothing, and is none.
TEST(ZonesJson, HasNoInfiniteBar) {
  ZoneAnswer zones;
  zones.contact = {{0, 1e-3}};
  zones.contact_uncertainty = 3e-6;
  zones.pressure_max = 2e5;
  const ZoneBudget bars{{{std::nullopt, bar(HUGE_VAL)}}, {}, {}, bar(HUGE_VAL)};
  const auto json = zones_json(zones, bars, 1e-3);
  EXPECT_TRUE(json.at("contact")[0].at("outer_bar").is_null());
  EXPECT_TRUE(json.at("pressure_max_bar").is_null());
  EXPECT_EQ(json.at("contact_uncertainty"), 3e-6);
}

// Springs under a parabola of R = 1e-2 m, 0.5 m deep: a = sqrt(R d) and 16/3 G0 sqrt(R) d^(3/2). Finite elements are
// said to bear four fifths of that, on twice the radius.
TEST(ZonesJson, OfWhatIsNotComparedHasBothAtRest) {
  auto result = made_up_result();
  ZoneAnswer zones;
  const double radius = std::sqrt(1e-2 * 0.5), force = 16.0 / 3 * 1e6 * 0.1 * std::pow(0.5, 1.5);
  zones.force_at_rest = force / 1.25;
  zones.radius_at_rest = radius * 2;
  result.fe.fe.of_kind = zones;
  const auto json = not_compared_json(result).at("at_rest");
  EXPECT_EQ(json.at("indentation"), 0.5);
  EXPECT_EQ(json.at("normal_force"), zones.force_at_rest);
  EXPECT_EQ(json.at("contact_radius"), zones.radius_at_rest);
  EXPECT_NEAR(json.at("normal_force_of_springs").get<double>() / force, 1, 1e-6);
  EXPECT_NEAR(json.at("contact_radius_of_springs").get<double>() / radius, 1, 1e-6);
  EXPECT_NEAR(json.at("normal_force_difference").get<double>(), 0.25, 1e-5);
  EXPECT_NEAR(json.at("contact_radius_difference").get<double>(), -0.5, 1e-6);
}

// Exit code 0: nothing disagrees. The verdict has a name in everything that somebody may read.
TEST(ZonesJson, ARunBeyondMdrSaysSo) {
  const ScratchFolder folder;
  const auto file = write_damaged_case(folder, groove(0.5, 0.7, 0.04));
  const auto out = folder.path() / "out", junit = folder.path() / "junit.xml";
  const auto run = fretval_run(
      "run --proof none --no-store " + quoted(file) + " -o " + quoted(out) + " --junit " + quoted(junit), folder);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  expect_parts(run.out, {"not compared: MDR does not hold for this profile", "falls for x = ", " of the normal force",
                         "contact, r", "stick, shakedown, r"});
  const auto json = nlohmann::json::parse(text_of(out / "damaged/result.json"));
  EXPECT_TRUE(json.at("pass").get<bool>());
  EXPECT_TRUE(json.at("comparison").empty());
  EXPECT_TRUE(json.at("mdr").at("normal_force_max").is_null());
  const auto& at_rest = json.at("not_compared").at("at_rest");
  EXPECT_NEAR(at_rest.at("normal_force_difference").get<double>(),
              at_rest.at("normal_force_of_springs").get<double>() / at_rest.at("normal_force").get<double>() - 1,
              1e-12);
  EXPECT_EQ(json.at("not_compared").at("reason"), "MDR does not hold for this profile");
  EXPECT_EQ(json.at("fe").at("zones").at("contact").size(), 2U);
  expect_parts(shown(text_of(out / "index.html")), {"not compared", "MDR does not hold for this profile"});
  expect_parts(text_of(junit), {"failures=\"0\"", "MDR does not hold for this profile"});
  EXPECT_EQ(text_of(out / "damaged/history.csv").find("MDR"), std::string::npos);
  // Letters of the rings beyond the groove, which is open.
  const auto cycle = nlohmann::json::parse(text_of(out / "damaged/cycle.json"));
  const auto zones = cycle.at("zones").back().get<std::string>();
  EXPECT_NE(zones.find_last_not_of('o'), std::string::npos);
  EXPECT_LT(zones.find('o'), zones.find_last_not_of('o'));
}

TEST(ZonesJson, MdrAloneRefusesAndExplainSaysWhy) {
  const ScratchFolder folder;
  const auto file = write_damaged_case(folder, groove(0.5, 0.7, 0.04));
  const auto mdr = fretval_run("mdr " + quoted(file), folder);
  EXPECT_EQ(mdr.exit_code, 2);
  expect_parts(mdr.err, {"damaged.csv", "MDR does not hold", "falls for x = ", "fretval run"});
  const auto explained = fretval_run("explain " + quoted(file), folder);
  EXPECT_EQ(explained.exit_code, 0) << explained.err;
  expect_parts(explained.out, {"does not hold for this profile", "falls for x = ", "whatever order"});
  const auto refused = [&](const std::string& name, const std::string& more) {
    const auto run = fretval_run("run " + quoted(folder.write(name, text_of(file) + more)), folder);
    EXPECT_EQ(run.exit_code, 2);
    return run.err;
  };
  expect_parts(refused("wears.prm", "subsection Wear\n  set Coefficient = 1e-12\nend\n"),
               {"wears.prm: Wear / Coefficient", "MDR does not hold", "no wear"});
  expect_parts(refused("vector.prm", "subsection Contact\n  set Friction = vector\nend\n"),
               {"vector.prm: Contact / Friction = vector", "MDR does not hold", "unidirectional"});
}

}  // namespace
}  // namespace fretval::zones_json_test
