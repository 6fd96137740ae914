#include "fem/history/periodic_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/history/normal_contact.h"
#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::periodic_state_test {
namespace {

/// Two rings of a made-up line.
Compliance two_rings() {
  Eigen::MatrixXd matrix(2, 2);
  matrix << 2, 0.5, 0.5, 3;
  return {{0, 1, 2}, Eigen::Vector2d(1, 3), matrix};
}

/// Periods of equal steps with what is held in all of them.
std::vector<FrozenStep> equal_steps(const RelaxationModel& model, int n, const std::vector<bool>& held) {
  return std::vector<FrozenStep>(static_cast<std::size_t>(n), FrozenStep{{model, 2 * pi / n}, held});
}

// A free ring of a Kelvin-Voigt body relaxes by exp(-T G0/eta) in a period.
TEST(CorrectionToPeriodic, LetsAFreeRingRelaxToTheEnd) {
  const RelaxationModel slow{1, {}, {}, 1e6};
  const double in_a_period = std::expm1(-2 * pi / 1e6);
  const RingState change{Eigen::Vector2d(0, in_a_period * 0.3), Eigen::MatrixXd(2, 0)};
  const auto correction =
      correction_to_periodic(two_rings(), equal_steps(slow, 20, {true, false}), Hold::sticks, change);
  EXPECT_NEAR(correction.displacement[1], -0.3, 1e-9);  // roundoff over the change
  EXPECT_EQ(correction.displacement[0], 0);
}

// The memory of a ring that is held decays by exp(-T/tau) in a period, whatever the others do.
TEST(CorrectionToPeriodic, LetsTheMemoryOfAHeldRingDecayToTheEnd) {
  const RelaxationModel slow{1, {2}, {1e4}, 0};
  const double in_a_period = std::expm1(-2 * pi / 1e4);
  RingState change{Eigen::VectorXd::Zero(2), Eigen::MatrixXd::Constant(2, 1, in_a_period * 0.3)};
  const auto correction =
      correction_to_periodic(two_rings(), equal_steps(slow, 20, {true, true}), Hold::sticks, change);
  EXPECT_NEAR(correction.memory(0, 0), -0.3, 1e-10);
  EXPECT_NEAR(correction.memory(1, 0), -0.3, 1e-10);
}

/// A small change of the rings that move, taken through the steps beside one that is held throughout.
Eigen::VectorXd marched(const Compliance& compliance, const std::vector<FrozenStep>& steps, const Eigen::VectorXd& x) {
  RingState state{x, Eigen::MatrixXd(x.size(), 0)};
  const auto rest = steady_move(0, 1);
  for (const auto& [relaxation, is_held] : steps) {
    const Eigen::VectorXd w = relaxation.response_without_slip(state, rest), loads = compliance.areas.cwiseProduct(w);
    Eigen::MatrixXd matrix = *compliance.matrix;
    Eigen::VectorXd held_loads = loads;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      if (is_held[static_cast<std::size_t>(i)]) continue;
      matrix.row(i).setZero();
      matrix.col(i).setZero();
      matrix(i, i) = 1;
      held_loads[i] = 0;
    }
    const Eigen::VectorXd pressure = matrix.inverse() * held_loads;
    Eigen::VectorXd slip = (loads - *compliance.matrix * pressure).cwiseQuotient(compliance.areas);
    for (Eigen::Index i = 0; i < x.size(); ++i)
      if (is_held[static_cast<std::size_t>(i)]) slip[i] = 0;
    relaxation.advance(state, rest, slip / relaxation.instantaneous());
  }
  return state.displacement;
}

// Two rings that are held in turns push each other, and less so beside a third one that is held all the time.
TEST(CorrectionToPeriodic, UndoesASmallChangeBesideAHeldRing) {
  Eigen::MatrixXd matrix(3, 3);
  matrix << 2, 0.5, 0.7, 0.5, 3, 1, 0.7, 1, 4;
  const Compliance compliance{{0, 1, 2, 3}, Eigen::Vector3d(1, 3, 5), matrix};
  auto steps = equal_steps({1, {}, {}, 2}, 12, {true, true, false});
  for (std::size_t k = 0; k < 6; ++k) steps[k].held = {true, false, true};
  const Eigen::Vector3d x(0, 0.3, -0.2);
  const RingState change{marched(compliance, steps, x) - x, Eigen::MatrixXd(3, 0)};
  const auto correction = correction_to_periodic(compliance, steps, Hold::sticks, change);
  EXPECT_LT((correction.displacement + x).cwiseAbs().maxCoeff(), 1e-13);
}

double largest_difference(const RingState& a, const RingState& b) {
  return std::max((a.displacement - b.displacement).cwiseAbs().maxCoeff(), (a.memory - b.memory).cwiseAbs().maxCoeff());
}

/// A body that creeps for 800 periods after its ramp, under an oscillation that moves the edge of its contact.
class SlowNormalContact : public testing::Test {
 protected:
  static constexpr int n_steps = 36;

  [[nodiscard]] PeriodicState find(const RingState& start) const {
    return find_periodic_state(contact_.problem().compliance, model_, Hold::closes, start, 1e-10,
                               [this](const RingState& begin) { return period(begin); });
  }
  [[nodiscard]] FrozenPeriod period(const RingState& begin) const {
    return period_from(begin, contact_, n_steps, [](NormalContact& contact) { contact.step(); });
  }
  void SetUp() override {
    while (contact_.n_steps < 5L * n_steps) contact_.step();
  }

  RelaxationModel model_{1, {50}, {100}, 0};
  Motion motion_ = [] {
    auto motion = one_frequency(0.8, 0.01, 0, 0.0);
    motion.n_ramp_cycles = 4;
    return motion;
  }();
  NormalContact contact_{normal_half_space(32), model_, parabola_means(normal_half_space(32)), motion_, n_steps};
};

TEST_F(SlowNormalContact, IsTakenToAStateThatRepeats) {
  const auto found = find(contact_.state);
  EXPECT_GT(largest_difference(found.state, contact_.state), 1e-4);
  EXPECT_LT(largest_difference(period(found.state).end, found.state), 1e-12);
  EXPECT_LE(found.n_periods, 9);
}

// A ring in contact forgets where it was, its memory and rings that open do not.
TEST_F(SlowNormalContact, ComesBackFromASmallChange) {
  const auto periodic = find(contact_.state).state;
  RingState moved = periodic;
  moved.memory.array() += 1e-7;
  for (Eigen::Index i = 0; i < moved.displacement.size(); ++i)
    if (contact_.gap[i] > 0) moved.displacement[i] += 1e-7;
  const auto again = find(moved);
  EXPECT_LT(largest_difference(again.state, periodic), 1e-10);
  EXPECT_LE(again.n_periods, 6);
}

}  // namespace
}  // namespace fretval::fem::periodic_state_test
