#include <gtest/gtest.h>

#include <string>

#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

TEST(Program, SaysItsVersionAndThoseOfItsLibraries) {
  const ScratchFolder folder;
  const auto run = shell_run(FRETVAL_PROGRAM " --version", folder);
  EXPECT_EQ(run.exit_code, 0);
  for (const char* name : {"fretval", "deal.II", "PETSc", "MUMPS", "gmsh", "Eigen"})
    EXPECT_NE(run.out.find(name), std::string::npos) << run.out;
}

}  // namespace
}  // namespace fretval
