#include "fem/history/friction_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::friction_contact_test {
namespace {

constexpr double mu = 0.5, amplitude = 0.9 * 1.5 * mu;  // d = 1: all slides at 1.5 mu

/// u = amplitude sin t.
Motion sliding_motion() {
  auto motion = one_frequency(1, 0, amplitude, -pi / 2);
  motion.n_ramp_cycles = 0;
  return motion;
}

class FrictionContactTest : public testing::Test {
 protected:
  const ContactProblem& problem_ = tangential_half_space(32);
  const Eigen::VectorXd pressure_ = hertz_contact(normal_half_space(32), 1).pressure;
  const Motion motion_ = sliding_motion();
  const RelaxationModel elastic_ = elastic_body();
};

// u = (3 mu/2)(1 - c^2), F = mu (16/3)(1 - c^3): the plain sum over the rings is off by h^2 = 1e-3.
TEST_F(FrictionContactTest, SlidesLikeCattaneoAndMindlin) {
  FrictionContact contact(problem_, elastic_, mu, motion_, 36);
  for (int k = 1; k <= 9; ++k) {
    contact.step(pressure_);
    const double u = amplitude * std::sin(2 * pi * k / 36), c = std::sqrt(1 - u / (1.5 * mu));
    EXPECT_NEAR(contact.traction.dot(problem_.compliance.areas) / (mu * 16.0 / 3), 1 - c * c * c, 1e-3) << k;
    for (Eigen::Index i = 0; i < problem_.n_rings(); ++i) {
      const bool slips = contact.slip[i] != 0;
      EXPECT_EQ(contact.traction[i] == contact.limit[i], slips || contact.limit[i] == 0) << i;
      EXPECT_GE(contact.slip[i], 0);
      if (problem_.compliance.radii[i + 1] < c) {
        EXPECT_NEAR(contact.state.displacement[i], u, 1e-14) << i;
      }
    }
  }
}

// Coulomb friction has no rate: on the way out under a constant pressure steps do not matter. Roundoff of the solver.
TEST_F(FrictionContactTest, OfAnElasticBodyKnowsNoTime) {
  FrictionContact few(problem_, elastic_, mu, motion_, 12), many(problem_, elastic_, mu, motion_, 180);
  for (int k = 0; k < 3; ++k) few.step(pressure_);
  for (int k = 0; k < 45; ++k) many.step(pressure_);
  EXPECT_LT((few.traction - many.traction).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_LT((few.state.displacement - many.state.displacement).cwiseAbs().maxCoeff(), 1e-11);
}

// Reversed motion, reversed tractions.
TEST_F(FrictionContactTest, HasNoPreferredSide) {
  Motion reversed = sliding_motion();
  reversed.tangential[0].amplitude *= -1;
  const auto solid = standard_solid();
  FrictionContact there(problem_, solid, mu, motion_, 36), back(problem_, solid, mu, reversed, 36);
  for (int k = 0; k < 20; ++k) {
    there.step(pressure_);
    back.step(pressure_);
    EXPECT_EQ(there.traction, -back.traction) << k;
  }
}

// The centre, which sticks, moves with the indenter: at the balance time too, which a dashpot puts inside the step.
TEST_F(FrictionContactTest, MovesWhatSticksWithTheIndenterAtTheBalanceTime) {
  const auto body = kelvin_voigt();
  FrictionContact contact(problem_, body, 2 * mu, motion_, 36);
  EXPECT_LT(contact.fraction(), 0.9);
  for (int k = 0; k < 12; ++k) {
    contact.step(pressure_);
    ASSERT_EQ(contact.slip[0], 0);
    EXPECT_NEAR(contact.balance_displacements()[0], contact.balance_displacement, 1e-14) << k;
  }
}

// Also where it slips: of an elastic body displacements are those of its tractions; of one with a dashpot the rings go
// on slipping after the balance time, at the rate of the step.
TEST_F(FrictionContactTest, HasTheDisplacementsOfTheBalanceTime) {
  FrictionContact elastic(problem_, elastic_, mu, motion_, 36);
  for (int k = 0; k < 12; ++k) elastic.step(pressure_);
  const Eigen::VectorXd expected =
      (*problem_.compliance.matrix * elastic.traction).cwiseQuotient(problem_.compliance.areas);
  EXPECT_LT((elastic.balance_displacements() - expected).cwiseAbs().maxCoeff(), 1e-10);

  const auto body = kelvin_voigt();
  FrictionContact contact(problem_, body, mu, motion_, 36);
  for (int k = 0; k < 12; ++k) {
    const Eigen::VectorXd before = contact.state.displacement;
    const double indenter_before = contact.displacement;
    contact.step(pressure_);
    const Eigen::VectorXd slip_so_far = contact.fraction() * contact.slip;
    const Eigen::VectorXd moved = contact.balance_displacements() - before + slip_so_far;
    EXPECT_LT((moved.array() - (contact.balance_displacement - indenter_before)).abs().maxCoeff(), 1e-14) << k;
  }
  EXPECT_GT(contact.slip.cwiseAbs().maxCoeff(), 1e-3);
}

// A surface that nothing presses stays where it is, and is stuck at once when it is pressed.
TEST_F(FrictionContactTest, WithoutPressureHoldsNothing) {
  FrictionContact contact(problem_, elastic_, mu, motion_, 36);
  for (int k = 0; k < 5; ++k) contact.step(Eigen::VectorXd::Zero(problem_.n_rings()));
  EXPECT_EQ(contact.traction.cwiseAbs().maxCoeff(), 0);
  EXPECT_LT(contact.state.displacement.cwiseAbs().maxCoeff(), 1e-15);
  contact.step(pressure_);
  const double step = amplitude * (std::sin(2 * pi * 6 / 36) - std::sin(2 * pi * 5 / 36));
  EXPECT_NEAR(contact.state.displacement[0], step, 1e-15);
}

}  // namespace
}  // namespace fretval::fem::friction_contact_test
