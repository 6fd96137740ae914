#include "comparison/support/text.h"

#include <gtest/gtest.h>

namespace fretval::text_test {
namespace {

TEST(Closest, FindsWhatIsMistyped) {
  const std::vector<std::string> entries{"Radius", "Slope angle", "Coefficient", "Table"};
  EXPECT_EQ(closest("Radios", entries), "Radius");
  EXPECT_EQ(closest("radius", entries), "Radius");
  EXPECT_EQ(closest("Rdaius", entries), "Radius");
  EXPECT_EQ(closest("slope_angle", entries), "Slope angle");
  EXPECT_EQ(closest("Coeficient", entries), "Coefficient");
  EXPECT_EQ(did_you_mean("Tabel", entries), "; did you mean Table?");
}

TEST(Closest, IsNothingForAnotherWord) {
  EXPECT_EQ(closest("Width", {"Radius", "Table"}), "");
  EXPECT_EQ(closest("", {"Radius"}), "");
  EXPECT_EQ(closest(std::string(10000, 'x'), {"Radius"}), "");
  EXPECT_EQ(did_you_mean("Width", {"Radius"}), "");
}

// Two of six letters are a third, three are more.
TEST(Closest, EditsAThirdOfTheLetters) {
  EXPECT_EQ(closest("abcdxy", {"abcdef"}), "abcdef");
  EXPECT_EQ(closest("abcxyz", {"abcdef"}), "");
  EXPECT_EQ(closest("abcdex", {"abcdxy", "abcdef"}), "abcdef");
  EXPECT_EQ(closest("abcdex", {"abcdey", "abcdef"}), "abcdey") << "the first of equally near ones";
}

TEST(Closest, MayBeAskedForMore) {
  EXPECT_EQ(closest("Fase", {"Path", "Phase"}), "");
  EXPECT_EQ(closest("Fase", {"Path", "Phase"}, 0.4), "Phase");
  EXPECT_EQ(closest("phase", {"Phase"}, 0), "Phase");
}

TEST(Escape, LeavesNoTagsAttributesOrEntities) {
  EXPECT_EQ(html_escaped("<a href=\"x\">&lt;</a> µ"), "&lt;a href=&quot;x&quot;&gt;&amp;lt;&lt;/a&gt; µ");
}

TEST(Escape, LeavesATerminalNothingToObey) {
  EXPECT_EQ(without_control_characters("a\x1b[2J\tb\x7f\r\nφ"), "a?[2J?b??\nφ");
}

}  // namespace
}  // namespace fretval::text_test
