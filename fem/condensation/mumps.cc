#include "fem/condensation/mumps.h"

#include <fmt/format.h>

#include <cmath>

namespace fretval::fem {

std::mutex& mumps_mutex() {
  static std::mutex mutex;
  return mutex;
}

bool needs_more_work_space(int infog1) {
  return infog1 == -8 || infog1 == -9;
}

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

void fill_symmetric(Eigen::MatrixXd& matrix) {
  const double upper = matrix.triangularView<Eigen::StrictlyUpper>().toDenseMatrix().norm();
  const double lower = matrix.triangularView<Eigen::StrictlyLower>().toDenseMatrix().norm();
  if (upper > lower) matrix.transposeInPlace();
  matrix.triangularView<Eigen::StrictlyUpper>() = matrix.transpose();
}

Eigen::VectorXd probe_load(Eigen::Index n) {
  Eigen::VectorXd load(n);
  for (Eigen::Index i = 0; i < n; ++i) load[i] = std::sin(1.0 + 0.7 * static_cast<double>(i));
  return load;
}

std::string explain_residual(double residual) {
  return fmt::format(
      "the matrix is singular or badly conditioned: relative residual {:.1e} after a direct solve, at most {:.0e} "
      "expected",
      residual, probe_tolerance);
}

}  // namespace fretval::fem
