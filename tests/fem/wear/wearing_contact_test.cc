#include "fem/wear/wearing_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/fem/wear/wearing_half_space.h"

namespace fretval::fem::wearing_contact_test {
namespace {

// A few cycles at once wear off what as many would at the rate of the last one; roundoff but for the fall of pressure.
// Also where a period of the motion has several of them.
TEST(WearingContact, WearsOffTheRateTimesTheCycles) {
  WearingHalfSpace half_space;
  for (const bool locked : {true, false}) {
    half_space.motion.locked = locked;
    half_space.motion.n_creep_cycles = 3;
    auto contact = half_space.contact({1e-3});
    contact.settle();
    const Eigen::VectorXd rate = contact.period().rate;
    ASSERT_GT(rate.maxCoeff(), 0);
    contact.wear_off(1e-3);
    EXPECT_LT((contact.worn() - 1e-3 * rate).cwiseAbs().maxCoeff(), 1e-5 * 1e-3 * rate.maxCoeff()) << locked;
  }
}

TEST(WearingContact, KnowsItsTangentialAmplitudeBySteps) {
  WearingHalfSpace half_space;
  auto contact = half_space.contact({1e-3});
  contact.settle();
  EXPECT_NEAR(contact.period().tangential_amplitude / half_space.motion.tangential_amplitude(), 1, 1e-2);
}

// The rate itself: k p^m |ds| of each step, by trapezoids, over the cycles of the period.
TEST(WearingContact, RateIsTheLawAtSlipAndPressure) {
  WearingHalfSpace half_space;
  half_space.motion.n_creep_cycles = 3;
  for (const auto& [exponent, n_cycles] : {std::pair(1.0, 1), {2.0, 1}, {1.0, 3}}) {
    half_space.motion.locked = n_cycles == 1;
    auto contact = half_space.contact({0.3, exponent});
    contact.settle();
    const auto& [slip, pressure, traction, path, rate, largest, work, indentation, amplitude] = contact.period();
    const Eigen::Index n_steps = slip.cols();
    const Eigen::ArrayXXd law = pressure.array().pow(exponent);
    Eigen::ArrayXd depth = Eigen::ArrayXd::Zero(rate.size());
    for (Eigen::Index k = 0; k < n_steps; ++k)
      depth += 0.3 / n_cycles * slip.col(k).array().abs() * (law.col((k + n_steps - 1) % n_steps) + law.col(k)) / 2;
    EXPECT_LT((depth - rate.array()).abs().maxCoeff(), 1e-12 * rate.maxCoeff());
  }
}

// What slips bears mu p: but for the steps in which slip begins, whose tractions were less before.
TEST(WearingContact, RateIsTheWorkOfFrictionToSecondOrder) {
  WearingHalfSpace half_space;
  const auto error = [&half_space](int n_steps) {
    half_space.n_steps = n_steps;
    auto contact = half_space.contact({0.3});
    contact.settle();
    const auto& period = contact.period();
    return period.friction_work * 0.3 / WearingHalfSpace::mu / period.rate.dot(half_space.normal.compliance.areas) - 1;
  };
  const double coarse = error(72);
  EXPECT_LT(std::abs(coarse), 2e-3);
  EXPECT_LT(std::abs(error(288)), std::abs(coarse) / 10);
}

// In phase and below 2 u_x0 = 3 mu Dd = 0.3 what touches sticks. What is left is of rings that touch inside a step,
// which are held from its beginning.
TEST(WearingContact, HardlyWearsInPhase) {
  WearingHalfSpace half_space;
  half_space.motion = one_frequency(0.8, 0.2, 0.14, 0);
  half_space.motion.n_ramp_cycles = 2;
  const auto work = [&half_space](int n_steps) {
    half_space.n_steps = n_steps;
    auto contact = half_space.contact({0.3});
    contact.settle();
    EXPECT_EQ(contact.period().slip.topRows(24).cwiseAbs().maxCoeff(), 0);  // never open
    return contact.period().friction_work;
  };
  const double coarse = work(72);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(work(288), coarse / 12);
}

// However many cycles, none wears beyond the plane of the largest indentation, where nothing bears any more.
TEST(WearingContact, HoweverManyCyclesWearNoDeeperThanThePressure) {
  const WearingHalfSpace half_space;
  auto contact = half_space.contact({1e-3});
  contact.settle();
  contact.wear_off(1e12);
  const Eigen::VectorXd worn = contact.worn();
  EXPECT_GT(worn.maxCoeff(), 0.1);
  const Eigen::VectorXd height = half_space.profile + worn;
  EXPECT_LT((worn.array() > 0).select(height, 0).maxCoeff(), 1);
}

// Of a ring in the middle, one in the slip zone, and one that never touches.
TEST(WearingContact, ZonesStickSlipAndOpen) {
  const WearingHalfSpace half_space;
  auto contact = half_space.contact({1e-3});
  contact.settle();
  const auto& period = contact.period();
  const Eigen::Index n = half_space.profile.size();
  int forward = 0, backward = 0;
  for (Eigen::Index k = 0; k < period.slip.cols(); ++k) {
    EXPECT_EQ(period.zone(2, k), 's');
    EXPECT_EQ(period.zone(n - 1, k), 'o');
    forward += period.zone(24, k) == 'f' ? 1 : 0;
    backward += period.zone(24, k) == 'b' ? 1 : 0;
  }
  EXPECT_GT(forward, 5);
  EXPECT_GT(backward, 5);
}

}  // namespace
}  // namespace fretval::fem::wearing_contact_test
