#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

TEST(WornEdgeRows, FailForAnotherIndenter) {
  expect_to_guard(worn_edge_rows, {{1, 0.4, 1.001}});
}

}  // namespace
}  // namespace fretval
