#include "comparison/report/text/table.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"

namespace fretval {
namespace {

Table small_table() {
  Cell first("a & b");
  first.details = "<file>\nof two lines";
  return {{"name", "n", "remark"}, {{first, bad_if(true, "–"), words_cell("x")}, {"c", bad_if(false, "20")}}};
}

TEST(Table, IsEscapedOnAPage) {
  expect_parts(
      rendered(filling_of(small_table())),
      {"aria-label=\"table: name\"",
       "<thead><tr><th scope=\"col\">name</th><th scope=\"col\">n</th><th scope=\"col\">remark</th></tr></thead>",
       "<tr><td><details><summary>a &amp; b</summary><pre>&lt;file&gt;\nof two lines</pre></details></td>"
       "<td class=\"bad-cell\">–</td><td class=\"words\">x</td></tr>",
       "<tr><td>c</td><td>20</td></tr>"});
}

TEST(Table, HasHeadsOfSomeRows) {
  expect_parts(rendered(filling_of(Table{{"name"}, {{head_cell("family")}}})), {"<td class=\"head\">family</td>"});
  const Table wide{{"name", "n"}, {{head_cell("a family of many")}, {"c", "20"}}};
  expect_parts(rendered(filling_of(wide)), {"<td class=\"head\" colspan=\"2\">a family of many</td>"});
  EXPECT_EQ(text_of(wide),
            "name   n\n"
            "a family of many\n"
            "c     20\n");
}

TEST(Table, IsAlignedOnATerminal) {
  EXPECT_EQ(text_of(small_table()),
            "name    n  remark\n"
            "a & b   –  x\n"
            "c      20\n");
}

TEST(Table, IsAlignedForReadersWithoutScripts) {
  auto labelled = small_table();
  labelled.label = "label";
  const Filling section{{"table", filling_of(small_table())}, {"parts", {filling_of(labelled)}}};
  const auto text = text_of(small_table()) + "\n";
  EXPECT_EQ(tables_text(section), text + "label\n" + text);
}

}  // namespace
}  // namespace fretval
