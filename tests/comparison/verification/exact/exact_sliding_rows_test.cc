#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

TEST(SlidingRowsSlow, FailForAnotherFriction) {
  expect_to_guard(sliding_rows, {{1, 0.404}});
}

TEST(ObliqueRowsSlow, FailForAnotherFriction) {
  expect_to_guard(oblique_rows, {{1, 0.404}});
}

}  // namespace
}  // namespace fretval
