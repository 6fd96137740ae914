#pragma once

#include <Eigen/Dense>
#include <optional>

#include "fem/motion/sampled_path.h"

namespace fretval::fem {

/// Smallest value over time of several sampled signals. A minimum between samples is that of the quartic through five
/// samples around it (fifth order) or, where they are not smooth, the vertex of the parabola through three of them; but
/// not below the floor, which no signal crosses. It counts once two more samples have come, which may be in the next
/// period of a periodic signal.
///
/// Along a path signals have kinks at the ends of pieces, at which a sample is taken, or to which a signal that is
/// sampled inside the steps is extended from the last two samples of the piece; nothing is put between the samples of a
/// path, of which the smallest is of second order.
class RunningMinimum {
 public:
  static constexpr int n_before = 4;  ///< samples before the last one that a minimum may depend on

  RunningMinimum(Eigen::Index n, double floor);
  /// step: where the sample lies in a piece of a path; empty: the signals are smooth.
  template <class Values>
  void add(const Eigen::DenseBase<Values>& values, const std::optional<StepInPiece>& step = {}) {
    newest_ = (newest_ + 1) % n_kept;
    samples_.col(newest_) = values.derived();
    see_last(step);
  }
  /// Forgets the minimum but not the last samples: a minimum among them still counts.
  void restart();
  [[nodiscard]] const Eigen::VectorXd& value() const { return minimum_; }

 private:
  static constexpr int n_kept = n_before + 1;
  Eigen::VectorXd minimum_;
  Eigen::MatrixXd samples_;  // the last ones, a column each; the newest takes the place of the oldest
  int newest_ = 0;
  double floor_;
  int n_samples_ = 0;
  bool second_of_piece_ = false;  // the next sample is the second one of its piece

  [[nodiscard]] auto sample(int n_ago) const { return samples_.col((newest_ + n_kept - n_ago) % n_kept); }
  void see_last(const std::optional<StepInPiece>& step);
  void extend_to_ends(const StepInPiece& step);
};

/// Largest value of a signal over a period from its samples, by the rules of RunningMinimum; the period goes on with
/// its first sample after the last. pieces: those of the steps along a path; empty: the motion is made of cosines.
double largest_of_period(const Eigen::VectorXd& samples, const std::vector<StepInPiece>& pieces);
/// Largest value over a period of the signal or of its negative.
double largest_magnitude_of_period(const Eigen::VectorXd& samples, const std::vector<StepInPiece>& pieces);

}  // namespace fretval::fem
