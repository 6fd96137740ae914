#include "mdr/rheology/branch_merging.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <stdexcept>

namespace fretval::mdr::branch_merging_test {
namespace {

constexpr double two_pi = 6.283185307179586;

/// 46 branches, three a decade, from 1e-12 s to 1e3 s.
PronyBody wide_body() {
  PronyBody body{1e6, {}, {}};
  for (int k = -36; k <= 9; ++k) {
    body.branch_moduli.push_back(3e5 * (1 + 0.3 * std::sin(k)));
    body.branch_times.push_back(std::pow(10, k / 3.0));
  }
  return body;
}

double largest_change(const PronyBody& one, const PronyBody& other, double lowest, double highest) {
  double worst = 0;
  for (double f = lowest; f <= highest; f *= 1.07) {
    const auto exact = complex_modulus(one, two_pi * f);
    worst = std::max(worst, std::abs(complex_modulus(other, two_pi * f) - exact) / std::abs(exact));
  }
  return worst;
}

TEST(BranchMerging, KeepsTheModulusWithinTheStatedError) {
  const auto body = wide_body();
  const auto [merged_body, n_merged, error] = merged(body, 1e-3, 3e3, 1e-3);
  EXPECT_LE(error, 1e-3);
  EXPECT_LE(largest_change(body, merged_body, 1e-3, 3e3), 1.05 * error);
  EXPECT_EQ(merged_body.branch_moduli.size() + n_merged, body.branch_moduli.size());
  EXPECT_LE(merged_body.branch_moduli.size(), 26U);
  EXPECT_EQ(merged_body.relaxed_modulus, body.relaxed_modulus);
}

// Of a spectrum without gaps as many are left as the range asks for, however many there were.
TEST(BranchMerging, LeavesAsFewOfManyBranchesAsOfFew) {
  const auto few = [](int per_decade) {
    PronyBody body{1e6, {}, {}};
    for (int k = -9 * per_decade; k <= 3 * per_decade; ++k) {
      body.branch_moduli.push_back(6e5 / per_decade);
      body.branch_times.push_back(std::pow(10, static_cast<double>(k) / per_decade));
    }
    const auto result = merged(body, 1, 300, 1e-4);
    EXPECT_LE(largest_change(body, result.body, 1, 300), 1.1e-4);
    return result.body.branch_times.size();
  };
  EXPECT_LE(few(4), 12U);
  EXPECT_LE(few(16), few(4) + 1);
}

TEST(BranchMerging, OfNoneIsTheBodyItself) {
  const auto body = wide_body();
  const auto same = merged(body, 1e-14, 1e14, 0);
  EXPECT_EQ(same.n_merged, 0U);
  EXPECT_EQ(same.error, 0);
  EXPECT_EQ(same.body.branch_times, body.branch_times);
}

TEST(BranchMerging, LeavesOutWhatIsTooFastToBeSeen) {
  const PronyBody body{1e6, {1e6, 2e5}, {1, 1e-12}};
  const auto few = merged(body, 0.1, 10, 1e-6);
  EXPECT_EQ(few.body.branch_times, (std::vector<double>{1}));
  EXPECT_NEAR(few.error, 0, 1e-9);
}

TEST(BranchMerging, HastensWhatIsTooSlowToBeSeen) {
  const PronyBody body{1e6, {1e6, 5e5}, {0.1, 1e9}};
  const auto few = merged(body, 1, 10, 1e-3);
  ASSERT_EQ(few.body.branch_times.size(), 2U);
  // Its loss modulus over the whole is a quarter of 1/(omega tau), and may be half of 1e-3.
  EXPECT_LT(few.body.branch_times[1], 200);
  EXPECT_GT(few.body.branch_times[1], 50);
  EXPECT_LE(few.error, 5e-4);
  EXPECT_EQ(few.body.relaxed_modulus, 1e6);
}

TEST(BranchMerging, OfFastOnesHasTheirViscosity) {
  const PronyBody body{1e6, {1e9, 2e9, 4e8}, {1e-5, 2e-5, 3e-5}};
  const auto few = merged(body, 0.1, 10, 1e-2);
  double viscosity = 0;
  for (std::size_t i = 0; i < few.body.branch_moduli.size(); ++i)
    viscosity += few.body.branch_moduli[i] * few.body.branch_times[i];
  EXPECT_EQ(few.body.branch_moduli.size(), 1U);
  EXPECT_NEAR(viscosity, 1e4 + 4e4 + 1.2e4, 1e-6);
}

TEST(BranchMerging, RefusesWhatIsNone) {
  EXPECT_THROW(merged(wide_body(), 0, 1, 1e-3), std::invalid_argument);
  EXPECT_THROW(merged(wide_body(), 2, 1, 1e-3), std::invalid_argument);
  EXPECT_THROW(merged({0, {}, {}}, 1, 2, 1e-3), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::branch_merging_test
