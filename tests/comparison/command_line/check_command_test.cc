#include "comparison/command_line/check_command.h"

#include <gtest/gtest.h>

#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

TEST(CheckCommand, TellsDisagreementFromAnAnswerThatIsMissing) {
  EXPECT_EQ(exit_code_of(run_of({row_of(1e-3, 2e-3), row_of(1e-3, 2e-2), refused_row("a", "a b")})), 0);
  EXPECT_EQ(exit_code_of(run_of({row_of(3e-3, 2e-3)})), 1);
  EXPECT_EQ(exit_code_of(run_of({refused_row("a", "")})), 1);
  EXPECT_EQ(exit_code_of(run_of({refused_row("a", "b")})), 1);
  EXPECT_EQ(exit_code_of(run_of({row_of(1e-3, 2e-3), refused_row("", "singular")})), 3);
  auto broken = row_of(1e-3, 2e-3);
  broken.failure = "out of memory";
  EXPECT_EQ(exit_code_of(run_of({broken})), 3);
}

}  // namespace
}  // namespace fretval
