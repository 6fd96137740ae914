#include "fem/support/dense.h"

#include <cblas.h>
#include <f77blas.h>

#include <algorithm>

namespace fretval::fem {

const std::string& dense_kernels() {
  // OpenBLAS writes its text into the same place in every call: two threads at once would read what is half written.
  static const std::string kernels = std::string(openblas_get_config()) + " on " + openblas_get_corename();
  return kernels;
}

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

void solve_leading(const Eigen::MatrixXd& lower, Eigen::Ref<Eigen::VectorXd> x) {
  lower.topLeftCorner(x.size(), x.size()).triangularView<Eigen::Lower>().solveInPlace(x);
}

void multiply_transposed(const Eigen::MatrixXd& lower, Eigen::Ref<Eigen::VectorXd> x, Eigen::Index first) {
  for (Eigen::Index j = 0, n = x.size(); j < n; ++j) {
    const Eigen::Index length = n - std::max(j, first);
    x[j] = lower.col(j).segment(n - length, length).dot(x.tail(length));
  }
}

void multiply_trailing(const Eigen::MatrixXd& lower, const Eigen::Ref<const Eigen::VectorXd>& x,
                       Eigen::Ref<Eigen::VectorXd> y) {
  y.setZero();
  for (Eigen::Index n = x.size(), j = 0; j < n; ++j)
    y.tail(n - j) += x[j] * lower.col(lower.cols() - n + j).tail(n - j);
}

void subtract_product(const Eigen::MatrixXd& matrix, Eigen::Index row, Eigen::Index column,
                      const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> y) {
  const auto n_rows = static_cast<blasint>(y.size()), n_columns = static_cast<blasint>(x.size());
  if (n_rows == 0 || n_columns == 0) return;
  cblas_dgemv(CblasColMajor, CblasNoTrans, n_rows, n_columns, -1, &matrix(row, column),
              static_cast<blasint>(matrix.rows()), x.data(), 1, 1, y.data(), 1);
}

Eigen::MatrixXd gram(const Eigen::MatrixXd& half) {
  const auto n = static_cast<blasint>(half.cols()), k = static_cast<blasint>(half.rows());
  Eigen::MatrixXd product(n, n);
  cblas_dsyrk(CblasColMajor, CblasLower, CblasTrans, n, k, 1, half.data(), k, 0, product.data(), n);
  product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
  return product;
}

}  // namespace fretval::fem
