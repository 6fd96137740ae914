#include "comparison/command_line/failure.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <system_error>

#include "comparison/case/case.h"
#include "comparison/command_line/exit_codes.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"

namespace fretval::failure_test {
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

}  // namespace
}  // namespace fretval::failure_test
