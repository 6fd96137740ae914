#include "comparison/command_line/ending.h"

#include <gtest/gtest.h>

#include <csignal>
#include <new>
#include <stdexcept>
#include <system_error>

#include "comparison/case/case.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"

namespace fretval::ending_test {
namespace {

template <class Error>
int exit_code_of(const Error& error) {
  return say_failure(std::make_exception_ptr(error));
}

TEST(Failure, HasTheExitCodeOfItsKind) {
  EXPECT_EQ(exit_code_of(InputError("x")), exit_bad_input);
  EXPECT_EQ(exit_code_of(meshes::MeshError("x")), exit_bad_input);
  EXPECT_EQ(exit_code_of(fem::SolverError("x")), exit_numerics_failed);
  EXPECT_EQ(exit_code_of(std::runtime_error("x")), exit_numerics_failed);
  EXPECT_EQ(exit_code_of(std::system_error(ENOSPC, std::generic_category())), exit_system_failed);
  EXPECT_EQ(exit_code_of(std::bad_alloc()), exit_system_failed);
  EXPECT_EQ(exit_code_of(std::logic_error("x")), exit_system_failed);
  EXPECT_EQ(end_with_failure(std::make_exception_ptr(InputError("x"))), exit_bad_input);
}

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
  const auto file = folder.write(
      "sweep.prm", valid_case + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:0.36:180\nend\n");
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
}  // namespace fretval::ending_test
