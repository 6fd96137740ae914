#include "fem/condensation/petsc_session.h"

#include <cblas.h>
#include <gtest/gtest.h>
#include <petscsys.h>

namespace fretval::fem::petsc_session_test {
namespace {

// The session is the one that all tests run in.
TEST(PetscSession, HandsErrorsBackWithoutPrintingThem) {
  testing::internal::CaptureStderr();
  const PetscErrorCode error =
      PetscError(PETSC_COMM_SELF, __LINE__, "test", __FILE__, PETSC_ERR_USER, PETSC_ERROR_INITIAL, "on purpose");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(error, PETSC_ERR_USER);
}

TEST(PetscSession, KeepsDenseBlocksToOneThread) {
  EXPECT_EQ(openblas_get_num_threads(), 1);
}

}  // namespace
}  // namespace fretval::fem::petsc_session_test
