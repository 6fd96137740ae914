#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

TEST(PeriodicRowsSlow, FailForAnotherFrictionAndIndenter) {
  expect_to_guard(periodic_rows, {{1, 0.404, 1.001}});
}

}  // namespace
}  // namespace fretval
