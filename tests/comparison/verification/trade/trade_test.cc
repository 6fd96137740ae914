#include "comparison/verification/trade/trade.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/report/trade_section.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

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

TEST(TradeSlow, ErrorsFallWithRingsAndTheFullModelIsSlower) {
  const auto& trade = small_trade().trade;
  const auto rings = members_of(trade.points, trade_axes()[0]);
  ASSERT_EQ(rings.size(), 3U);
  for (std::size_t k = 1; k < rings.size(); ++k)
    EXPECT_LT(trade.points[rings[k]].error(), trade.points[rings[k - 1]].error());
  EXPECT_LT(trade.points[rings[0]].error(), 1e-2);
  // 3.8 times between 8 and 16 rings, 2.5e-4 to 6.6e-5; then elements of degree 2 show.
  EXPECT_LT(trade.points[rings[2]].error(), trade.points[rings[0]].error() / 3);
  for (const auto& point : trade.points) {
    EXPECT_EQ(point.failure, "");
    EXPECT_EQ(point.errors.size(), 4U);
    for (const char* stage : {"factorisation", "friction_history"})
      EXPECT_GT(point.cost["seconds"][stage].get<double>(), 0) << stage;
  }
  ASSERT_EQ(trade.full.size(), 1U);
  const auto& full = trade.full[0];
  const auto same = [&](const TradePoint& point) { return point.resolution == full.resolution; };
  const auto& condensed = *std::find_if(trade.points.begin(), trade.points.end(), same);
  EXPECT_EQ(full.failure, "");
  EXPECT_GT(full.seconds(condensed.n_normal_steps, condensed.n_friction_steps), condensed.seconds);
  ASSERT_EQ(trade.springs.size(), 4U);
  EXPECT_LT(trade.springs[3].errors.at(Quantity::stick_radius_shakedown), 1e-3);
  ASSERT_EQ(trade.recommendations.size(), 1U);
  ASSERT_TRUE(trade.recommendations[0].cheapest);
  EXPECT_LE(trade.points[*trade.recommendations[0].cheapest].seconds,
            trade.points[trade.recommendations[0].chosen].seconds);
}

// What is written is enough to draw and tabulate it.
TEST(TradeSlow, IsReportedFromItsFile) {
  const ScratchFolder folder;
  EXPECT_EQ(trade_section(folder.path()), "");
  const auto& [prepared, plan, trade] = small_trade();
  folder.write("trade.json", trade_json(prepared, plan, trade).dump());
  const auto html = trade_section(folder.path());
  for (const char* part :
       {"Speed and accuracy: case", "<svg", "chosen by the tool", "400 springs", "extrapolated", "</table>"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  expect_parts(trade_text(trade_json(prepared, plan, trade)),
               {"The closed form takes", "\ncheapest for 1e-02", "\nchosen by the tool for 1e-02", "\nfront ",
                "\n400 springs", "dofs, extrapolated", "\nrings "});
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
