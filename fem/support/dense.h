#pragma once

#include <Eigen/Dense>
#include <optional>

namespace fretval::fem {

// Dense operators of a thousand rows through BLAS and LAPACK, whose kernels are chosen for the processor at run time;
// Eigen's own are compiled for all of them, and take four times as long.

/// Lower factor L of a symmetric positive definite matrix L L^T, zero above the diagonal; empty: it is none.
std::optional<Eigen::MatrixXd> cholesky(Eigen::MatrixXd matrix);

/// L^-1 rhs of a lower triangle.
Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& lower, Eigen::MatrixXd rhs);

/// half^T half, both triangles.
Eigen::MatrixXd gram(const Eigen::MatrixXd& half);

}  // namespace fretval::fem
