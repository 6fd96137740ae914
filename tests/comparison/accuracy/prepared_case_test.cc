#include "comparison/accuracy/prepared_case.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

TEST(PreparedCase, OfOneNameIsRefused) {
  expect_parts(refusal([] { prepare({read_case(), read_case()}); }), {"case.prm", "a case named case"});
}

// What the reference throws knows no file.
TEST(PreparedCase, NamesTheFileOfAValueThatOnlyTheReferenceRefuses) {
  auto scene = read_case();
  scene.indenter.radius = -1;
  expect_parts(refusal([&] { prepare({scene}); }), {"case.prm: ", "radius"});
}

TEST(PreparedCase, KeepsTheWarningsOfItsFile) {
  auto scene = read_case(replace(valid_case, "modulus = 1e6", "modulus = 1"));
  scene.warnings = {"of the table"};
  const auto warnings = prepare({scene}).front().input.warnings;
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0], "of the table");
}

}  // namespace
}  // namespace fretval
