#include "comparison/case_file/problems.h"

#include <gtest/gtest.h>

#include "tests/comparison/refusal.h"

namespace fretval {
namespace {

TEST(Problems, AreThrownTogetherEachOnce) {
  Problems problems;
  EXPECT_NO_THROW(problems.throw_if_any());
  problems.add("one");
  problems.add("two");
  problems.add("one");
  EXPECT_EQ(refusal([&] { problems.throw_if_any(); }), "one\ntwo");
}

}  // namespace
}  // namespace fretval
