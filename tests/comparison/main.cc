#include <gtest/gtest.h>

#include "fem/condensation/petsc_session.h"
#include "tests/comparison/program_server.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/variable.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  fretval::start_program_server();
  // Programs that tests run do not touch the user's store; those of one test program share one.
  const fretval::ScratchFolder folder;
  const fretval::Variable store("FRETVAL_STORE", (folder.path() / "operators").string());
  const fretval::fem::PetscSession session;
  return RUN_ALL_TESTS();
}
