#pragma once

#include <Eigen/Dense>
#include <random>

namespace fretval::fem {

/// Entries uniform in [-1, 1).
inline Eigen::VectorXd random_vector(Eigen::Index n, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd vector(n);
  for (auto& value : vector) value = uniform(engine);
  return vector;
}

}  // namespace fretval::fem
