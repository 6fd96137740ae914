#include "fem/petsc_session.h"

#include <petscsys.h>

#include "fem/solver_error.h"

namespace fretval::fem {

PetscSession::PetscSession() {
  if (PetscInitializeNoArguments() != 0) throw SolverError("PETSc could not be started");
  PetscPopSignalHandler();
  PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr);
}

PetscSession::~PetscSession() {
  PetscPopErrorHandler();
  PetscFinalize();
}

}  // namespace fretval::fem
