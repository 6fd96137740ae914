#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "fem/condensation/mumps.h"
#include "fem/operators/sparse_matrix.h"

namespace fretval::fem {

/// The Schur complement `S = K_cc - K_ci K_ii^{-1} K_ic` of a matrix that is too large for one process, on the
/// interface dofs c: K is the sum of the shares that the processes hold, which MUMPS factorises together. No process
/// ever has all of K, and only MUMPS sends entries of it; it adds up rows to which several shares contribute.
///
/// All processes that MPI has started call it at the same time, each with its share; the number of dofs, the interface
/// and the name are the same for all. The first process gets S, in the order of interface_dofs, equal to that of
/// Condensation but for roundoff; the others get an empty matrix.
///
/// Every failure is a SolverError that names the matrix, in all processes alike: MUMPS' INFOG codes, a singular matrix,
/// entries that are not finite, and a solution of the whole system through S with this factor whose true residual is
/// above probe_tolerance (as where S is not positive definite). A work space that turns out too small is made larger,
/// once. MUMPS is called directly, as PETSc's interface has the Schur complement for one process alone.
Eigen::MatrixXd distributed_schur_complement(const SparseMatrix& share, const std::vector<unsigned>& interface_dofs,
                                             const std::string& name, const SpareMemory& spare = {});

}  // namespace fretval::fem
