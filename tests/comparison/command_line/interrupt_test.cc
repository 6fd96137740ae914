#include "comparison/command_line/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>

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
  EXPECT_NE(run.err.find("interrupted: the cases that are done are kept in " + out.string()), std::string::npos)
      << run.err;
}

}  // namespace
}  // namespace fretval
