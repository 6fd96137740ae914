#include "comparison/simulation/bodies/normal_store.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "tests/comparison/computed_case.h"
#include "tests/comparison/small_body.h"

namespace fretval {
namespace {

/// Normal histories on a small body, from a store.
class NormalStoreTest : public testing::Test {
 protected:
  explicit NormalStoreTest(std::size_t room = 1 << 20) : store_(room) {
    case_.body = small_body();
    case_.relaxation = {1, {1}, {0.5}};
    case_.motion = {0.25, {{0.05, 1}}, {{0.02, 1, 0.5}}};
    case_.motion.n_ramp_cycles = 1;
    case_.friction_coefficient = 0.5;
  }

  std::shared_ptr<const NormalRecord> record() {
    return store_.find_or_make(case_, body_.normal, &body_.tangential->series, profile_, control_);
  }

  FemCase case_;
  Eigen::VectorXd profile_ = Eigen::Vector4d(0.01, 0.1, 0.4, 0.8);
  fem::HistoryControl control_{16, 100, 1e-3};

  ContactBody body_ = contact_body(make_body(small_body()));

 private:
  NormalStore store_;
};

TEST_F(NormalStoreTest, KeepsEveryPressureSinceTheStart) {
  const auto made = record();
  ASSERT_EQ(made->pressures.size(), static_cast<std::size_t>(1 + made->history.n_steps()));
  EXPECT_EQ(made->pressures.back(), made->history.pressure.rightCols(1));
  EXPECT_GT(made->pressures.front().maxCoeff(), 0) << "at rest under the mean indentation";
  const auto& series = body_.tangential->series;
  ASSERT_EQ(made->depths.size(), made->pressures.size());
  EXPECT_EQ(made->depths.back(), series.depths(made->pressures.back()));
  const auto last = made->history.instant(made->history.pressure.cols() - 1);
  EXPECT_EQ(Eigen::VectorXd(last->pressure_depths.value()), made->depths.back());
}

TEST_F(NormalStoreTest, SharesWhatDiffersInFrictionAlone) {
  const auto made = record();
  case_.friction_coefficient = 0.1;
  case_.motion.tangential.front().amplitude = 0.01;
  case_.motion.tangential.front().phase = 2;
  case_.motion.locked = false;
  EXPECT_EQ(record(), made);
}

TEST_F(NormalStoreTest, MakesAnotherForAnythingElse) {
  std::set<std::shared_ptr<const NormalRecord>> records{record()};
  const auto change = [&](auto& value, auto other) {
    const auto before = std::exchange(value, other);
    records.insert(record());
    value = before;
  };
  change(case_.body.growth, 0.4);
  change(case_.relaxation.relaxed, 2);
  change(case_.relaxation.viscosity, 0.1);
  change(case_.relaxation.moduli[0], 2);
  change(case_.relaxation.times[0], 0.3);
  change(case_.motion.indentation, 0.2);
  change(case_.motion.n_ramp_cycles, 2);
  change(case_.motion.normal[0].amplitude, 0.04);
  change(case_.motion.normal[0].order, 2);
  change(case_.motion.normal[0].phase, 0.1);
  change(case_.motion.tangential[0].order, 2);
  change(profile_[1], 0.15);
  change(control_.steps_per_cycle, 20);
  change(control_.max_cycles, 90);
  change(control_.periodicity, 1e-4);
  EXPECT_EQ(records.size(), 16U);
}

class FullNormalStoreTest : public NormalStoreTest {
 protected:
  FullNormalStoreTest() : NormalStoreTest(1) {}
};

TEST_F(FullNormalStoreTest, LetsTheOldestGo) {
  const auto first = record();
  EXPECT_EQ(record(), first) << "the latest one stays, whatever the room";
  control_.steps_per_cycle = 20;
  record();
  control_.steps_per_cycle = 16;
  const auto again = record();
  EXPECT_NE(again, first);
  EXPECT_EQ(again->pressures, first->pressures);
}

// From a store of its own a case gets the same numbers.
TEST(NormalStore, DoesNotChangeAnAnswer) {
  const auto input = fixed_case("parabola-solid-90", 16, 24);
  auto fem = prepare({input}).front().fem;
  BodyStore shared, own;
  const auto other = compute_case(fem, fem.resolution, shared);
  fem.motion.tangential.front().phase += 1;
  const auto second = compute_case(fem, fem.resolution, shared), alone = compute_case(fem, fem.resolution, own);
  EXPECT_EQ(second.stick_radius_shakedown.value(), alone.stick_radius_shakedown.value());
  EXPECT_EQ(second.stick_radius_first_slip.value(), alone.stick_radius_first_slip.value());
  EXPECT_EQ(second.friction.traction, alone.friction.traction);
  EXPECT_NE(second.stick_radius_shakedown, other.stick_radius_shakedown);
}

}  // namespace
}  // namespace fretval
