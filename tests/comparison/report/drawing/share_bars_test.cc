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

// From -2.1 to 4.2 in 410 pixels: 0 is 136.67 from the left, 4 is 260.32 wide.
TEST(ShareBars, GoBothWaysFromWhereTheyStart) {
  const auto bars = share_bars("t", "x", {"more", "less"}, {{"a", {4, 0}}, {"b", {0, -6}, 4, 0}}, 0, "%");
  expect_parts(share_bars_svg(bars),
               {"x=\"346.67\" y=\"39.00\" width=\"260.32\"", "x=\"216.51\" y=\"69.00\" width=\"390.48\"",
                "x1=\"346.7\" x2=\"346.7\"", ">-2<"});
}

// 410 pixels are 1.05, so a share of 1/4 is 97.62 wide, and the next one begins where it ends.
TEST(ShareBars, AreDrawnWhereScriptsAreOff) {
  const auto bars = two_rows();
  const auto svg = svgs({&bars}).front();
  expect_parts(svg, {"aria-label=\"Error &lt;budget&gt;\"", ">rings<", ">time step<", ">first slip<", ">force<",
                     "over the tolerance", "x=\"210.00\" y=\"39.00\" width=\"97.62\" height=\"16.00\" fill=\"#0072b2\"",
                     "x=\"307.62\" y=\"39.00\" width=\"195.24\" height=\"16.00\" fill=\"#d55e00\"",
                     "x1=\"600.5\" x2=\"600.5\""});
}

TEST(ShareBars, HaveRoomForABarThatIsTooWide) {
  const auto bars = share_bars("t", "x", {"rings"}, {{"a", {8}}});
  expect_parts(share_bars_svg(bars), {"width=\"390.48\"", ">8<"});
}

}  // namespace
}  // namespace fretval
