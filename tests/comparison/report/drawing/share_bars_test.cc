#include "comparison/report/drawing/share_bars.h"

#include <gtest/gtest.h>

#include "comparison/report/drawing/plots.h"
#include "tests/comparison/expect_parts.h"

namespace fretval {
namespace {

Filling two_rows() {
  return share_bars("Error <budget>", "over the tolerance", {"rings", "time step"},
                    {{"first slip", {0.25, 0.5}}, {"force", {0, 0.125}}});
}

TEST(ShareBars, AreDataOfThePage) {
  EXPECT_EQ(two_rows().dump(),
            R"({"kind":"bars","title":"Error <budget>","x_label":"over the tolerance","sources":["rings","time step"],)"
            R"("of_what":"of the tolerance","limit":1.0,)"
            R"("rows":[{"label":"first slip","shares":[0.25,0.5],"start":0.0,"bar":0.0},)"
            R"({"label":"force","shares":[0.0,0.125],"start":0.0,"bar":0.0}]})");
}

// From -2.1525 to 4.2 in 410 pixels: 0 is 138.93 from the left, 4 is 258.17 wide; the bar is about -2.
TEST(ShareBars, GoBothWaysFromWhereTheyStart) {
  const auto bars = share_bars("t", "x", {"more", "less"}, {{"a", {4, 0}}, {"b", {0, -6}, 4, 0.05}}, 0, "%");
  expect_parts(share_bars_svg(bars),
               {"x=\"348.93\" y=\"39.00\" width=\"258.17\"", "x=\"219.84\" y=\"69.00\" width=\"387.25\"",
                "x1=\"216.62\" x2=\"223.07\"", "x1=\"348.9\" x2=\"348.9\"", ">-2<"});
}

TEST(ShareBars, HaveRoomForABarThatIsTooWide) {
  const auto bars = share_bars("t", "x", {"rings"}, {{"a", {8}}});
  expect_parts(share_bars_svg(bars), {"width=\"390.48\"", ">8<"});
}

}  // namespace
}  // namespace fretval
