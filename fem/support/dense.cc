#include "fem/support/dense.h"

#include <cblas.h>
#include <f77blas.h>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "fem/support/solver_error.h"
#include "fem/support/wide_registers.h"

namespace fretval::fem {
namespace {

using Eigen::Index;

constexpr Index at_once = 4;  // rows, and columns: of every four, a number of x is loaded once

/// products_k <- column_k . x, rows taken by fours. Whatever the width of the registers, sums are the same to the last
/// bit.
template <Index width, Index n_columns>
void dot_columns(const double* columns, Index stride, const double* x, Index n_rows, double* products) {
  using Register [[gnu::vector_size(width * sizeof(double))]] = double;
  constexpr Index n_parts = at_once / width;
  Register sums[n_columns][n_parts]{}, column, part_of_x;
  for (Index i = 0; i < n_rows; i += at_once)
    for (Index part = 0; part < n_parts; ++part) {
      const Index row = i + part * width;
      std::memcpy(&part_of_x, x + row, sizeof(Register));
      for (Index k = 0; k < n_columns; ++k) {
        std::memcpy(&column, columns + k * stride + row, sizeof(Register));
        sums[k][part] += column * part_of_x;
      }
    }
  for (Index k = 0; k < n_columns; ++k) {
    double of_four[at_once];
    std::memcpy(of_four, sums[k], sizeof(of_four));
    products[k] = (of_four[0] + of_four[2]) + (of_four[1] + of_four[3]);
  }
}

/// y <- y + sum_k factor_k column_k, by as many rows at a time as a register holds. Whatever that is, sums are the same
/// to the last bit.
template <Index width, Index n_columns>
void add_columns(const double* columns, Index stride, const double (&factors)[n_columns], Index n_rows, double* y) {
  using Register [[gnu::vector_size(width * sizeof(double))]] = double;
  for (Index i = 0; i < n_rows; i += width) {
    Register sum{}, read;
    for (Index k = 0; k < n_columns; ++k) {
      std::memcpy(&read, columns + k * stride + i, sizeof(Register));
      sum += factors[k] * read;
    }
    std::memcpy(&read, y + i, sizeof(Register));
    sum += read;
    std::memcpy(y + i, &sum, sizeof(Register));
  }
}

void gemm(CBLAS_TRANSPOSE transpose, blasint m, blasint n, blasint k, const double* a, blasint lda, const double* x,
          blasint ldx, double* y, blasint ldy) {
  cblas_dgemm(CblasColMajor, transpose, CblasNoTrans, m, n, k, 1, a, lda, x, ldx, 0, y, ldy);
}
void gemm(CBLAS_TRANSPOSE transpose, blasint m, blasint n, blasint k, const float* a, blasint lda, const float* x,
          blasint ldx, float* y, blasint ldy) {
  cblas_sgemm(CblasColMajor, transpose, CblasNoTrans, m, n, k, 1, a, lda, x, ldx, 0, y, ldy);
}

void symv(blasint n, const double* a, const double* x, double* y) {
  cblas_dsymv(CblasColMajor, CblasLower, n, 1, a, n, x, 1, 0, y, 1);
}
void symv(blasint n, const float* a, const float* x, float* y) {
  cblas_ssymv(CblasColMajor, CblasLower, n, 1, a, n, x, 1, 0, y, 1);
}

/// y <- A x or A^T x.
template <class Matrix>
void product(CBLAS_TRANSPOSE transpose, const Eigen::Ref<const Matrix>& a, const Eigen::Ref<const Matrix>& x,
             Eigen::Ref<Matrix>& y) {
  gemm(transpose, static_cast<blasint>(y.rows()), static_cast<blasint>(x.cols()), static_cast<blasint>(x.rows()),
       a.data(), static_cast<blasint>(a.outerStride()), x.data(), static_cast<blasint>(x.outerStride()), y.data(),
       static_cast<blasint>(y.outerStride()));
}

template <class Matrix>
void symmetric_product(const Matrix& a, const Eigen::Ref<const Matrix>& x, Eigen::Ref<Matrix>& y) {
  if (x.cols() == 1) return symv(static_cast<blasint>(a.rows()), a.data(), x.data(), y.data());
  product<Matrix>(CblasTrans, a, x, y);
}

}  // namespace

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

// What does not divide by four is a corner of up to three rows and columns at the upper left. As all is zero above the
// diagonal, the four columns of a block begin in the same row.
void multiply_transposed(const Eigen::MatrixXd& lower, Eigen::Ref<Eigen::VectorXd> vector, Index first) {
  double* x = vector.data();
  Index n = vector.size();
  while (n > 0 && x[n - 1] == 0) --n;
  const Index stride = lower.rows(), corner = n % at_once,
              begin = first > corner ? first - (first - corner) % at_once : corner;
  in_wide_registers([=, columns = lower.data()](auto width) {
    for (Index j = 0; j < corner; ++j) {
      double product = 0;
      dot_columns<width, 1>(columns + j * stride + begin, stride, x + begin, n - begin, &product);
      for (Index i = j; i < corner; ++i) product += columns[j * stride + i] * x[i];
      x[j] = product;
    }
    for (Index j = corner; j < n; j += at_once) {
      const Index from = std::max(j, begin);
      dot_columns<width, at_once>(columns + j * stride + from, stride, x + from, n - from, x + j);
    }
  });
}

void multiply_block(const Eigen::MatrixXd& lower, Eigen::Index first, Eigen::Ref<Eigen::VectorXd> vector) {
  const Index n = vector.size(), stride = lower.rows(), corner = n % at_once;
  in_wide_registers([=, columns = lower.data() + first * (stride + 1), x = vector.data()](auto width) {
    for (Index j = n - at_once; j >= corner; j -= at_once) {
      double factors[at_once];
      std::copy_n(x + j, at_once, factors);
      std::fill_n(x + j, at_once, 0.0);
      add_columns<width>(columns + j * (stride + 1), stride, factors, n - j, x + j);
    }
    for (Index j = corner - 1; j >= 0; --j) {
      const double* column = columns + j * stride;
      const double factor[] = {x[j]};
      x[j] = 0;
      for (Index i = j; i < corner; ++i) x[i] += column[i] * factor[0];
      add_columns<width>(column + corner, stride, factor, n - corner, x + corner);
    }
  });
}

void subtract_product(const Eigen::MatrixXd& matrix, Eigen::Index row, Eigen::Index column,
                      const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> y) {
  const auto n_rows = static_cast<blasint>(y.size()), n_columns = static_cast<blasint>(x.size());
  if (n_rows == 0 || n_columns == 0) return;
  cblas_dgemv(CblasColMajor, CblasNoTrans, n_rows, n_columns, -1, &matrix(row, column),
              static_cast<blasint>(matrix.rows()), x.data(), 1, 1, y.data(), 1);
}

void multiply(const Eigen::Ref<const Eigen::MatrixXd>& matrix, const Eigen::Ref<const Eigen::MatrixXd>& x,
              Eigen::Ref<Eigen::MatrixXd> y) {
  product<Eigen::MatrixXd>(CblasNoTrans, matrix, x, y);
}

void multiply(const Eigen::Ref<const Eigen::MatrixXf>& matrix, const Eigen::Ref<const Eigen::MatrixXf>& x,
              Eigen::Ref<Eigen::MatrixXf> y) {
  product<Eigen::MatrixXf>(CblasNoTrans, matrix, x, y);
}

void multiply_by_transpose(const Eigen::MatrixXd& matrix, const Eigen::Ref<const Eigen::MatrixXd>& x,
                           Eigen::Ref<Eigen::MatrixXd> y) {
  product<Eigen::MatrixXd>(CblasTrans, matrix, x, y);
}

void multiply_symmetric(const Eigen::MatrixXd& matrix, const Eigen::Ref<const Eigen::MatrixXd>& x,
                        Eigen::Ref<Eigen::MatrixXd> y) {
  symmetric_product(matrix, x, y);
}

void multiply_symmetric(const Eigen::MatrixXf& matrix, const Eigen::Ref<const Eigen::MatrixXf>& x,
                        Eigen::Ref<Eigen::MatrixXf> y) {
  symmetric_product(matrix, x, y);
}

std::optional<Eigen::MatrixXd> inverse(Eigen::MatrixXd matrix) {
  auto inverted = cholesky(std::move(matrix));
  if (!inverted) return std::nullopt;
  char lower = 'L';
  blasint n = static_cast<blasint>(inverted->rows()), info = 0;
  BLASFUNC(dpotri)(&lower, &n, inverted->data(), &n, &info);
  if (info != 0) return std::nullopt;
  inverted->triangularView<Eigen::StrictlyUpper>() = inverted->transpose();
  return inverted;
}

Eigen::VectorXd solve_square(Eigen::MatrixXd matrix, Eigen::VectorXd rhs) {
  blasint n = static_cast<blasint>(rhs.size()), one = 1, info = 0;
  std::vector<blasint> pivots(static_cast<std::size_t>(n));
  BLASFUNC(dgesv)(&n, &one, matrix.data(), &n, pivots.data(), rhs.data(), &n, &info);
  if (info != 0) throw SolverError("a matrix of the contact is singular");
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
