#pragma once

#include <Eigen/Dense>

namespace fretval::fem {

/// Smallest value over time of several sampled signals, to second order: a minimum between samples is the vertex of the
/// parabola through the three samples around it, but not below the floor, which no signal crosses.
class RunningMinimum {
 public:
  RunningMinimum(Eigen::Index n, double floor);
  void add(const Eigen::VectorXd& values);
  /// Forgets the minimum but not the last samples: a minimum between them and the next one still counts.
  void restart();
  [[nodiscard]] const Eigen::VectorXd& value() const { return minimum_; }

 private:
  Eigen::VectorXd minimum_, before_, last_;
  double floor_;
  int n_samples_ = 0;
};

}  // namespace fretval::fem
