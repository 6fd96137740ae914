#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

Rows rows_on_64_rings(const Meshes&, const ExactScene& exact) {
  return layer_rows({64}, exact);
}

TEST(LayerRows, PassAndFailForAnotherModulusFrictionOrIndenter) {
  EXPECT_EQ(names_of(rows_on_64_rings({}, {}), true), NamesOfRows{});
  expect_to_guard(rows_on_64_rings, {{1.01}, {1, 0.41}, {1, 0.4, 1.001}});
}

}  // namespace
}  // namespace fretval
