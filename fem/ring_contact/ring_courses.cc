#include "fem/ring_contact/ring_courses.h"

#include <algorithm>
#include <limits>

namespace fretval::fem {
namespace {

/// The way of a ring that turns once in a step.
struct Turn {
  double share = 1;   ///< of the step, when it turns
  double detour = 0;  ///< then, from the straight way to its end
};

}  // namespace

void find_courses(const PunchSeries& series, const RelaxationStep& step, const RingsAtStart& rings,
                  const IndenterMove& to_balance, double increment, RingCourses& courses) {
  const auto& [load, standing, gap] = rings;
  const Eigen::Index n = load.size(), n_branches = step.n_branches();
  const double following = step.response_to(to_balance), stiffness = step.instantaneous();
  courses.driven.setZero(n);
  courses.touches_at.setZero(n);
  courses.passing_depths.setZero(n);
  courses.has_turns = false;
  for (Eigen::Index i = 0; i < n; ++i) {
    Turn turn;
    if (load[i] > 0) {
      const double followed = standing[i] + following, held = followed < 0 ? load[i] / (load[i] - followed) : 1;
      courses.driven[i] = held;
      turn.share = held * step.fraction();
      turn.detour = turn.share * std::min(followed, 0.0) / stiffness;
    } else if (const double inside = standing[i] / stiffness + increment - gap[i]; gap[i] > 0 && inside > 0) {
      turn.share = gap[i] / (gap[i] + inside);
      turn.detour = -turn.share * inside;
      courses.driven[i] = 1 - turn.share;
      courses.touches_at[i] = turn.share;
      courses.passing_depths[i] = turn.share < step.fraction() ? turn.detour * step.passing_response_to_turn(turn.share)
                                                               : -std::numeric_limits<double>::infinity();
    }
    if (turn.detour == 0) continue;
    if (!courses.has_turns) {
      courses.response.setZero(n);
      courses.memory.setZero(n, n_branches);
      courses.has_turns = true;
    }
    courses.response[i] = turn.detour * step.response_to_turn(turn.share);
    for (Eigen::Index branch = 0; branch < n_branches; ++branch)
      courses.memory(i, branch) = turn.detour * step.memory_of_turn(branch, turn.share);
  }
  series.to_rings(courses.driven);
  if (!courses.has_turns) return;
  series.to_rings(courses.response);
  for (auto branch : courses.memory.colwise()) series.to_rings(branch);
}

}  // namespace fretval::fem
