#include "comparison/report/drawing/zone_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fretval {
namespace {

TEST(ZoneMap, IsDataOfThePage) {
  EXPECT_EQ(zone_map("a < b", "r", {0.5, 1}, {"sf", "bo"}).dump(),
            R"({"kind":"map","title":"a < b","x_label":"time over the period","y_label":"r","edges":[0.5,1.0],)"
            R"("zones":["sf","bo"]})");
}

TEST(ZoneMap, HasTheOuterEdgesOfRings) {
  const auto edges = outer_edges({std::sqrt(0.5), std::sqrt(2.5), std::sqrt(6.5)}, 2);
  ASSERT_EQ(edges.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(edges[i], 0.5 * static_cast<double>(i + 1), 1e-15);
}

}  // namespace
}  // namespace fretval
