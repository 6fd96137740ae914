#include "comparison/verification/trade/trade.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/report/trade_section.h"
#include "comparison/verification/trade/trade_json.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

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

}  // namespace
}  // namespace fretval
