#include <gtest/gtest.h>

#include "comparison/case/case.h"
#include "comparison/command_line/verbs.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
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

// On a layer twice as thick as its contact radius MDR has that radius too large by more than a twentieth.
TEST(TrustCommand, ExitsWith1WhereMdrIsOffByMoreThanIsAllowed) {
  const ScratchFolder folder;
  auto text = replace(elastic_case(), "Tangential amplitude = 1.5e-5", "Tangential amplitude = 0");
  text += "subsection Body\n  set Shape = layer\n  set Thickness = 2e-3\n  set Base = bonded\nend\n";
  const auto file = quoted(folder.write("case.prm", text));
  const auto strict = fretval_run("trust " + file + " --at-most '5 %'", folder),
             loose = fretval_run("trust " + file + " --at-most 0.5", folder);
  EXPECT_EQ(strict.exit_code, 1) << strict.err;
  expect_parts(strict.err, {"MDR is off by more than 5 %: ", "largest contact radius"});
  EXPECT_EQ(loose.exit_code, 0) << loose.err;
}

}  // namespace
}  // namespace fretval::trust_command_test
