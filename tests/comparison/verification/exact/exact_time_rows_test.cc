#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

const ExactScene other_branch{1, 0.4, 1, mdr::standard_solid(1, 2, 0.404)};

TEST(RelaxationRowsSlow, FailForAnotherBranch) {
  expect_to_guard(relaxation_rows, {other_branch});
}

TEST(PressingRowsSlow, FailForAnotherBranch) {
  expect_to_guard(pressing_rows, {other_branch});
}

}  // namespace
}  // namespace fretval
