#include "comparison/report/text/page.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"

namespace fretval::page_test {
namespace {

const Filling table{{"template", "table"}, {"label", "a \"b\" <c>"}, {"heads", {"<i>"}}};

TEST(Page, EscapesTextForWhereItStands) {
  const auto html = rendered({{"template", "exact"}, {"passed", "<b> & \"c\""}, {"table", table}});
  expect_parts(html, {"&lt;b&gt; &amp; &quot;c&quot;", "aria-label=\"table: a &quot;b&quot; &lt;c&gt;\"",
                      "<th scope=\"col\">&lt;i&gt;</th>"});
}

// Whatever a case file has: no text ends the element that it stands in.
TEST(Page, HasNoHtmlOfItsTexts) {
  const std::string attack = "</script></title></noscript><script>alert(1)</script><!--";
  const auto page = page_of(attack, attack, {{"heading", nullptr}, {"sections", {attack}}});
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_EQ(page.find("</noscript><script>"), std::string::npos);
  expect_parts(page, {"<title>&lt;/script&gt;", "<noscript><pre>&lt;/script&gt;", "\\u003c/noscript>"});
}

TEST(Page, ShowsNothingWithoutASection) {
  EXPECT_EQ(rendered(nullptr), "");
}

TEST(Page, ShowsWhatIsBetweenTheMarkersOfATextUnlessItIsEmpty) {
  Filling section{{"template", "radii"}, {"cases", "1 case"}, {"where", ""}};
  EXPECT_EQ(rendered(section).find("away from the first-slip radius"), std::string::npos);
  section["where"] = "here";
  expect_parts(rendered(section), {"away from the first-slip radius (here)"});
}

TEST(Page, HasFormulasAsText) {
  const auto html = rendered({{"template", "cost"}});
  EXPECT_EQ(html.find("\\("), std::string::npos);
  expect_parts(html, {"class=\"katex\""});
}

// It asks for nothing at the network.
TEST(Page, IsWhole) {
  const auto page = page_of("", "", nullptr);
  EXPECT_GT(page.size(), 300000U);
  EXPECT_EQ(page_pieces().back().substr(page_pieces().back().size() - 8), "</html>\n");
  for (const char* part : {"url(fonts", "src=\"http", "{{katex.css}}", "{{report.css}}", "{{sections.js}}"})
    EXPECT_EQ(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace fretval::page_test
