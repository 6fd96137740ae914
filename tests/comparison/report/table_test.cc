#include "comparison/report/table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace fretval {
namespace {

Table small_table() {
  Cell first("a & b");
  first.details = "<file>";
  return {{"name", "n", "remark"}, {{first, bad_if(true, "–"), words_cell("x")}, {"c", bad_if(false, "20")}}};
}

TEST(Table, IsEscapedOnAPage) {
  EXPECT_EQ(html_of(small_table()),
            "<div class=\"scroll\"><table><thead><tr><th>name</th><th>n</th><th>remark</th></tr></thead><tbody>\n"
            "<tr><td><details><summary>a &amp; b</summary><pre>&lt;file&gt;</pre></details></td>"
            "<td class=\"bad-cell\">–</td><td class=\"words\">x</td></tr>\n"
            "<tr><td>c</td><td>20</td></tr>\n</tbody></table></div>\n");
}

TEST(Table, IsAlignedOnATerminal) {
  EXPECT_EQ(text_of(small_table()),
            "name    n  remark\n"
            "a & b   –  x\n"
            "c      20\n");
}

TEST(NumberText, IsADashForWhatIsNoFiniteNumber) {
  EXPECT_EQ(number_text(1.25e-3), "1.3e-03");
  EXPECT_EQ(number_text(2, "{:g}"), "2");
  for (const nlohmann::ordered_json& none : {nlohmann::ordered_json(nullptr), nlohmann::ordered_json(std::nan(""))})
    EXPECT_EQ(number_text(none), "–");
}

}  // namespace
}  // namespace fretval
