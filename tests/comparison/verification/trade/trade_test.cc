#include "comparison/verification/trade/trade.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/case/case_file.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/report/trade_section.h"
#include "comparison/verification/trade/trade_json.h"
#include "comparison/verification/trade/trade_text.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

PreparedCase prepared_case() {
  const ScratchFolder folder;
  return prepare(read_case_file(folder.write("case.prm", valid_case))).front();
}

TEST(ParetoFront, KeepsWhatNoOtherPointBeats) {
  const std::vector<ErrorAndSeconds> points{{1e-2, 1}, {1e-3, 4}, {2e-3, 2}, {3e-3, 3}, {2e-3, 5}, {1e-4, 9}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{0, 2, 1, 5}));
}

TEST(ParetoFront, TakesOneOfEqualPointsAndNoneThatFailed) {
  const double none = std::nan("");
  EXPECT_EQ(pareto_front({{none, 1}, {1e-2, 2}, {1e-2, 2}, {1e-2, 3}, {1e-3, none}}), (std::vector<std::size_t>{1}));
  EXPECT_EQ(pareto_front({{1e-2, 1}, {1e-2 * (1 - 1e-12), 2}}), (std::vector<std::size_t>{0}));
  EXPECT_EQ(pareto_front({{1e-2, 2}, {1e-3, 2}}), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(LogSlope, IsTheExponentOfAPower) {
  std::vector<double> x, y;
  for (const double value : {8.0, 12.0, 16.0, 32.0, 64.0}) {
    x.push_back(value);
    y.push_back(3 * std::pow(value, -2.5));
  }
  const auto all = log_slope(x, y, 0);
  EXPECT_NEAR(all->slope, -2.5, 1e-13);
  EXPECT_EQ(all->n_points, 5);
  const auto above = log_slope(x, y, 1.01 * y[2]);  // the two largest
  EXPECT_NEAR(above->slope, -2.5, 1e-13);
  EXPECT_EQ(above->n_points, 2);
  EXPECT_FALSE(log_slope(x, y, y[1]));
  EXPECT_FALSE(log_slope({2, 2}, {1, 3}, 0));
}

// What the other settings leave behind must not flatten the slope of a sweep.
TEST(LogSlope, LeavesOutTheFloorOfASweep) {
  std::vector<double> x, y;
  for (const double value : {8.0, 16.0, 32.0, 64.0, 128.0, 256.0}) {
    x.push_back(value);
    y.push_back(std::pow(value, -3) + 1e-6);
  }
  const auto rate = observed_rate(x, y);
  // Three floors up an error is up to 3/2 of its own: a slope over three doublings may be off by log2(3/2)/3.
  EXPECT_NEAR(rate->slope, -3, 0.2);
  EXPECT_EQ(rate->n_points, 4);
  EXPECT_GT(log_slope(x, y, 0)->slope, -2.5);
  // A fine point that is off by chance is behind the floor and does not count.
  EXPECT_NEAR(observed_rate({2, 4, 8, 16}, {1e-2, 1e-4, 2e-6, 4e-4})->slope, std::log2(1e-2), 1e-12);
}

TEST(Recommendation, PicksTheCheapestThatMeetsEveryTolerance) {
  const auto errors = [](double stick, double contact, double force) {
    return Quantities{{Quantity::stick_radius_first_slip, stick / 2},
                      {Quantity::stick_radius_shakedown, stick},
                      {Quantity::contact_radius_max, contact},
                      {Quantity::normal_force_max, force}};
  };
  const std::vector<Candidate> candidates{{errors(9e-4, 9e-5, 9e-5), 5},     {errors(9e-4, 2e-4, 9e-5), 1},
                                          {errors(9e-4, 9e-5, 2e-4), 1},     {errors(2e-3, 9e-5, 9e-5), 1},
                                          {errors(9.9e-4, 9e-5, 9.9e-5), 3}, {{}, 0.5}};
  EXPECT_EQ(cheapest(candidates, 1e-3), 4U);
  EXPECT_EQ(cheapest(candidates, 1e-4), std::nullopt);
  EXPECT_FALSE(meets({}, 1));
}

TEST(TradePlan, VariesOneAxisAtATimeAndKeepsTheChoicesOfTheTool) {
  const auto prepared = prepared_case();
  const auto plan = trade_plan(prepared.fem);
  std::map<Sweep, int> n;
  for (const auto& setting : plan.settings)
    for (const Sweep sweep : setting.sweeps) ++n[sweep];
  EXPECT_EQ(n[Sweep::rings], 9);
  EXPECT_EQ(n[Sweep::element_order], 3);
  EXPECT_EQ(n[Sweep::grading], 3);
  EXPECT_EQ(n[Sweep::far_field], 4);
  EXPECT_EQ(n[Sweep::time_step], 5);
  EXPECT_EQ(n[Sweep::joint], 90);
  EXPECT_EQ(n[Sweep::chosen], 3);
  for (const auto& setting : plan.settings) {
    if (setting.sweeps.count(Sweep::rings) == 0) continue;
    Resolution r = setting.resolution;
    r.elements_per_radius = plan.reference.elements_per_radius;
    EXPECT_FALSE(r < plan.reference || plan.reference < r);
  }
}

// Histories of an unlocked phase are long, those of a dashpot or a worn edge slow.
TEST(TradePlan, OfALongHistoryIsSmaller) {
  auto scene = prepared_case().fem;
  const auto finest = [](const TradePlan& plan) {
    unsigned rings = 0;
    int steps = 0;
    for (const auto& setting : plan.settings) {
      if (setting.sweeps.count(Sweep::chosen) > 0) continue;
      rings = std::max(rings, setting.resolution.elements_per_radius);
      steps = std::max(steps, setting.resolution.steps_per_cycle);
    }
    return std::make_pair(rings, steps);
  };
  EXPECT_EQ(finest(trade_plan(scene)), std::make_pair(128U, 192));
  EXPECT_EQ(trade_plan(scene).n_repetitions, 2);
  auto dashpot = scene;
  dashpot.relaxation.viscosity = 0.1;
  EXPECT_EQ(finest(trade_plan(dashpot)), std::make_pair(128U, 192));
  EXPECT_EQ(trade_plan(dashpot).n_repetitions, 1);
  scene.motion.phase.reset();
  EXPECT_EQ(finest(trade_plan(scene)), std::make_pair(48U, 96));
  EXPECT_EQ(trade_plan(scene).n_repetitions, 1);
}

TEST(AxisValue, IsTheEntryThatASweepVaries) {
  const Resolution r{8, 3, 0.25, 12, 24, 1, 1e-6};
  EXPECT_EQ(axis_value(Sweep::rings, r), 8);
  EXPECT_EQ(axis_value(Sweep::element_order, r), 3);
  EXPECT_EQ(axis_value(Sweep::grading, r), 0.25);
  EXPECT_EQ(axis_value(Sweep::far_field, r), 12);
  EXPECT_EQ(axis_value(Sweep::time_step, r), 24);
}

TEST(Quantities, OfAWornStateAreNoSlipNoForceAndTheWholeIndentation) {
  const Units units{2, 0.5, 4, 1};  // a force of 4
  const MdrAnswer answer{1.2, 2.5, std::nullopt, 1, std::nullopt, 4 * std::exp(1.0)};
  auto measures = quantities_of(answer, units, false);
  EXPECT_EQ(measures.size(), 4U);
  EXPECT_EQ(measures.at(Quantity::contact_radius_max), 1.25);
  EXPECT_EQ(measures.at(Quantity::stick_radius_first_slip), 0);
  EXPECT_EQ(measures.at(Quantity::stick_radius_shakedown), 0.5);
  EXPECT_NEAR(measures.at(Quantity::normal_force_max), 1, 1e-15);
  measures = quantities_of(answer, units, true);
  EXPECT_EQ(measures.at(Quantity::slip_inside_stick_zone), 0);
  EXPECT_EQ(measures.at(Quantity::force_outside_stick_zone), 0);
  EXPECT_EQ(measures.at(Quantity::maximum_indentation), 1);
  // Only what both have is compared; nothing compared is no number.
  const auto a = Quantity::contact_radius_max, b = Quantity::normal_force_max, c = Quantity::stick_radius_shakedown;
  EXPECT_EQ(errors_of({{a, 1}, {b, 2}}, {{b, 5}, {c, 0}}), (Quantities{{b, 3}}));
  EXPECT_EQ(largest_of({{a, 1}, {b, 2}}), 2);
  EXPECT_TRUE(std::isnan(largest_of({})));
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
