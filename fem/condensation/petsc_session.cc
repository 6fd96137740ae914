#include "fem/condensation/petsc_session.h"

#include <cblas.h>
#include <petscsys.h>

#include <cstdlib>

#include "fem/support/solver_error.h"

namespace fretval::fem {

PetscSession::PetscSession() {
  // A single process would start a daemon of Open MPI, 0.2 s, which only programs that spawn others need.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
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
