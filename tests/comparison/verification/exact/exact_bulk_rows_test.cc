#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

TEST(BulkRowsSlow, FailForAnotherForceThanKelvins) {
  const auto meshes = bulk_meshes(4);
  EXPECT_EQ(names_of(bulk_rows(meshes, 1), true), NamesOfRows{});
  const auto rows = bulk_rows(meshes, 1.001);
  EXPECT_EQ(names_of(rows, true), names_of(rows));
}

}  // namespace
}  // namespace fretval
