#include "comparison/report/text/render.h"

#include <gtest/gtest.h>

#include "comparison/report/text/resources.h"
#include "tests/comparison/expect_parts.h"

namespace fretval {
namespace {

const Filling table{{"template", "table"}, {"label", "a \"b\" <c>"}, {"heads", {"<i>"}}};

TEST(Rendered, EscapesTextForWhereItStands) {
  const auto html = rendered({{"template", "exact"}, {"passed", "<b> & \"c\""}, {"table", table}});
  expect_parts(html, {"&lt;b&gt; &amp; &quot;c&quot;", "aria-label=\"table: a &quot;b&quot; &lt;c&gt;\"",
                      "<th scope=\"col\">&lt;i&gt;</th>"});
}

TEST(Rendered, IsNothingWithoutASectionAndThrowsWithoutItsTemplate) {
  EXPECT_EQ(rendered(nullptr), "");
  EXPECT_THROW(rendered({{"template", "there is none"}}), std::runtime_error);
}

TEST(Rendered, ShowsWhatIsBetweenTheMarkersOfATextUnlessItIsEmpty) {
  Filling section{{"template", "radii"}, {"cases", "1 case"}, {"where", ""}};
  EXPECT_EQ(rendered(section).find("away from the first-slip radius"), std::string::npos);
  section["where"] = "here";
  expect_parts(rendered(section), {"away from the first-slip radius (here)"});
}

// A page asks for nothing at the network, and formulas have become text.
TEST(Resources, AreWhole) {
  for (const char* name : {"page.html", "report.css", "report.js", "d3.js", "katex.css"})
    EXPECT_FALSE(resources().at(name).empty()) << name;
  EXPECT_EQ(resources().at("katex.css").find("url(fonts"), std::string_view::npos);
  for (const auto& [name, text] : resources()) {
    EXPECT_EQ(text.find("\\("), name == "d3.js" ? text.find("\\(") : std::string_view::npos) << name;
    EXPECT_EQ(text.find("src=\"http"), std::string_view::npos) << name;
  }
}

}  // namespace
}  // namespace fretval
