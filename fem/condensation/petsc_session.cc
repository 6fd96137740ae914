#include "fem/condensation/petsc_session.h"

#include <cblas.h>
#include <petscsys.h>

#include "fem/support/solver_error.h"

namespace fretval::fem {

PetscSession::PetscSession() {
  if (PetscInitializeNoArguments() != 0) throw SolverError("PETSc could not be started");
  // Dense blocks are small and cases run in parallel: threads inside BLAS would only get in the way.
  openblas_set_num_threads(1);
  PetscPopSignalHandler();
  PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr);
}

PetscSession::~PetscSession() {
  PetscPopErrorHandler();
  PetscFinalize();
}

}  // namespace fretval::fem
