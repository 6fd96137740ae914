#include "comparison/command_line/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

TEST(InterruptDeathTest, SaysTheLastMessageAndEndsByTheSignal) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        say_on_interrupt("nothing is kept");
        say_on_interrupt("all is kept in out");
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "\nall is kept in out\n");
}

// mpirun and batch systems end a program so.
TEST(InterruptDeathTest, SaysItWhenItIsTerminatedToo) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        say_on_interrupt("all is kept");
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "\nall is kept\n");
}

// 500 cases take longer than the first of them, after which it is ended.
TEST(Interrupt, OfARunSaysWhatIsKept) {
  const ScratchFolder folder;
  const auto file = folder.write("sweep.prm", valid_case +
                                                  "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = "
                                                  "0:0.36:180\nend\n");
  const auto out = folder.path() / "out";
  const auto run = shell_run(std::string(FRETVAL_PROGRAM) + " run " + quoted(file) + " -o " + quoted(out) + " & " +
                                 "while kill -0 $! && ! ls " + quoted(out) +
                                 "/*/*/result.json; do sleep 0.05; done 2>/dev/null; " + "kill -INT $!; wait $!",
                             folder);
  EXPECT_NE(run.exit_code, 0);
  expect_parts(run.err, {"\ninterrupted: ", " of 501 cases kept in " + out.string()});
}

// There is nothing that a report could show.
TEST(Interrupt, OfARunThatHasNothingYetSaysSo) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", replace(valid_case, "Tolerance = 0.01", "Tolerance = 1e-4"));
  const auto out = folder.path() / "out";
  const auto run = shell_run(std::string(FRETVAL_PROGRAM) + " run " + quoted(file) + " --no-store -o " + quoted(out) +
                                 " & while kill -0 $! && ! ls " + quoted(out) +
                                 "; do sleep 0.01; done 2>/dev/null; kill -INT $!; wait $!",
                             folder);
  EXPECT_NE(run.exit_code, 0);
  expect_parts(run.err, {"\ninterrupted: no case is done\n"});
}

}  // namespace
}  // namespace fretval
