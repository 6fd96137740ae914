#include "comparison/verification/trade/trade.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "comparison/report/trade_section.h"
#include "comparison/verification/trade/trade_json.h"
#include "comparison/verification/trade/trade_text.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

TEST(AxisValue, IsTheEntryThatASweepVaries) {
  const Resolution r{8, 3, 0.25, 12, 24, 1, 1e-6};
  EXPECT_EQ(axis_value(Sweep::rings, r), 8);
  EXPECT_EQ(axis_value(Sweep::element_order, r), 3);
  EXPECT_EQ(axis_value(Sweep::grading, r), 0.25);
  EXPECT_EQ(axis_value(Sweep::far_field, r), 12);
  EXPECT_EQ(axis_value(Sweep::time_step, r), 24);
}

/// A plan small enough for a test: rings alone, and a body with every degree of freedom.
struct SmallTrade {
  PreparedCase prepared = prepared_case();
  TradePlan plan = trade_plan(prepared.fem, {{8, 12, 16}, {2}, {2}, {0.3}, {12}, {48}, {8}, {1e-2}});
  Trade trade = compute_trade(prepared, plan);
};

const SmallTrade& small_trade() {
  static const SmallTrade computed;
  return computed;
}

TEST(TradeSlow, ErrorsFallWithRingsAndTheFullModelAgrees) {
  const auto& trade = small_trade().trade;
  const auto rings = members_of(trade.points, Sweep::rings);
  ASSERT_EQ(rings.size(), 3U);
  for (std::size_t k = 1; k < rings.size(); ++k)
    EXPECT_LT(trade.points[rings[k]].error(), trade.points[rings[k - 1]].error());
  EXPECT_LT(trade.points[rings[0]].error(), 1e-2);
  // 3.8 times between 8 and 16 rings, 2.5e-4 to 6.6e-5; then elements of degree 2 show.
  EXPECT_LT(trade.points[rings[2]].error(), trade.points[rings[0]].error() / 3);
  for (const auto& point : trade.points) {
    EXPECT_EQ(point.failure, "");
    EXPECT_EQ(point.errors.size(), 4U);
    EXPECT_GT(point.seconds.body.factorisation, 0);
    EXPECT_GT(point.seconds.friction_history, 0);
  }
  ASSERT_EQ(trade.full.size(), 1U);
  EXPECT_EQ(trade.full[0].point.failure, "");
  EXPECT_LT(trade.full[0].point.pressure_difference, 1e-11);  // roundoff of the sparse solves
  EXPECT_LT(trade.full[0].point.traction_difference, 1e-11);
  EXPECT_GT(trade.full[0].extrapolated_seconds, trade.points[trade.full[0].condensed].seconds.total());
  ASSERT_EQ(trade.springs.size(), 4U);
  EXPECT_LT(trade.springs[3].errors.at(Quantity::stick_radius_shakedown), 1e-3);
  ASSERT_EQ(trade.recommendations.size(), 1U);
  ASSERT_TRUE(trade.recommendations[0].cheapest);
  EXPECT_LE(trade.points[*trade.recommendations[0].cheapest].seconds.total(),
            trade.points[trade.recommendations[0].chosen].seconds.total());
}

// What is written is enough to draw and tabulate it.
TEST(TradeSlow, IsReportedFromItsFile) {
  const ScratchFolder folder;
  EXPECT_EQ(trade_section(folder.path()), "");
  const auto& [prepared, plan, trade] = small_trade();
  folder.write("trade.json", trade_json(prepared, plan, trade).dump());
  const auto html = trade_section(folder.path());
  for (const char* part : {"Speed and accuracy: case", "<svg", "chosen by the tool", "extrapolated", "</table>"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  auto with_tag = trade_json(prepared, plan, trade);
  const nlohmann::ordered_json rate = with_tag["rates"].begin().value();
  with_tag["rates"]["<script>"] = rate;
  folder.write("trade.json", with_tag.dump());
  EXPECT_EQ(trade_section(folder.path()).find("<script"), std::string::npos);
  folder.write("trade.json", "{\"name\": 1}");
  EXPECT_THROW(trade_section(folder.path()), InputError);
}

void expect_lines(const std::string& text, const std::vector<std::string>& lines) {
  for (const auto& line : lines) EXPECT_NE(text.find(line + "\n"), std::string::npos) << line << "\nin\n" << text;
}

TEST(TradeText, HasALineForEverythingFound) {
  Trade trade;
  trade.reference.seconds = 2e-7;
  trade.reference.stick_radii_seconds = 8e-8;
  trade.reference.n_repetitions = 10;
  TradePoint coarse, fine;
  coarse.setting.resolution = {8, 2, 2, 12, 24, 1, 1e-6};
  coarse.errors = {{Quantity::stick_radius_shakedown, 3e-3}, {Quantity::normal_force_max, 1e-3}};
  coarse.seconds = {{0.1, 0.2, 0.3}, 0.05, 0.1};
  fine = coarse;
  fine.setting.resolution.elements_per_radius = 48;
  fine.errors[Quantity::stick_radius_shakedown] = 1e-4;
  fine.memory_bytes = 6e6;
  trade.points = {coarse, fine};
  trade.front = {0, 1};
  trade.recommendations = {{1e-2, 0, 1, true}, {1e-5, std::nullopt, 1, false}};
  trade.rates = {{Sweep::rings,
                  {{Quantity::normal_force_max, LogSlope{-2.5, 3}}, {Quantity::contact_radius_max, std::nullopt}},
                  {}}};
  trade.seconds_over_rings = LogSlope{1.25, 4};
  SpringPoint springs;
  springs.setting = {100, 90, 10, 1e-6};
  springs.errors = {{Quantity::stick_radius_shakedown, 2e-4}};
  springs.seconds = 0.25;
  trade.springs = {springs, springs};
  trade.springs[1].failure = "not periodic";
  FullPoint full;
  full.resolution = coarse.setting.resolution;
  full.n_dofs = 1234;
  full.n_normal_steps = 10;
  full.normal_seconds = 2;
  full.pressure_difference = 1e-12;
  trade.full = {{full, 0, 99}, {full, 0, 0}};
  trade.full[1].point.failure = "out of memory";
  const std::string best = "    8     2       2    12     24   3.00e-03     0.750         -";
  const std::string finest = "   48     2       2    12     24   1.00e-03     0.750       6.0";
  const std::string full_line =
      "full finite elements: 8 rings, order 2, 1234 dofs: pressure and traction within 1.0e-12 and 0.0e+00 of the "
      "condensed ones; 0.200 and 0.000 s a step measured";
  expect_lines(
      trade_text(trade),
      {"front        " + best, "front        " + finest, "best 1e-02   " + best, "tool 1e-02   " + finest,
       "best 1e-05: no setting of the plan meets it", "tool 1e-05 ! " + finest,
       "closed form: error 0 by definition, 2.00e-07 s, of which stick radii 8.0e-08 s (fastest of 10)",
       "springs: 100 springs, 90 steps a period: error 2.00e-04, 0.250 s",
       "springs: 100 springs, 90 steps a period: not periodic", full_line,
       "  whole history extrapolated: 99.0 s, error 3.00e-03; condensed: 0.750 s",
       "full finite elements: 8 rings, order 2, 1234 dofs: out of memory",
       std::string("  ") + name_of(Sweep::rings) + "      largest -, contact_radius_max -, normal_force_max -2.50 (3)",
       "power of the seconds in the rings: 1.25 (4)"});
}

int exit_code_of_trade(const std::string& file, const ScratchFolder& folder) {
  const std::string out = (folder.path() / "out").string(), log = (folder.path() / "log").string();
  const int status =
      std::system((std::string(FRETVAL_PROGRAM) + " trade " + file + " -o " + out + " >" + log + " 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(TradeCommand, RefusesBadInputAndWritesNothing) {
  const ScratchFolder folder;
  const auto sweep = folder.write(
      "sweep.prm", valid_case + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:90:180\nend\n");
  const auto bad = folder.write("bad.prm", replace(valid_case, "modulus = 1e6", "modulus = -1"));
  const auto forces =
      folder.write("forces.prm", replace(valid_case, "Tangential frequency = 1", "Tangential frequency = 2"));
  for (const auto& file : {sweep, bad, forces, folder.path() / "nowhere.prm"})
    EXPECT_EQ(exit_code_of_trade(file.string(), folder), 2) << file;
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

}  // namespace
}  // namespace fretval
