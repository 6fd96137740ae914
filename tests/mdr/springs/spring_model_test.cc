#include "mdr/springs/spring_model.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>

namespace fretval::mdr::spring_model_test {
namespace {

Eigen::VectorXd recovered(const FreeRecovery& recovery, const Eigen::VectorXd& state, double theta) {
  return recovery.from_modes * ((-recovery.rates * theta).exp() * (recovery.to_modes * state).array()).matrix();
}

TEST(SpringModel, ElasticSpringHasNothingToRecover) {
  EXPECT_EQ(spring_model(elastic(5), 2).recovery.rates.size(), 0);
}

TEST(SpringModel, KelvinVoigtRecoversWithItsRetardationTime) {
  const SpringModel model = spring_model(kelvin_voigt(5, 2), 3);  // e = 3 * 2 / 5
  ASSERT_EQ(model.recovery.rates.size(), 1);
  EXPECT_NEAR(model.recovery.rates(0), 1 / 1.2, 1e-15);
}

// The unloaded standard solid has the retardation time tau (G0 + G1)/G0.
TEST(SpringModel, StandardSolidRecoversWithItsRetardationTime) {
  const SpringModel model = spring_model(standard_solid(5, 15, 0.1), 3);
  ASSERT_EQ(model.recovery.rates.size(), 1);
  EXPECT_NEAR(model.recovery.rates(0), 1 / (0.3 * 4), 1e-14);
}

// The modes solve f = 0 and v_i' = (u - v_i)/T_i, by central differences of order h^2 = 1e-8.
TEST(SpringModel, ModesSolveTheUnloadedSpring) {
  for (const double viscosity : {0.0, 0.4}) {
    const SpringModel model = spring_model(prony(1, {2, 0.5, 3}, {0.3, 1, 4}, viscosity), 1);
    const Eigen::Index n_depth = n_depth_states(model);
    const Eigen::VectorXd start = Eigen::VectorXd::LinSpaced(n_depth + 3, 1, 2);
    EXPECT_NEAR((recovered(model.recovery, start, 0) - start).norm(), 0, 1e-13);
    const double theta = 0.2, h = 1e-4;
    const Eigen::VectorXd state = recovered(model.recovery, start, theta);
    const Eigen::VectorXd rate =
        (recovered(model.recovery, start, theta + h) - recovered(model.recovery, start, theta - h)) / (2 * h);
    const double u = model.recovery.depth_of_modes *
                     ((-model.recovery.rates * theta).exp() * (model.recovery.to_modes * start).array()).matrix();
    const double du = viscosity > 0 ? rate(0) : 0;
    const Eigen::ArrayXd lag = u - state.tail(3).array();
    EXPECT_NEAR(u + (model.branch_moduli * lag).sum() + model.viscosity * du, 0, 1e-6);
    EXPECT_NEAR((rate.tail(3).array() - lag / model.branch_times).abs().maxCoeff(), 0, 1e-6);
  }
}

// Fourteen decades apart: the slow rate keeps its digits next to the fast one. With gamma small the branches do not
// interact, and each retardation time is T_i (1 + gamma_i) but for terms of order gamma^2.
TEST(SpringModel, RatesManyDecadesApart) {
  const SpringModel model = spring_model(prony(1, {1e-6, 1e-6}, {1e-8, 1e6}), 1);
  EXPECT_NEAR(model.recovery.rates.minCoeff() * 1e6 * (1 + 1e-6), 1, 1e-8);
  EXPECT_NEAR(model.recovery.rates.maxCoeff() * 1e-8 * (1 + 1e-6), 1, 1e-8);
}

// The dashpots' depths under the harmonic motion reproduce its force.
TEST(SpringModel, HarmonicMotionIsConsistent) {
  const SpringModel model = spring_model(prony(2, {2, 6}, {0.3, 4}, 0.1), 1.5);
  for (const double theta : {0.0, 1.0, 4.0}) {
    const double u = 0.7 + std::cos(theta);
    const double force = u + (model.branch_moduli * (u - harmonic_branch_depths(model, 0.7, theta))).sum() -
                         model.viscosity * std::sin(theta);
    EXPECT_NEAR(harmonic_force(model, 0.7, theta), force, 1e-14);
  }
}

TEST(SpringModel, RejectsBadArguments) {
  EXPECT_THROW(spring_model(elastic(1), 0), std::invalid_argument);
  EXPECT_THROW(spring_model(PronyBody{0, {}, {}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::spring_model_test
