#include "comparison/case/test_duration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/data/path_table.h"
#include "mdr/rheology/prony_body.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

namespace fretval::test_duration_test {
namespace {

/// 30 branches over 15 decades, from 1e-6 s.
Case wide_case() {
  auto input = read_case();
  auto& body = input.elastomer;
  body.rheology = Case::Rheology::prony;
  body.branch_moduli.clear();
  body.branch_times.clear();
  for (int k = 0; k < 30; ++k) {
    body.branch_moduli.push_back(1e5);
    body.branch_times.push_back(std::pow(10, -6 + 0.5 * k));
  }
  return input;
}

TEST(TestDuration, MakesSpringsOfWhatIsSlower) {
  auto input = wide_case();
  limit_to_test(3600, input);
  const auto& body = input.elastomer;
  // Branches from 1e4 s to 3e8 s: ten.
  EXPECT_EQ(body.test_duration->n_slow, 10U);
  EXPECT_NEAR(body.relaxed_modulus, 1e6 + 10 * 1e5, 1e-3);
  EXPECT_EQ(body.test_duration->near_times.size(), 2U);
  EXPECT_NEAR(body.test_duration->near_times[1], 1e4, 1e-6);
  EXPECT_EQ(body.test_duration->relaxed_modulus, 1e6);
}

TEST(TestDuration, MergesWhatNobodySees) {
  auto input = wide_case();
  limit_to_test(3600, input);
  const auto& body = input.elastomer;
  EXPECT_LE(body.test_duration->merging_error, 0.1 * input.tolerance);
  EXPECT_GT(body.test_duration->n_fast, 5U);
  EXPECT_EQ(body.branch_times.size() + body.test_duration->n_fast + body.test_duration->n_slow, 30U);
  const auto all = wide_case().elastomer;
  const auto exact = mdr::complex_modulus(mdr::prony(all.relaxed_modulus, all.branch_moduli, all.branch_times), 6.28);
  const auto merged =
      mdr::complex_modulus(mdr::prony(body.relaxed_modulus, body.branch_moduli, body.branch_times), 6.28);
  // At 1 Hz a branch of 1e4 s is a spring within 1e-9.
  EXPECT_NEAR(std::abs(merged - exact) / std::abs(exact), 0, 1.01 * body.test_duration->merging_error + 1e-8);
}

// No cycle of a periodic state under forces is skipped, by neither method.
TEST(TestDuration, IsAskedForWhereForcesLeaveTooManyCycles) {
  auto input = wide_case();
  EXPECT_EQ(too_slow_for_forces(input), "");
  input.motion.normal_force = Case::NormalForce{1, 0.1};
  expect_parts(too_slow_for_forces(input), {"3.2e+08 s", "set Elastomer / Duration of the test"});
  limit_to_test(3600, input);
  EXPECT_EQ(too_slow_for_forces(input), "");
}

TEST(TestDuration, MayBeLongerAndShorter) {
  auto input = wide_case();
  limit_to_test(3600, input);
  EXPECT_EQ(with_duration_times(3, input).elastomer.test_duration->n_slow, 9U);
  EXPECT_EQ(with_duration_times(1.0 / 3, input).elastomer.test_duration->n_slow, 11U);
  EXPECT_EQ(with_duration_times(1, input).elastomer.relaxed_modulus, input.elastomer.relaxed_modulus);
}

TEST(TestDuration, IsAskedForWhereBranchesAreSlow) {
  const auto slow = times_slower_than(many_cycles, wide_case());
  ASSERT_EQ(slow.size(), 9U);  // slower than 1e4 s: 3e4 s to 3e8 s
  EXPECT_NEAR(slow.front(), std::sqrt(1e9), 1);
  auto input = wide_case();
  limit_to_test(3600, input);
  EXPECT_TRUE(times_slower_than(many_cycles, input).empty());
}

// Ten thousand cycles of 1 Hz are 1e4 s; of 0.01 Hz, 1e6 s.
TEST(TestDuration, CountsTheCyclesOfTheSlowestOscillation) {
  auto input = wide_case();
  input.motion.tangential_frequency = 100;
  EXPECT_EQ(times_slower_than(1e4, input).size(), 9U);
  for (auto* harmonics :
       {&input.motion.normal_harmonics, &input.motion.tangential_harmonics, &input.motion.transverse}) {
    harmonics->push_back({1e-6, 0.01, 0});
    EXPECT_EQ(times_slower_than(1e4, input).size(), 5U) << "slower than 1e6 s: 3e6 s to 3e8 s";
    harmonics->clear();
  }
}

TEST(TestDuration, IsNotAskedForOfAPassUnderForces) {
  auto input = wide_case();
  Case::Path path{{{0, 0.5, 1}, {1, 1.1, 1}, {0, 0.1, 0}, true}, "rows.csv"};
  path.normal_force = true;
  input.motion = motion_along(path);
  expect_parts(too_slow_for_forces(input), {"set Elastomer / Duration of the test"});
  input.motion.path->repeats = false;
  EXPECT_EQ(too_slow_for_forces(input), "");
}

// A single pass of 1 s ends somewhere: what is slower by a hundred still tells.
TEST(TestDuration, KeepsWhatASinglePassShows) {
  auto input = wide_case();
  input.motion = motion_along({{{0, 0.5, 1}, {1e-4, 1.1e-4, 1e-4}, {0, 1e-5, 0}, false}, "rows.csv"});
  limit_to_test(3600, input);
  const auto& body = input.elastomer;
  const auto all = wide_case().elastomer;
  const auto modulus_of = [](const Case::Elastomer& one) {
    return mdr::complex_modulus(mdr::prony(one.relaxed_modulus, one.branch_moduli, one.branch_times), 2 * M_PI * 0.01);
  };
  EXPECT_LT(std::abs(modulus_of(body) / modulus_of(all) - 1.0), 1.01 * body.test_duration->merging_error + 1e-6);
}

TEST(TestDuration, IsAnEntryWithAUnit) {
  const auto with = [](const std::string& value) {
    return read_case(replace(valid_case, "subsection Elastomer\n",
                             "subsection Elastomer\n  set Duration of the test = " + value + "\n"));
  };
  EXPECT_EQ(with("1 h").elastomer.test_duration->seconds, 3600);
  EXPECT_EQ(with("2 min").elastomer.test_duration->seconds, 120);
  EXPECT_EQ(with("1e-3").elastomer.relaxed_modulus, 2e6);  // its only branch relaxes in 0.1 s
  expect_parts(refusal([&] { with("0"); }), {"Duration of the test = 0", "positive"});
  expect_parts(refusal([] {
                 read_case(replace(elastic_case(), "subsection Elastomer\n",
                                   "subsection Elastomer\n  set Duration of the test = 1 h\n"));
               }),
               {"Duration of the test = 1 h", "standard solid or prony or table"});
}

}  // namespace
}  // namespace fretval::test_duration_test
