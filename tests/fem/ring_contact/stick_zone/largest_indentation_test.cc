#include "fem/ring_contact/stick_zone/largest_indentation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::largest_indentation_test {
namespace {

/// A cycle of 8 steps at a contact radius of 0.5, whose force is uncertain by 1e-3 in one of them.
NormalHistory uncertain_once() {
  NormalHistory history;
  history.steps_per_cycle = 8;
  history.largest_indentation = 0.7;
  history.contact_radius = Eigen::VectorXd::Constant(8, 0.5);
  history.force_uncertainty = history.force_beyond_uncertainty = Eigen::VectorXd::Zero(8);
  history.force_uncertainty[3] = 1e-3;
  return history;
}

// An elastic flat punch of radius 0.5 gives way by dF/(8 a), in that step alone.
TEST(LargestIndentation, OfAnElasticBodyIsOffByTheForceOverItsStiffness) {
  const auto [value, uncertainty] = largest_indentation(normal_half_space(32), elastic_body(), uncertain_once());
  EXPECT_EQ(value, 0.7);
  EXPECT_NEAR(uncertainty, 1e-3 / (8 * 0.5), 1e-3 * uncertainty);
}

// What bears beyond the edge has an uncertainty of its own, and the punch has the radius of its step.
TEST(LargestIndentation, IsOffByAllForcesAtTheRadiusOfTheirStep) {
  auto history = uncertain_once();
  history.contact_radius = Eigen::VectorXd::LinSpaced(8, 0.2, 0.9);
  history.force_beyond_uncertainty[3] = 2e-3;
  EXPECT_NEAR(largest_indentation(normal_half_space(32), elastic_body(), history).uncertainty, 3e-3 / (8 * 0.5), 1e-6);
}

// In steps of 0.5 a dashpot gives way by dF/(8 a) over its response to one of them. What it has moved by in a cycle
// dies out slowly, and adds up with that of the next one.
TEST(LargestIndentation, OfADashpotGoesWithTheLengthsOfItsStepsAndAddsUp) {
  auto history = uncertain_once();
  for (int k = 0; k < 8; ++k) history.pieces.push_back({0.5 * k, 0.5 * (k + 1), true, true});
  const RelaxationModel body{1, {}, {}, 100};
  const double response = RelaxationStep(body, 0.5).instantaneous(), once = 1e-3 / (8 * 0.5) / response;
  EXPECT_NEAR(largest_indentation(normal_half_space(32), body, history).uncertainty,
              once * (1 + std::pow(1 - 1 / response, 8)), 2e-3 * once);
}

// A dashpot gives way slowly: by dF/(8 a) over its response in a step, and goes on from there if the next force is off.
TEST(LargestIndentation, OfAStiffDashpotIsHardlyOff) {
  RelaxationModel body{1, {}, {}, 100};
  auto history = uncertain_once();
  const double once = largest_indentation(normal_half_space(32), body, history).uncertainty;
  EXPECT_LT(once, 0.02 * 1e-3 / (8 * 0.5));  // in either of two cycles a 128th
  history.force_uncertainty[4] = 1e-3;
  EXPECT_NEAR(largest_indentation(normal_half_space(32), body, history).uncertainty, 2 * once, 0.02 * once);
}

// For ever so: by that force over the relaxed stiffness at most.
TEST(LargestIndentation, OfAForceThatIsAlwaysOffIsBounded) {
  auto history = uncertain_once();
  history.force_uncertainty.setConstant(1e-3);
  for (const auto& body : {elastic_body(), standard_solid(), kelvin_voigt()})
    EXPECT_LE(largest_indentation(normal_half_space(32), body, history).uncertainty, 1.001e-3 / (8 * 0.5));
}

}  // namespace
}  // namespace fretval::fem::largest_indentation_test
