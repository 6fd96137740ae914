#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>

namespace fretval::fem {

// Dense operators of a thousand rows through BLAS and LAPACK, whose kernels are chosen for the processor at run time;
// Eigen's own are compiled for all of them, and take four times as long. Products of triangles and single vectors are
// done without BLAS, which takes a buffer for each of them under a lock that threads share: there it takes four times
// as long at 36 rings, 1.6 times at 256.

/// Name, version and kernels of the BLAS: with other ones, results differ by roundoff.
const std::string& dense_kernels();

/// Lower Cholesky factor L of a symmetric matrix L L^T, zero above the diagonal; empty: the matrix is not positive
/// definite.
std::optional<Eigen::MatrixXd> cholesky(Eigen::MatrixXd matrix);

/// L^-1 rhs for a lower triangle L.
Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& lower, Eigen::MatrixXd rhs);

/// x <- L_n^-1 x, L_n the leading n rows and columns of a lower triangle, n = x.size().
void solve_leading(const Eigen::MatrixXd& lower, Eigen::Ref<Eigen::VectorXd> x);

/// x <- L_n^T x of the leading n rows and columns of a lower triangle that is zero above the diagonal. The entries of x
/// before the first are zero; zeros at its end take no time.
void multiply_transposed(const Eigen::MatrixXd& lower, Eigen::Ref<Eigen::VectorXd> x, Eigen::Index first = 0);

/// x <- B x with B the x.size() rows and columns of such a triangle from `first` on; of its trailing rows and columns
/// for multiply_trailing().
void multiply_block(const Eigen::MatrixXd& lower, Eigen::Index first, Eigen::Ref<Eigen::VectorXd> x);
inline void multiply_trailing(const Eigen::MatrixXd& lower, Eigen::Ref<Eigen::VectorXd> x) {
  multiply_block(lower, lower.cols() - x.size(), x);
}

/// y <- y - A x with A the block of a matrix that begins at this row and column.
void subtract_product(const Eigen::MatrixXd& matrix, Eigen::Index row, Eigen::Index column,
                      const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> y);

// Products of whole matrices, by BLAS: two to three times as fast as our own from 28 rows and two columns on.

/// y <- A x, and y <- A^T x.
void multiply(const Eigen::Ref<const Eigen::MatrixXd>& matrix, const Eigen::Ref<const Eigen::MatrixXd>& x,
              Eigen::Ref<Eigen::MatrixXd> y);
void multiply(const Eigen::Ref<const Eigen::MatrixXf>& matrix, const Eigen::Ref<const Eigen::MatrixXf>& x,
              Eigen::Ref<Eigen::MatrixXf> y);
void multiply_by_transpose(const Eigen::MatrixXd& matrix, const Eigen::Ref<const Eigen::MatrixXd>& x,
                           Eigen::Ref<Eigen::MatrixXd> y);

/// y <- A x for a symmetric matrix A, both of whose triangles are there. A single column takes half of the memory
/// traffic of multiply().
void multiply_symmetric(const Eigen::MatrixXd& matrix, const Eigen::Ref<const Eigen::MatrixXd>& x,
                        Eigen::Ref<Eigen::MatrixXd> y);
void multiply_symmetric(const Eigen::MatrixXf& matrix, const Eigen::Ref<const Eigen::MatrixXf>& x,
                        Eigen::Ref<Eigen::MatrixXf> y);

/// The inverse of a symmetric matrix; empty: the matrix is not positive definite.
std::optional<Eigen::MatrixXd> inverse(Eigen::MatrixXd matrix);

/// matrix^-1 rhs of any square matrix.
Eigen::VectorXd solve_square(Eigen::MatrixXd matrix, Eigen::VectorXd rhs);

/// half^T half, both triangles.
Eigen::MatrixXd gram(const Eigen::MatrixXd& half);

}  // namespace fretval::fem
