#include "mdr/stick/slip_decay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/mdr/error_of.h"

namespace fretval::mdr::slip_decay_test {
namespace {

TEST(SlipDecay, OfOneBranchIsItsClosedForm) {
  for (const double time : {0.05, 1.0, 40.0}) {
    const double q = std::exp(-1 / time);
    EXPECT_NEAR(slip_decay(prony(2, {6}, {time}), 1).value(), (2 * q + 6) / 8, 1e-14) << time;
  }
}

// The slips that keep an element within its limit, one after the other.
TEST(SlipDecay, IsThatOfSlipsWhichHoldTheLimit) {
  const auto body = prony(1, {2, 0.5, 3}, {0.3, 4, 0.9});
  const auto modulus = [&body](double t) {
    double sum = body.relaxed_modulus;
    for (std::size_t i = 0; i < body.branch_times.size(); ++i)
      sum += body.branch_moduli[i] * std::exp(-t / body.branch_times[i]);
    return sum;
  };
  std::vector<double> slips;
  for (int n = 0; n < 200; ++n) {
    double left = 1;
    for (int k = 0; k < n; ++k) left -= slips[static_cast<std::size_t>(k)] * modulus(n - k);
    slips.push_back(left / modulus(0));
  }
  EXPECT_NEAR(slip_decay(body, 1).value(), slips[199] / slips[198], 1e-9);
}

TEST(SlipDecay, NeedsBranchesAndNoDashpot) {
  EXPECT_FALSE(slip_decay(elastic(1), 1));
  EXPECT_FALSE(slip_decay(prony(1, {1}, {1}, 0.1), 1));
  EXPECT_NE(error_of([] { static_cast<void>(slip_decay(elastic(1), 0)); }), "accepted");
}

}  // namespace
}  // namespace fretval::mdr::slip_decay_test
