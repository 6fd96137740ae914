#include <gtest/gtest.h>

#include "comparison/case/case.h"
#include "comparison/command_line/verbs.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::trust_command_test {
namespace {

TEST(TrustCommand, ReadsShares) {
  EXPECT_DOUBLE_EQ(share_of("5 %"), 0.05);
  EXPECT_DOUBLE_EQ(share_of("5%"), 0.05);
  EXPECT_DOUBLE_EQ(share_of("0.05"), 0.05);
  for (const char* bad : {"", "five", "-1 %", "5 mm", "nan"}) EXPECT_THROW(share_of(bad), InputError) << bad;
}

TEST(TrustCommand, NeedsACaseOrAMap) {
  const ScratchFolder folder;
  const auto neither = fretval_run("trust", folder), both = fretval_run("trust case.prm --map map.csv", folder);
  EXPECT_EQ(neither.exit_code, 2);
  expect_parts(neither.err, {"case or --map"});
  EXPECT_EQ(both.exit_code, 2);
}

}  // namespace
}  // namespace fretval::trust_command_test
