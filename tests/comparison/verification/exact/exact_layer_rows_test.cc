#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

Rows rows_on_64_rings(const Meshes&, const ExactScene& exact) {
  return layer_rows({64}, exact);
}

// Rows of the thinnest layers are tolerant enough to let an indenter pass that is steeper by 0.1 %, and of layers against their limits of infinitely thin ones a modulus of 1 % more.
TEST(LayerRowsSlow, FailForAnotherModulusFrictionOrIndenter) {
  expect_to_guard(rows_on_64_rings, {{1.01}, {1.03}, {1, 0.41}, {1, 0.4, 1.01}});
}

}  // namespace
}  // namespace fretval
