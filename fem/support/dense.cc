#include "fem/support/dense.h"

#include <cblas.h>
#include <f77blas.h>

namespace fretval::fem {

std::optional<Eigen::MatrixXd> cholesky(Eigen::MatrixXd matrix) {
  char lower = 'L';
  blasint n = static_cast<blasint>(matrix.rows()), info = 0;
  BLASFUNC(dpotrf)(&lower, &n, matrix.data(), &n, &info);
  if (info != 0) return std::nullopt;
  matrix.triangularView<Eigen::StrictlyUpper>().setZero();
  return matrix;
}

Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& lower, Eigen::MatrixXd rhs) {
  const auto n = static_cast<blasint>(lower.rows());
  cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, n, static_cast<blasint>(rhs.cols()), 1,
              lower.data(), n, rhs.data(), n);
  return rhs;
}

Eigen::MatrixXd gram(const Eigen::MatrixXd& half) {
  const auto n = static_cast<blasint>(half.cols()), k = static_cast<blasint>(half.rows());
  Eigen::MatrixXd product(n, n);
  cblas_dsyrk(CblasColMajor, CblasLower, CblasTrans, n, k, 1, half.data(), k, 0, product.data(), n);
  product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
  return product;
}

}  // namespace fretval::fem
