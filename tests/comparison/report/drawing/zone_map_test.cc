#include "comparison/report/drawing/zone_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/expect_parts.h"

namespace fretval {
namespace {

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// Rings of equal zones are one rectangle, open ones none.
TEST(ZoneMap, DrawsARectangleAZoneAndAStep) {
  const auto edges = outer_edges({std::sqrt(0.5), std::sqrt(2.5), std::sqrt(6.5)}, 2);
  ASSERT_EQ(edges.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(edges[i], 0.5 * static_cast<double>(i + 1), 1e-15);
  const auto html = zone_map_svg(zone_map("a < b", "r / a₀", edges, {"ssf", "sbo"}));
  expect_parts(html, {"<svg", "a &lt; b", "r / a"});
  EXPECT_EQ(count(html, "fill=\"#14284f\""), 2);
  EXPECT_EQ(count(html, "fill=\"#c26a00\""), 1);
  EXPECT_EQ(count(html, "fill=\"#3a9bd0\""), 1);
  // A mark in the middle of the axis.
  auto map = zone_map("a < b", "r / a₀", edges, {"ssf", "sbo"});
  map["marks"] = {{{"name", "c"}, {"x", 0.75}}};
  expect_parts(zone_map_svg(map), {"y1=\"154.0\" y2=\"154.0\"", ">c</text>", ">slips backward</text>"});
  // Of the axis of 252 pixels, 84 a ring; the first zone of the first step is two rings high.
  expect_parts(html, {"height=\"168.00\" fill=\"#14284f\"", "height=\"84.00\" fill=\"#c26a00\""});
}

}  // namespace
}  // namespace fretval
