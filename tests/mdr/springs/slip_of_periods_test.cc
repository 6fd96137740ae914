#include "mdr/springs/slip_of_periods.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mdr/stick/slip_decay.h"
#include "mdr/stick/stick_radius.h"
#include "tests/mdr/error_of.h"

namespace fretval::mdr::slip_of_periods_test {
namespace {

constexpr double mu = 0.5;
const auto profile = parabola(1e-2);
// Shakes down between the radii of first slip and of shakedown.
const Prescribed prescribed{{1e-4, {{2e-5, 10, 0}}, {{1.5e-5, 10, 1}}, true}, false, false};

std::vector<double> slips(const PronyBody& body, double radius, int n_ramp, double least = -1) {
  return slip_of_periods(profile, body, mu, prescribed, radius, n_ramp, least, {100, 90});
}

double shakedown_radius(const PronyBody& body) {
  return inverse_transform(profile, stick_depths(body, mu, prescribed.motion).shakedown);
}

TEST(SlipOfPeriods, FallsInTheEndByTheFactorOfTheBody) {
  const auto body = prony(1e6, {1e6}, {0.1});
  const auto of = slips(body, shakedown_radius(body), 4);
  std::size_t n = of.size();
  while (of[n - 1] < 1e-10) --n;
  ASSERT_GT(n, 7U);
  EXPECT_NEAR(of[n - 1] / of[n - 2], slip_decay(body, 0.1).value(), 2e-2);
  EXPECT_GT(*std::max_element(of.begin(), of.end()), 1e-7);
}

TEST(SlipOfPeriods, OfAnElasticBodyEndsWithTheFirstFullPeriod) {
  const auto body = elastic(1e6);
  const auto of = slips(body, shakedown_radius(body), 2);
  ASSERT_GT(of.size(), 3U);
  EXPECT_GT(of[1], 1e-9);
  for (std::size_t n = 3; n < of.size(); ++n) EXPECT_LT(of[n], 1e-4 * of[1]);
}

TEST(SlipOfPeriods, IsNoneWhereNothingEverSlips) {
  const auto body = prony(1e6, {1e6}, {0.1});
  const auto never = inverse_transform(profile, stick_depths(body, mu, prescribed.motion).first_slip);
  for (const double slip : slips(body, 0.95 * never, 4)) EXPECT_EQ(slip, 0);
}

// With hardly any friction all of the surface slips there and back. The root at c costs the sum over springs its 1.5th
// order.
TEST(SlipOfPeriods, IsTheMeanOverTheArea) {
  const auto of = slip_of_periods(profile, elastic(1e6), 1e-6, prescribed, 5e-4, 2, -1, {400, 90});
  EXPECT_NEAR(of.back() / (4 * 1.5e-5), 1, 5e-4);
}

TEST(SlipOfPeriods, EndsWithTheFirstPeriodOfLittleSlip) {
  const auto body = prony(1e6, {1e6}, {0.1});
  const auto all = slips(body, shakedown_radius(body), 4), some = slips(body, shakedown_radius(body), 4, 1e-9);
  ASSERT_LT(some.size(), all.size());
  EXPECT_LE(some.back(), 1e-9);
  EXPECT_GT(some[some.size() - 2], 1e-9);
  for (std::size_t n = 0; n < some.size(); ++n) EXPECT_EQ(some[n], all[n]);
}

TEST(SlipOfPeriods, NeedsAPeriod) {
  auto unlocked = prescribed;
  unlocked.motion.phase_locked = false;
  EXPECT_NE(error_of([&] {
              slip_of_periods(profile, elastic(1e6), mu, unlocked, 1e-3, 4, -1, {100, 90});
            }),
            "accepted");
}

}  // namespace
}  // namespace fretval::mdr::slip_of_periods_test
