#include "comparison/report/drawing/share_bars.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace fretval
