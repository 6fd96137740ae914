#include "mdr/springs/path_history.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace fretval::mdr::path_history_test {
namespace {

TEST(PathHistory, ExtrapolatesWhatIsOfSecondOrder) {
  PathForces coarse{}, exact{};
  exact.friction_work = 1;
  SteppedPathForces stepped{exact, {}, {}};
  stepped.forces.friction_work = 1 + 0.25e-2;
  coarse.friction_work = 1 + 1e-2;
  extrapolate(coarse, stepped);
  EXPECT_NEAR(stepped.forces.friction_work, 1, 1e-15);
  EXPECT_NEAR(stepped.error.friction_work, 0.75e-2, 1e-15);
}

TEST(PathHistory, TellsTheNumbersOfACourse) {
  SpringHistory history{};
  history.time = {0, 1, 3};
  history.normal_force = {1, 4, 2};
  history.tangential_force = {0, 1, -3};
  history.indentation = {1, 2, 1.5};
  history.tangential_displacement = {0, 0.5, -0.25};
  history.axis_pressure = {1, 2, 3};
  const auto forces = forces_of(history);
  EXPECT_EQ(forces.normal_force_max, 4);
  EXPECT_EQ(forces.normal_force_min, 1);
  EXPECT_EQ(forces.tangential_force_max, 3);
  EXPECT_NEAR(forces.tangential_force_mean, (0.5 - 2) / 3, 1e-15);
  EXPECT_EQ(forces.tangential_amplitude, 0.375);
  EXPECT_EQ(forces.tangential_way, 1.25);
  EXPECT_EQ(forces.largest_indentation, 2);
}

TEST(PathHistory, RefusesBadFineness) {
  const SampledPath pull{{0, 1}, {1, 1}, {0, 0.3}, false};
  EXPECT_NO_THROW(validate_along_path(pull, {}));
  EXPECT_THROW(validate_along_path(pull, {200, 0}), std::invalid_argument);
  EXPECT_THROW(validate_along_path(pull, {200, 180, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::path_history_test
