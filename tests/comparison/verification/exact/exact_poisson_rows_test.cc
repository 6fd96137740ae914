#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

Rows poisson_rows_on_64_rings(const Meshes&, const ExactScene& exact) {
  return poisson_rows({64}, exact);
}

TEST(PoissonRowsSlow, FailForAnotherModulusFrictionOrIndenter) {
  expect_to_guard(poisson_rows_on_64_rings, {{1.01}, {1, 0.41}, {1, 0.4, 1.01}});
}

}  // namespace
}  // namespace fretval
