#include "mdr/support/trimmed.h"

#include <gtest/gtest.h>

namespace fretval {
namespace {

TEST(Trimmed, HasNoBlanksAtEitherEnd) {
  EXPECT_EQ(trimmed(" \ta b\t\r"), "a b");
  EXPECT_EQ(trimmed("a"), "a");
  EXPECT_EQ(trimmed(" \t "), "");
  EXPECT_EQ(trimmed(""), "");
}

}  // namespace
}  // namespace fretval
