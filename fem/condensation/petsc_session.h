#pragma once

namespace fretval::fem {

/// Starts PETSc (and MPI) for the lifetime of the object; `main` holds one while finite elements run.
/// PETSc's own error printing and signal handlers are off: failures surface as exceptions. MPI that is running already
/// is left running.
class PetscSession {
 public:
  PetscSession();
  ~PetscSession();
  PetscSession(const PetscSession&) = delete;
  PetscSession& operator=(const PetscSession&) = delete;
};

}  // namespace fretval::fem
