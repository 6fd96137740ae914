#include "comparison/support/escape.h"

#include <gtest/gtest.h>

namespace fretval {
namespace {

TEST(Escape, LeavesNoTagsAttributesOrEntities) {
  EXPECT_EQ(html_escaped("<a href=\"x\">&lt;</a> µ"), "&lt;a href=&quot;x&quot;&gt;&amp;lt;&lt;/a&gt; µ");
}

TEST(Escape, LeavesATerminalNothingToObey) {
  EXPECT_EQ(without_control_characters("a\x1b[2J\tb\x7f\r\nφ"), "a?[2J?b??\nφ");
}

}  // namespace
}  // namespace fretval
