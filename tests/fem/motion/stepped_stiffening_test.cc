#include "fem/motion/stepped_stiffening.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fem/support/constants.h"

namespace fretval::fem::stepped_stiffening_test {
namespace {

const RelaxationModel short_branches{2, {32, 9}, {2 * pi / 252, 2 * pi / 158}, 0}, with_dashpot{1, {3}, {0.4}, 0.5};

// A spring that follows an oscillating force, stepped until it repeats.
TEST(SteppedStiffening, IsThatOfASpringThatIsStepped) {
  for (const auto& model : {short_branches, with_dashpot})
    for (const int n_steps : {16, 64}) {
      const double dt = 2 * pi / n_steps;
      const RelaxationStep step(model, dt);
      RingState spring{Eigen::VectorXd::Zero(1), Eigen::MatrixXd::Zero(1, step.n_branches())};
      std::vector<double> displacements;
      for (int k = 0; k < 40 * n_steps; ++k) {
        const double force = std::cos((k + step.fraction()) * dt);
        const Eigen::VectorXd slip =
            (step.response_without_slip(spring, standing_still) - Eigen::VectorXd::Constant(1, force)) /
            step.instantaneous();
        step.advance(spring, standing_still, slip);
        displacements.push_back(spring.displacement[0]);
      }
      const auto last = displacements.end() - 1;
      const double amplitude = std::hypot(*last, *(last - n_steps / 4));  // a quarter of a period apart
      EXPECT_NEAR(amplitude * model.relaxed * std::abs(stepped_stiffening_at(model, 1, dt)), 1, 1e-9) << n_steps;
    }
}

TEST(SteppedStiffening, TendsToThatOfTheBodyWithTheSquareOfItsSteps) {
  for (const auto& model : {short_branches, with_dashpot}) {
    const auto off = [&](int n) {
      return std::abs(stepped_stiffening_at(model, 3, 2 * pi / n) / stiffening_at(model, 3) - 1.0);
    };
    EXPECT_LT(off(20000), 1e-5);
    EXPECT_NEAR(off(20000) / off(40000), 4, 0.1);
  }
}

// So that 16 and 32 steps are closer to each other than to the body.
TEST(SteppedStiffening, ErrsByLessInLongStepsIfBranchesAreShorter) {
  const auto off = [](int n) {
    return std::abs(stiffening_at(short_branches, 1)) / std::abs(stepped_stiffening_at(short_branches, 1, 2 * pi / n)) -
           1;
  };
  EXPECT_GT(off(32), off(16));
  EXPECT_GT(off(32), 3 * (off(32) - off(16)));
  EXPECT_LT(off(128), off(32) / 3);
}

}  // namespace
}  // namespace fretval::fem::stepped_stiffening_test
