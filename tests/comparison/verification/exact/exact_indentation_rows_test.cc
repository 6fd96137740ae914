#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

TEST(IndentationRows, FailForAnotherModulusOrIndenter) {
  expect_to_guard(indentation_rows, {{1.01}, {1, 0.4, 1.001}});
}

}  // namespace
}  // namespace fretval
