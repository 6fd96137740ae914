#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

TEST(IndentationRows, PassAndFailForAnotherModulusOrIndenter) {
  EXPECT_EQ(names_of(indentation_rows(goal_mesh(), {}), true), NamesOfRows{});
  expect_to_guard(indentation_rows, {{1.01}, {1, 0.4, 1.001}});
}

}  // namespace
}  // namespace fretval
