#include "fem/ring_contact/ring_courses.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/fem/half_space.h"

namespace fretval::fem::ring_courses_test {
namespace {

using Eigen::Index, Eigen::VectorXd;

enum Place : Index { held = 2, lifting, touching, approaching, n_places };

/// Some rings of a half-space in a step of a tenth, in which the indenter goes down by 0.4; the others are far away.
class RingCoursesTest : public testing::Test {
 protected:
  static constexpr double increment = 0.4;
  const PunchSeries& series_ = normal_half_space(16).series;
  RelaxationStep step_{RelaxationModel{1, {3}, {2}, 0}, 0.1};
  IndenterMove move_ = steady_move(increment, 0.1);
  double gap_of_touching_ = 0.1;

  [[nodiscard]] RingCourses courses() const {
    const Index n = series_.radii().size();
    const double following = step_.response_to(move_);
    VectorXd load = VectorXd::Zero(n), standing = VectorXd::Zero(n), gap = VectorXd::Constant(n, 10);
    gap.head(touching).setZero();
    load.head(touching).setConstant(1);
    load[lifting] = 0.6;
    standing[lifting] = -0.2 - following;  // less than nothing if it followed
    gap[touching] = gap_of_touching_;
    gap[approaching] = 0.5;
    RingCourses courses;
    find_courses(series_, step_, {load, standing, gap}, move_, increment, courses);
    return courses;
  }
};

TEST_F(RingCoursesTest, RingsAreDrivenWhileTheyAreInContact) {
  const VectorXd driven = series_.displacements(courses().driven);
  EXPECT_NEAR(driven[held], 1, 1e-12);
  EXPECT_NEAR(driven[lifting], 0.75, 1e-12);   // its load falls from 0.6 to -0.2
  EXPECT_NEAR(driven[touching], 0.75, 1e-12);  // its gap is gone after a quarter of the step
  EXPECT_NEAR(driven.tail(driven.size() - approaching).cwiseAbs().maxCoeff(), 0, 1e-12);
}

// One that lifts is left behind after three quarters of the step, one that touches is ahead of the straight way before.
TEST_F(RingCoursesTest, BranchesRememberWhereAWayTurns) {
  const auto turned = courses();
  const VectorXd of_branch = series_.displacements(turned.memory.col(0)),
                 at_end = series_.displacements(turned.response);
  const double left_behind = 0.75 * -0.2 / step_.instantaneous(), ahead = 0.25 * -0.3;
  EXPECT_NEAR(of_branch[lifting], left_behind * step_.memory_of_turn(0, 0.75), 1e-9);
  EXPECT_NEAR(of_branch[touching], ahead * step_.memory_of_turn(0, 0.25), 1e-12);
  EXPECT_GT(of_branch[touching], 0) << "what came late has faded less";
  EXPECT_NEAR(of_branch[held], 0, 1e-12);
  EXPECT_NEAR(of_branch[approaching], 0, 1e-12);
  EXPECT_LT((of_branch - at_end).cwiseAbs().maxCoeff(), 1e-7) << "balanced at the end of the step";
  EXPECT_LT(turned.passing_depths.cwiseAbs().maxCoeff(), 1e-7) << "nothing is viscous";
}

// Balanced at 0.504 of the step. From when a ring touches, the dashpot bears all that belongs to it at once.
TEST_F(RingCoursesTest, ADashpotBearsNothingBeforeARingTouches) {
  constexpr double viscosity = 2, dt = 0.1;
  step_ = RelaxationStep(RelaxationModel{1, {}, {}, viscosity}, dt);
  const auto early = courses();
  EXPECT_NEAR(series_.displacements(early.driven)[lifting], 0.75, 1e-12);
  EXPECT_NEAR(series_.displacements(early.response)[touching], -0.25 * 0.3 * step_.response_to_turn(0.25), 1e-12);
  const double mean = viscosity * 0.3 / dt;  // it is driven for the last 0.3 of the way, in 0.75 of the step
  EXPECT_NEAR(early.passing_depths[touching], mean / 0.75 - mean, 1e-12);
  EXPECT_EQ(early.passing_depths[held], 0);
  EXPECT_EQ(early.passing_depths[approaching], 0);
  gap_of_touching_ = 0.3;  // in three quarters of the step
  EXPECT_EQ(courses().passing_depths[touching], -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace fretval::fem::ring_courses_test
