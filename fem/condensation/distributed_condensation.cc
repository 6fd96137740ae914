#include "fem/condensation/distributed_condensation.h"

#include <dmumps_c.h>
#include <mpi.h>

#include <algorithm>
#include <utility>

#include "fem/support/dense.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

bool is_first_process() {
  int number = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &number);
  return number == 0;
}

/// One factorisation by MUMPS of a sum of shares, with its Schur complement on the first process.
class DistributedFactor {
 public:
  DistributedFactor(const SparseMatrix& share, std::string name)
      : name_(std::move(name)), share_(share), first_(is_first_process()) {
    mumps_.comm_fortran = MPI_Comm_c2f(MPI_COMM_WORLD);
    mumps_.par = 1;
    constexpr int symmetric_indefinite = 2;
    mumps_.sym = symmetric_indefinite;
    call(-1);
    for (const int output : {1, 2, 3, 4}) icntl(output) = 0;
  }
  ~DistributedFactor() { call(-2); }
  DistributedFactor(const DistributedFactor&) = delete;
  DistributedFactor& operator=(const DistributedFactor&) = delete;

  void factorise(const std::vector<unsigned>& interface_dofs, const SpareMemory& spare) {
    take_share();
    choose_interface(interface_dofs);
    analyse_and_factorise(spare.first);
    if (needs_more_work_space(mumps_.infog[0])) analyse_and_factorise(spare.second);
    check("the factorisation");
    // The lower triangle by rows, as the manual has it: several processes leave other numbers in the upper one, larger
    // ones if there are many rings, so that fill_symmetric would take those.
    schur_.triangularView<Eigen::StrictlyLower>() = schur_.transpose();
  }

  /// The Schur complement on the first process; empty on the others.
  [[nodiscard]] const Eigen::MatrixXd& schur_complement() const { return schur_; }

  /// Throws SolverError unless one solve through the Schur complement gives an x with K x = rhs.
  void probe() {
    const Eigen::VectorXd load = probe_load(share_.n);
    Eigen::VectorXd x = load, reduced(schur_.rows());
    solve(1, x, reduced);
    if (first_)
      if (const auto factor = cholesky(schur_)) {
        solve_leading(*factor, reduced);
        factor->triangularView<Eigen::Lower>().transpose().solveInPlace(reduced);
      }
    solve(2, x, reduced);
    MPI_Bcast(x.data(), static_cast<int>(x.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
    Eigen::VectorXd force = multiply(share_, x);
    MPI_Allreduce(MPI_IN_PLACE, force.data(), static_cast<int>(force.size()), MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    const double residual = (force - load).norm() / load.norm();
    if (!(residual <= probe_tolerance)) throw SolverError(name_ + ": " + explain_residual(residual));
  }

 private:
  /// ICNTL(i) of MUMPS' manual, which counts from 1.
  int& icntl(int i) { return mumps_.icntl[i - 1]; }

  void call(int job) {
    mumps_.job = job;
    dmumps_c(&mumps_);
  }

  void take_share() {
    constexpr int distributed_entries = 3;
    icntl(18) = distributed_entries;
    mumps_.n = share_.n;
    for (int row = 0; row < share_.n; ++row)
      for (int k = share_.row_start[row]; k < share_.row_start[row + 1]; ++k)
        if (share_.values[k] != 0) {
          rows_.push_back(row + 1);
          columns_.push_back(share_.columns[k] + 1);
          values_.push_back(share_.values[k]);
        }
    mumps_.nnz_loc = static_cast<MUMPS_INT8>(values_.size());
    mumps_.irn_loc = rows_.data();
    mumps_.jcn_loc = columns_.data();
    mumps_.a_loc = values_.data();
  }

  void choose_interface(const std::vector<unsigned>& dofs) {
    constexpr int on_first_process = 1;
    icntl(19) = on_first_process;
    for (const unsigned dof : dofs) interface_.push_back(static_cast<int>(dof) + 1);
    mumps_.size_schur = static_cast<int>(interface_.size());
    mumps_.listvar_schur = interface_.data();
    if (!first_) return;
    schur_.setZero(mumps_.size_schur, mumps_.size_schur);
    mumps_.schur = schur_.data();
  }

  void analyse_and_factorise(int percent_spare) {
    icntl(14) = percent_spare;
    call(1);
    check("the analysis");
    call(2);
  }

  /// part: 1 condenses the right-hand side x to the interface, 2 extends what is known there to the solution x.
  void solve(int part, Eigen::VectorXd& x, Eigen::VectorXd& reduced) {
    icntl(26) = part;
    mumps_.nrhs = 1;
    mumps_.lrhs = share_.n;
    mumps_.lredrhs = mumps_.size_schur;
    mumps_.rhs = first_ ? x.data() : nullptr;
    mumps_.redrhs = first_ ? reduced.data() : nullptr;
    call(3);
    check("the solve");
  }

  void check(const char* step) const {
    if (mumps_.infog[0] < 0)
      throw SolverError(name_ + ": " + step + " failed: " + explain_mumps(mumps_.infog[0], mumps_.infog[1]));
  }

  std::string name_;
  const SparseMatrix& share_;
  bool first_;
  std::vector<int> rows_, columns_, interface_;  // MUMPS works on these
  std::vector<double> values_;
  Eigen::MatrixXd schur_;
  DMUMPS_STRUC_C mumps_{};
};

}  // namespace

Eigen::MatrixXd distributed_schur_complement(const SparseMatrix& share, const std::vector<unsigned>& interface_dofs,
                                             const std::string& name, const SpareMemory& spare) {
  const std::lock_guard<std::mutex> lock(mumps_mutex());
  DistributedFactor factor(share, name);
  factor.factorise(interface_dofs, spare);
  factor.probe();
  return factor.schur_complement();
}

}  // namespace fretval::fem
