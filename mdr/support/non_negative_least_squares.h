#pragma once

#include <Eigen/Core>

namespace fretval::mdr {

/// The x >= 0 (n) that minimises |A x - b|, for A (m x n) and b (m); any m, n >= 1 and any rank. Columns that other
/// columns in use make redundant to roundoff stay at zero.
///
/// Active-set method of Lawson and Hanson, Solving Least Squares Problems (1974), chapter 23. At the solution the
/// gradient w = A^T (b - A x) has w_j <= 0 where x_j = 0 and w_j = 0 where x_j > 0, up to roundoff of |a_j| |b|.
///
/// Throws std::invalid_argument for sizes that do not match or entries that are not finite, and std::runtime_error
/// after max_iterations changes of the active set, 30 n unless given; 3 n are rarely exceeded.
Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, int max_iterations = 0);

}  // namespace fretval::mdr
