#include "tests/comparison/exact_guards.h"

namespace fretval {
namespace {

TEST(BulkRowsSlow, FailForAnotherForceThanKelvins) {
  const auto rows = bulk_rows(bulk_meshes(4), 1.001);
  EXPECT_EQ(names_of(rows, true), names_of(rows));
}

}  // namespace
}  // namespace fretval
