#include "fem/condensation/petsc_session.h"

#include <cblas.h>
#include <petscsys.h>

#include <cstdlib>
#include <exception>

#include "fem/support/processes.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

/// Leaves out Open MPI's daemon for programs that spawn others, and its search for networks: 0.2 s each.
void leave_out_what_one_process_does_not_need() {
  constexpr int keep = 0;  // what the user has set
  setenv("OMPI_MCA_ess_singleton_isolated", "1", keep);
  setenv("OMPI_MCA_pml", "ob1", keep);
  setenv("OMPI_MCA_btl", "self", keep);
}

}  // namespace

PetscSession::PetscSession() {
  if (!is_started_by_mpirun()) leave_out_what_one_process_does_not_need();
  if (PetscInitializeNoArguments() != 0) throw SolverError("PETSc could not be started");
  // Dense blocks are small and cases run in parallel: threads inside BLAS would only get in the way.
  openblas_set_num_threads(1);
  PetscPopSignalHandler();
  PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr);
}

PetscSession::~PetscSession() {
  // After an error PetscFinalize would wait for the other processes, which do not know of it.
  if (this_process().count > 1 && std::uncaught_exceptions() > 0) return;
  PetscPopErrorHandler();
  PetscFinalize();
}

}  // namespace fretval::fem
