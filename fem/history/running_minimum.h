#pragma once

#include <Eigen/Dense>
#include <array>

namespace fretval::fem {

/// Smallest value over time of several sampled signals. A minimum between samples is that of the quartic through five
/// samples around it (fifth order) or, where they are not smooth, the vertex of the parabola through three of them;
/// but not below the floor, which no signal crosses. It counts once two more samples have come: of a periodic signal,
/// in the next period.
class RunningMinimum {
 public:
  RunningMinimum(Eigen::Index n, double floor);
  void add(const Eigen::VectorXd& values);
  /// Forgets the minimum but not the last samples: a minimum among them still counts.
  void restart();
  [[nodiscard]] const Eigen::VectorXd& value() const { return minimum_; }

 private:
  Eigen::VectorXd minimum_;
  std::array<Eigen::VectorXd, 5> samples_;  // the last ones, oldest first
  double floor_;
  int n_samples_ = 0;
};

/// Largest value of a periodic signal from the samples of a period, as above. Those at its ends have their neighbours
/// in the next period.
double largest_of_period(const Eigen::VectorXd& samples);

}  // namespace fretval::fem
