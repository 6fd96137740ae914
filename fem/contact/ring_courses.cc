#include "fem/contact/ring_courses.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace fretval::fem {
namespace {

/// Of a way that turns once in a step.
struct Turn {
  double share = 1;   ///< of the step, when it turns
  double detour = 0;  ///< then, from the straight way to its end
};

}  // namespace

CoursesInStep::CoursesInStep(const PunchSeries& series, const RelaxationStep& step, Eigen::VectorXd load,
                             Eigen::VectorXd standing, Eigen::VectorXd gap)
    : series_(series), step_(step), load_(std::move(load)), standing_(std::move(standing)), gap_(std::move(gap)) {}

RingCourses CoursesInStep::under(const IndenterMove& to_balance, double increment) const {
  const Eigen::Index n = load_.size(), n_branches = step_.n_branches();
  const double following = step_.response_to(to_balance), stiffness = step_.instantaneous();
  RingCourses courses{Eigen::VectorXd::Zero(n), {}, {}, Eigen::VectorXd::Zero(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    Turn turn;
    if (load_[i] > 0) {
      const double followed = standing_[i] + following, held = followed < 0 ? load_[i] / (load_[i] - followed) : 1;
      courses.driven[i] = held;
      turn.share = held * step_.fraction();
      turn.detour = turn.share * std::min(followed, 0.0) / stiffness;
    } else if (const double inside = standing_[i] / stiffness + increment - gap_[i]; gap_[i] > 0 && inside > 0) {
      turn.share = gap_[i] / (gap_[i] + inside);
      turn.detour = -turn.share * inside;
      courses.driven[i] = 1 - turn.share;
      courses.passing_depths[i] = turn.share < step_.fraction()
                                      ? turn.detour * step_.passing_response_to_turn(turn.share)
                                      : -std::numeric_limits<double>::infinity();
    }
    if (turn.detour == 0) continue;
    if (!courses.has_turns()) {
      courses.response = Eigen::VectorXd::Zero(n);
      courses.memory = Eigen::MatrixXd::Zero(n, n_branches);
    }
    courses.response[i] = turn.detour * step_.response_to_turn(turn.share);
    for (Eigen::Index branch = 0; branch < n_branches; ++branch)
      courses.memory(i, branch) = turn.detour * step_.memory_of_turn(branch, turn.share);
  }
  courses.driven = series_.rings(courses.driven, 0);
  if (!courses.has_turns()) return courses;
  courses.response = series_.rings(courses.response, 0);
  for (Eigen::Index branch = 0; branch < n_branches; ++branch)
    courses.memory.col(branch) = series_.rings(courses.memory.col(branch), 0);
  return courses;
}

}  // namespace fretval::fem
