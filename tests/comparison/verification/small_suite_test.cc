#include <gtest/gtest.h>

#include <algorithm>

#include "comparison/verification/suite.h"
#include "comparison/verification/suites.h"
#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

/// How many of the cases on the fine mesh agree after the finite element side was tampered with. It has the tighter
/// tolerances; one mesh is enough to show that a guard works.
std::size_t n_agree_if(const std::function<void(FemCase&)>& tamper) {
  auto cases = small_cases(small_meshes());
  cases.erase(
      std::remove_if(cases.begin(), cases.end(), [](const SuiteCase& one) { return one.family != "fine mesh"; }),
      cases.end());
  for (auto& one : cases)
    one.change = [tamper, change = one.change](PreparedCase& prepared) {
      change(prepared);
      tamper(prepared.fem);
    };
  const auto rows = run_suite("small", "", cases).rows;
  EXPECT_EQ(rows.size(), 3U);
  for (const auto& row : rows) EXPECT_EQ(row.compared.size(), 4U) << failure_of(row);
  return count(rows, RowVerdict::agrees);
}

TEST(SmallSuite, AgreesOnTheCommittedMeshes) {
  const auto run = run_small_suite(small_meshes());
  ASSERT_EQ(run.rows.size(), 6U);
  EXPECT_EQ(count(run.rows, RowVerdict::agrees), 6U) << remarks_of(run);
  for (const auto& row : run.rows) EXPECT_EQ(row.compared.size(), 4U) << row.asked.name;
}

TEST(SmallSuiteGuard, AgreesUntampered) {
  EXPECT_EQ(n_agree_if([](FemCase&) {}), 3U);
}

TEST(SmallSuiteGuard, FailsWithoutFriction) {
  EXPECT_EQ(n_agree_if([](FemCase& fem) { fem.friction_coefficient = 0; }), 0U);
}

TEST(SmallSuiteGuard, FailsWithoutNormalOscillation) {
  EXPECT_EQ(n_agree_if([](FemCase& fem) { fem.motion.normal.front().amplitude = 0; }), 0U);
}

TEST(SmallSuiteGuard, FailsWithoutViscosity) {
  EXPECT_EQ(n_agree_if([](FemCase& fem) { fem.relaxation = {}; }), 0U);
}

TEST(SmallSuiteGuard, FailsWithAnotherPhase) {
  EXPECT_EQ(n_agree_if([](FemCase& fem) { fem.motion.tangential.front().phase += 0.1; }), 0U);
}

TEST(SmallSuiteGuard, FailsWithAnotherProfile) {
  EXPECT_EQ(n_agree_if([](FemCase& fem) { fem.profile = [f = fem.profile](double r) { return 1.01 * f(r); }; }), 0U);
}

}  // namespace
}  // namespace fretval
