#pragma once

#include <Eigen/Dense>

namespace fretval::fem {

// Conversion of fields on rings x angles, a row for each ring, to the long vectors of a RingState and back.

inline Eigen::VectorXd as_vector(const Eigen::MatrixXd& field) {
  return Eigen::Map<const Eigen::VectorXd>(field.data(), field.size());
}

inline Eigen::MatrixXd as_field(const Eigen::VectorXd& values, Eigen::Index n_rings) {
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), n_rings, values.size() / n_rings);
}

/// |t| at each point of a traction, t_x before t_y.
inline Eigen::MatrixXd lengths(const Eigen::MatrixXd& traction) {
  const Eigen::Index m = traction.cols() / 2;
  return (traction.leftCols(m).array().square() + traction.rightCols(m).array().square()).sqrt();
}

}  // namespace fretval::fem
