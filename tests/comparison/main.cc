#include <gtest/gtest.h>

#include "fem/condensation/petsc_session.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const fretval::fem::PetscSession session;
  return RUN_ALL_TESTS();
}
