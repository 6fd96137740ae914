#include "comparison/support/progress.h"

#include <gtest/gtest.h>

#include "comparison/support/log.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"

namespace fretval::progress_test {
namespace {

// A quarter takes 10 s, so the rest takes 30.
TEST(Progress, TellsTheTimeThatIsLeft) {
  EXPECT_EQ(progress_text({3, 12, 0, 0.25}, 10, 80), "[#######.......................] 3/12, 0:30 left");
  EXPECT_EQ(progress_text({0, 12}, 4, 80), "[..............................] 0/12, 0:04 so far");
  EXPECT_EQ(progress_text({12, 12, 2, 1}, 3725, 80), "[##############################] 12/12, in 1:02:05, 2 not good");
}

// An estimate stands in until something is done, as long as it is not over.
TEST(Progress, BeginsWithAnEstimate) {
  EXPECT_EQ(progress_text({0, 1, 0, 0, {}, 90}, 0, 80), "[..............................] 0/1, about 1:30 left");
  EXPECT_EQ(progress_text({0, 1, 0, 0, {}, 90}, 60, 80), "[..............................] 0/1, about 0:30 left");
  EXPECT_EQ(progress_text({0, 1, 0, 0, {}, 90}, 100, 80), "[..............................] 0/1, 1:40 so far");
  EXPECT_EQ(progress_text({0, 1, 0, 0.5, "a: 1 of 2", 90}, 20, 40), "[#####......] 0/1, 0:20 left; a: 1 of 2");
}

// A twentieth in 20 s, so 380 are left; 180 of the estimate, which weighs as much as a hundredth: a sixth.
TEST(Progress, GoesFromTheEstimateToWhatIsDone) {
  EXPECT_EQ(progress_text({1, 20, 0, 0.05, {}, 200}, 20, 80), "[#.............................] 1/20, about 5:47 left");
  EXPECT_EQ(progress_text({2, 20, 0, 0.1, {}, 200}, 40, 80), "[###...........................] 2/20, 6:00 left");
}

// Of ten thousand a hundred are a hundredth, and tell: 40 s, so 3960 are left. Of half of them 3980 are, and of the
// estimate, which weighs as much as ten, 8000.
TEST(Progress, BelievesAHundredParts) {
  EXPECT_EQ(progress_text({100, 10000, 0, 0.01, {}, 90000}, 40, 80),
            "[..............................] 100/10000, 1:06:00 left");
  EXPECT_EQ(progress_text({50, 10000, 0, 0.005, {}, 8020}, 20, 80),
            "[..............................] 50/10000, about 1:17:30 left");
}

// Of two parts one is done and the other to a quarter: 40 s for 5/8, so 24 are left.
TEST(Progress, CountsTheShareOfWhatIsUnderWay) {
  EXPECT_EQ(progress_text({1, 2, 0, 0.625, "cone: worn"}, 40, 80),
            "[##################............] 1/2, 0:24 left; cone: worn");
  EXPECT_EQ(progress_text({0, 1, 0, 0.001, "cone: worn"}, 4, 80),
            "[..............................] 0/1, 0:04 so far; cone: worn");
}

// The first part is a two hundredth of the whole, an hour, and weighs half as much as the estimate, the second one half
// of that; the last is as long as the mean of the others.
TEST(Progress, WeighsItsPartsInALog) {
  if (!log::tells()) log::start();
  testing::internal::CaptureStderr();
  {
    Progress progress(4, {{"short", 18}, {"shorter", 9}, {"long", 2673}});
    progress.done("short is done", true, "short");
    progress.done("shorter is done", true, "shorter");
    progress.done("long is done", true, "long");
    progress.done("unnamed is done");
  }
  const auto told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(told,
            "0/4; about 1:00:00 left\n1/4 short is done; about 40:00 left\n2/4 shorter is done; about 34:17 left\n"
            "3/4 long is done; 0:00 left\n4/4 unnamed is done; in 0:00\n");
}

TEST(Progress, FitsIntoTheLine) {
  for (int columns = 1; columns <= 120; ++columns)
    EXPECT_LT(progress_text({99, 522, 17, 0.5, "wear: 1e-3 from its limit"}, 54321, columns).size(),
              static_cast<std::size_t>(columns));
}

TEST(Progress, IsALineForEachCaseInALogAndNothingIfQuiet) {
  const ScratchFolder folder;
  const auto file = folder.write(
      "sweep.prm",
      elastic_case() + "subsection Sweep\n  set Entry = Accuracy / Rings per radius\n  set Values = 16, 24\nend\n");
  const auto arguments = quoted(file) + " --proof none -o " + quoted(folder.path() / "out");
  const auto told = fretval_run("run " + arguments, folder);
  EXPECT_NE(told.err.find("1/2 sweep/rings-per-radius-"), std::string::npos) << told.err;
  EXPECT_NE(told.err.find("2/2 sweep/rings-per-radius-"), std::string::npos) << told.err;
  EXPECT_EQ(fretval_run("--quiet run " + arguments, folder).err, "");
  EXPECT_EQ(fretval_run("run -q " + arguments, folder).err, "");
}

// A terminal of its own, made by script(1).
TEST(Progress, RedrawsALineOnATerminal) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", elastic_case());
  const auto command =
      std::string(FRETVAL_PROGRAM) + " run " + file.string() + " --proof none -o " + (folder.path() / "out").string();
  const auto run = shell_run("script -qec 'stty cols 60; " + command + "' /dev/null", folder);
  EXPECT_NE(run.out.find("\r\033[K[..............................] 0/1, about 0:0"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace fretval::progress_test
