#include <gtest/gtest.h>

#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

TEST(Program, SaysWhenTheOutputCannotBeWritten) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto blocker = folder.write("blocker", "a file where a folder should be");
  EXPECT_EQ(fretval_run("run " + file.string() + " -o " + (blocker / "out").string(), folder).exit_code, 4);
}

}  // namespace
}  // namespace fretval
