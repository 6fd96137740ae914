#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

namespace fretval::fem {

/// What a field will be in the next step if it changes as it did a cycle before: where the search for it begins. The
/// closer the contact comes to its periodic state, the less is left to search for.
class ExpectedCourse {
 public:
  explicit ExpectedCourse(int steps_per_cycle) : steps_per_cycle_(static_cast<std::size_t>(steps_per_cycle)) {}

  /// The field expected in the next step. now: the field after this step; to be called after each one. In the first
  /// cycle it is expected to stay.
  Eigen::MatrixXd next(const Eigen::MatrixXd& now) {
    Eigen::MatrixXd expected = now;
    const std::size_t k = n_seen_++ % steps_per_cycle_;
    if (cycle_.size() < steps_per_cycle_) {
      cycle_.push_back(now);
      return expected;
    }
    expected += cycle_[(k + 1) % steps_per_cycle_] - cycle_[k];
    cycle_[k] = now;
    return expected;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(n_seen_, cycle_);
  }

 private:
  std::size_t steps_per_cycle_, n_seen_ = 0;
  std::vector<Eigen::MatrixXd> cycle_;  // the field after each of the last steps_per_cycle_ steps
};

}  // namespace fretval::fem
