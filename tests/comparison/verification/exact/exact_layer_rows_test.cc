#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

Rows rows_on_64_rings(const Meshes&, const ExactScene& exact) {
  return layer_rows({64}, exact);
}

// Rows of the thinnest layers are tolerant enough to let an indenter pass that is steeper by 0.1 %, and of layers
// against their limits of infinitely thin ones a modulus of 1 % more.
TEST(LayerRowsSlow, FailForAnotherModulusFrictionOrIndenter) {
  expect_to_guard(rows_on_64_rings, {{1.01}, {1.03}, {1, 0.41}, {1, 0.4, 1.01}});
}

TEST(LayerRowsSlow, AreCalledByTheContactRadiusOverTheThickness) {
  const auto names = names_of(layer_rows({8}, {}));
  for (const char* name : {"layer a/H = 0.1, ν = 0.5", "layer a/H = 0.5, ν = 0.45", "layer a/H = 4, ν = 0.5",
                           "layer a/H = 1, ν = 0.5, sliding"})
    EXPECT_EQ(names.count(std::string(name) + ": force"), 1U) << name;
}

}  // namespace
}  // namespace fretval
