#include "comparison/case/prm_text.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/refusal.h"

namespace fretval::prm_text_test {
namespace {

TEST(PrmText, LosesCommentsAndKeepsLineNumbers) {
  Problems problems;
  const auto prm = read_prm("subsection Friction # one\n\n  set Coefficient \\\n = 0.5\nend\n", "a.prm", problems);
  EXPECT_EQ(prm.text, "subsection Friction\n\n\nset Coefficient = 0.5\nend\n");
  EXPECT_TRUE(prm.included.empty());
  EXPECT_TRUE(problems.messages.empty());
}

TEST(PrmText, LosesWhatThereIsNotAndSaysSo) {
  Problems problems;
  const auto prm = read_prm(
      "subsection Fiction\n  set Coefficient = 1\nend\nsubsection Wear\n  set Speed = 1\n  set Cycles = 2\nend\n",
      "a.prm", problems);
  EXPECT_EQ(prm.text, "\n\n\nsubsection Wear\n\nset Cycles = 2\nend\n");
  ASSERT_EQ(problems.messages.size(), 2U);
  expect_parts(problems.messages[0], {"a.prm: line 1: subsection Fiction", "did you mean Friction?"});
  expect_parts(problems.messages[1], {"a.prm: line 5: Wear / Speed: no such entry"});
}

TEST(PrmText, IsRefusedWithAnEntryTwice) {
  Problems problems;
  expect_parts(refusal([&] { read_prm("subsection Wear\nset Cycles = 1\nset Cycles = 2\nend\n", "a.prm", problems); }),
               {"a.prm: line 3", "first in line 2"});
}

}  // namespace
}  // namespace fretval::prm_text_test
