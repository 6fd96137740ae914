#include "fem/condensation/sparse_factor.h"

#include <fmt/format.h>
#include <petscmat.h>

#include <cmath>
#include <mutex>

#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

// Healthy matrices give 1e-13 on even meshes and 4e-10 where cells span six decades in size, half of it after a
// refinement; a singular one gives 1e-2 or more.
constexpr double probe_tolerance = 1e-8;

/// Neither PETSc nor MUMPS may be in two threads at once.
std::mutex& petsc_mutex() {
  static std::mutex mutex;
  return mutex;
}

void check(PetscErrorCode code, const std::string& name, const char* step) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  if (code == PETSC_ERR_MAT_LU_ZRPVT || code == PETSC_ERR_MAT_CH_ZRPVT)
    throw SolverError(name + ": " + step +
                      " failed: the matrix is singular; check the boundary conditions of the body");
  throw SolverError(name + ": " + step + " failed: " + (text ? text : "PETSc error " + std::to_string(code)));
}

void check_entries(const SparseMatrix& matrix, const std::string& name) {
  std::vector<bool> empty(static_cast<std::size_t>(matrix.n), true);
  for (int row = 0; row < matrix.n; ++row)
    for (int k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k) {
      if (!std::isfinite(matrix.values[k]))
        throw SolverError(name + ": the entry in row " + std::to_string(row) + ", column " +
                          std::to_string(matrix.columns[k]) + " is not finite");
      if (matrix.values[k] != 0) empty[row] = empty[matrix.columns[k]] = false;
    }
  for (int row = 0; row < matrix.n; ++row)
    if (empty[row]) throw SolverError(name + ": row " + std::to_string(row) + " is empty, so the matrix is singular");
}

bool has_full_diagonal(const SparseMatrix& matrix) {
  for (int row = 0; row < matrix.n; ++row)
    if (matrix.values[matrix.row_start[row]] == 0) return false;
  return true;
}

bool needs_more_work_space(int infog1) {
  return infog1 == -8 || infog1 == -9;
}

}  // namespace

std::string explain_mumps(int infog1, int infog2) {
  std::string codes = "MUMPS INFOG(1) = " + std::to_string(infog1) + ", INFOG(2) = " + std::to_string(infog2);
  switch (infog1) {
    case -6:
    case -10:
      return "the matrix is singular (" + codes + "); check the boundary conditions of the body";
    case -8:
    case -9:
      return "MUMPS' work space was too small, also after it was made larger (" + codes + "); use a coarser mesh";
    case -13:
    case -19:
      return "out of memory (" + codes + "); use a coarser mesh";
    default:
      return codes;
  }
}

class SparseFactor::Factored {
 public:
  Factored(SparseMatrix rows, const std::vector<unsigned>& interface_dofs, std::string name, const SpareMemory& spare)
      : rows_(std::move(rows)), name_(std::move(name)) {
    check_entries(rows_, name_);
    constexpr int block_size = 1;
    check(MatCreateSeqSBAIJWithArrays(PETSC_COMM_SELF, block_size, rows_.n, rows_.n, rows_.row_start.data(),
                                      rows_.columns.data(), rows_.values.data(), &matrix_.mat),
          name_, "creating the matrix");
    if (factorise(interface_dofs, spare.first)) return;
    MatDestroy(&factor_.mat);
    factorise(interface_dofs, spare.second);
    check_mumps("the factorisation");
  }

  [[nodiscard]] Eigen::MatrixXd schur_complement() const {
    const std::lock_guard<std::mutex> lock(petsc_mutex());
    OwnedMat owned;
    Mat& schur = owned.mat;
    check(MatFactorCreateSchurComplement(factor_.mat, &schur, nullptr), name_, "reading the Schur complement");
    PetscInt n = 0;
    const PetscScalar* entries = nullptr;
    MatGetSize(schur, &n, nullptr);
    MatDenseGetArrayRead(schur, &entries);
    Eigen::MatrixXd dense = Eigen::Map<const Eigen::MatrixXd>(entries, n, n);
    MatDenseRestoreArrayRead(schur, &entries);
    // For a symmetric factor MUMPS fills one triangle; which one depends on the storage order PETSc passes on.
    const double upper = dense.triangularView<Eigen::StrictlyUpper>().toDenseMatrix().norm();
    const double lower = dense.triangularView<Eigen::StrictlyLower>().toDenseMatrix().norm();
    if (upper > lower) dense.transposeInPlace();
    dense.triangularView<Eigen::StrictlyUpper>() = dense.transpose();
    if (!dense.allFinite()) throw SolverError(name_ + ": the Schur complement is not finite");
    return dense;
  }

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const {
    if (rhs.norm() == 0) return rhs;
    Eigen::VectorXd solution = back_substitute(rhs);
    solution += back_substitute(rhs - multiply(rows_, solution));  // one refinement: cells may span six decades in size
    check_solution(solution, rhs);
    return solution;
  }

  void probe() const {
    Eigen::VectorXd rhs(rows_.n);
    for (int i = 0; i < rows_.n; ++i) rhs[i] = std::sin(1.0 + 0.7 * i);
    check_solution(back_substitute(rhs), rhs);
  }

 private:
  /// A PETSc matrix that goes with its scope, also when the constructor around it throws.
  struct OwnedMat {
    Mat mat = nullptr;
    OwnedMat() = default;
    ~OwnedMat() { MatDestroy(&mat); }
    OwnedMat(const OwnedMat&) = delete;
    OwnedMat& operator=(const OwnedMat&) = delete;
  };

  void check_solution(const Eigen::VectorXd& solution, const Eigen::VectorXd& rhs) const {
    if (!solution.allFinite()) throw SolverError(name_ + ": the solution is not finite");
    const double residual = (multiply(rows_, solution) - rhs).norm() / rhs.norm();
    if (!(residual <= probe_tolerance))
      throw SolverError(
          fmt::format("{}: the matrix is singular or badly conditioned: relative residual {:.1e} after a direct "
                      "solve, at most {:.0e} expected",
                      name_, residual, probe_tolerance));
  }

  [[nodiscard]] Eigen::VectorXd back_substitute(const Eigen::VectorXd& rhs) const {
    const std::lock_guard<std::mutex> lock(petsc_mutex());
    Vec b = nullptr, x = nullptr;
    Eigen::VectorXd solution(rhs.size());
    VecCreateSeqWithArray(PETSC_COMM_SELF, 1, rows_.n, rhs.data(), &b);
    VecCreateSeqWithArray(PETSC_COMM_SELF, 1, rows_.n, solution.data(), &x);
    const PetscErrorCode code = MatSolve(factor_.mat, b, x);
    VecDestroy(&b);
    VecDestroy(&x);
    check(code, name_, "the solve");
    check_mumps("the solve");
    return solution;
  }

  /// False if the work space was too small.
  bool factorise(const std::vector<unsigned>& interface_dofs, int percent_spare) {
    check(MatGetFactor(matrix_.mat, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, &factor_.mat), name_, "setting up MUMPS");
    // METIS: half the flops of the default ordering on these meshes. With an interface MUMPS orders by itself instead.
    MatMumpsSetIcntl(factor_.mat, 7, 5);
    if (has_full_diagonal(rows_)) MatMumpsSetIcntl(factor_.mat, 8, 1);  // scaling by the diagonal: cheaper, as good
    MatMumpsSetIcntl(factor_.mat, 14, percent_spare);
    if (!interface_dofs.empty()) {
      const std::vector<PetscInt> indices(interface_dofs.begin(), interface_dofs.end());
      IS set = nullptr;
      ISCreateGeneral(PETSC_COMM_SELF, static_cast<PetscInt>(indices.size()), indices.data(), PETSC_COPY_VALUES, &set);
      const PetscErrorCode code = MatFactorSetSchurIS(factor_.mat, set);
      ISDestroy(&set);
      check(code, name_, "choosing the interface");
    }
    MatFactorInfo info;
    MatFactorInfoInitialize(&info);
    check(MatCholeskyFactorSymbolic(factor_.mat, matrix_.mat, nullptr, &info), name_, "the analysis");
    check_mumps("the analysis");
    check(MatCholeskyFactorNumeric(factor_.mat, matrix_.mat, &info), name_, "the factorisation");
    if (needs_more_work_space(infog(1))) return false;
    check_mumps("the factorisation");
    return true;
  }

  [[nodiscard]] int infog(int i) const {
    PetscInt value = 0;
    MatMumpsGetInfog(factor_.mat, i, &value);
    return static_cast<int>(value);
  }

  void check_mumps(const char* step) const {
    if (infog(1) < 0) throw SolverError(name_ + ": " + step + " failed: " + explain_mumps(infog(1), infog(2)));
  }

  SparseMatrix rows_;  // PETSc works on these arrays
  std::string name_;
  OwnedMat matrix_, factor_;
};

void SparseFactor::Release::operator()(Factored* factored) const {
  const std::lock_guard<std::mutex> lock(petsc_mutex());
  delete factored;
}

SparseFactor::SparseFactor(SparseMatrix matrix, std::string name)
    : SparseFactor(std::move(matrix), {}, std::move(name)) {}

SparseFactor::SparseFactor(SparseMatrix matrix, const std::vector<unsigned>& interface_dofs, std::string name,
                           const SpareMemory& spare) {
  const std::lock_guard<std::mutex> lock(petsc_mutex());
  factored_.reset(new Factored(std::move(matrix), interface_dofs, std::move(name), spare));
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

Eigen::MatrixXd SparseFactor::schur_complement() const {
  return factored_->schur_complement();
}

void SparseFactor::probe() const {
  factored_->probe();
}

Eigen::VectorXd SparseFactor::solve(const Eigen::VectorXd& rhs) const {
  return factored_->solve(rhs);
}

}  // namespace fretval::fem
