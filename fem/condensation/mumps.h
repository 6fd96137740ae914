#pragma once

#include <Eigen/Dense>
#include <mutex>
#include <string>

namespace fretval::fem {

// What all callers of MUMPS share.

/// Held by whoever calls PETSc or MUMPS: neither may be in two threads at once.
std::mutex& mumps_mutex();

/// Work space of a factorisation beyond MUMPS' own estimate, in percent: first, and in the second attempt where that
/// was too little.
struct SpareMemory {
  int first = 60;  ///< pivoting of the saddle point needs more than the default of 30
  int second = 400;
};

/// Whether INFOG(1) says that the work space was too small.
bool needs_more_work_space(int infog1);

/// Why MUMPS failed, in words, from its codes INFOG(1) < 0 and INFOG(2).
std::string explain_mumps(int infog1, int infog2);

/// Completes a symmetric matrix of which MUMPS has filled one triangle; which one depends on the storage order that it
/// was given.
void fill_symmetric(Eigen::MatrixXd& matrix);

/// A right-hand side that leaves no dof out, to try a factor with.
Eigen::VectorXd probe_load(Eigen::Index n);

/// Largest relative residual of a direct solve at which the factor counts as sound. Healthy matrices give 1e-13 on even
/// meshes and 4e-10 where cells span six decades in size, half of it after a refinement; a singular one gives 1e-2 or
/// more.
constexpr double probe_tolerance = 1e-8;
std::string explain_residual(double residual);

}  // namespace fretval::fem
