#include "comparison/report/drawing/plot_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/report/drawing/plots.h"
#include "comparison/report/drawing/share_bars.h"
#include "comparison/report/drawing/zone_map.h"
#include "tests/comparison/expect_parts.h"

namespace fretval {
namespace {

TEST(PlotTable, HasTheNumbersOfSeries) {
  Plot plot{"c_{FE} & <b>", "φ_0", "c"};
  plot.series = {{"MDR", {1, 2, 3}, {0.5, std::nan(""), -0.0}},
                 {"", {1}, {1.23456789}, Series::Style::points, 0, {0.25}}};
  const auto html = rendered(plot_table(json_of(plot)));
  expect_parts(html, {"<noscript>", "cFE &amp; &lt;b&gt;", "<th scope=\"col\">φ0</th>",
                      "<td>MDR</td><td>1</td><td>0.5</td><td>–</td>", "<td>MDR</td><td>3</td><td>0</td><td>–</td>",
                      "<td>MDR</td><td>1</td><td>1.2346</td><td>0.25</td>"});
  EXPECT_EQ(html.find("<td>2</td>"), std::string::npos) << "what has no value has no row";
}

TEST(PlotTable, IsThinnedEvenlyFromTheFirstToTheLast) {
  Plot plot{"t", "x", "y", {{"curve", {}, {}}}};
  for (int i = 0; i < 1000; ++i) {
    plot.series[0].x.push_back(i);
    plot.series[0].y.push_back(i);
  }
  const auto filling = plot_table(json_of(plot));
  const auto& rows = filling.at("table").at("rows");
  ASSERT_EQ(rows.size(), 40U);
  EXPECT_EQ(rows.front().at("cells").at(1).at("text"), "0");
  EXPECT_EQ(rows.at(1).at("cells").at(1).at("text"), "25");
  EXPECT_EQ(rows.back().at("cells").at(1).at("text"), "999");
}

TEST(PlotTable, OfZonesSaysHowFarEachReaches) {
  const auto html = rendered(plot_table(zone_map("zones", "r / a", {0.5, 1, 1.5}, {"ssf", "sbo"})));
  expect_parts(html, {"<td>0</td>", "sticks to 1, slips forward to 1.5", "<td>0.5</td>",
                      "sticks to 0.5, slips backward to 1, open to 1.5"});
}

TEST(PlotTable, OfBarsHasTheShares) {
  const auto html = rendered(plot_table(share_bars("budget", "x", {"rings", "time step"}, {{"force", {0.125, -2}}})));
  expect_parts(html, {"<th scope=\"col\">time step</th>", "<td>force</td><td>0.125</td><td>-2</td>"});
}

TEST(PlotTable, SaysWhatStandsInsteadOfNumbers) {
  Plot plot{"plane", "x", "y", {{"curve", {1}, {std::nan("")}}}};
  expect_parts(rendered(plot_table(json_of(plot))), {"<strong>plane</strong>: no data."});
  plot.series[0].y = {1};
  plot.equal_scales = true;
  expect_parts(rendered(plot_table(json_of(plot))), {"its numbers are in the CSV files"});
}

TEST(PlotTable, LeavesSubscriptsOut) {
  EXPECT_EQ(without_subscripts("|c_{FE} - c_{MDR}| / a_0"), "|cFE - cMDR| / a0");
  EXPECT_EQ(without_subscripts("{x} a_"), "{x} a_");
}

}  // namespace
}  // namespace fretval
