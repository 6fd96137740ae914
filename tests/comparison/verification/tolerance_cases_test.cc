#include <gtest/gtest.h>

#include <map>
#include <set>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/verification/suites.h"
#include "mdr/stick/stick_radius.h"
#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

TEST(ToleranceCases, AreFiftyAndCoverWhatTheyShould) {
  std::set<std::string> rheologies, names;
  std::set<Case::Shape> shapes;
  int n_unlocked = 0, n_at_rest = 0, n_without_first_slip = 0, n_small = 0, n_narrow = 0;
  for (const auto& one : tolerance_cases(1e-3)) {
    EXPECT_TRUE(one.must_be_conclusive);
    EXPECT_EQ(one.proof, Proof::tolerance);
    EXPECT_EQ(one.refusal, "");
    const auto prepared = prepare({case_of(one)}).front();
    const auto& input = prepared.input;
    EXPECT_EQ(input.tolerance, 1e-3);
    names.insert(one.name);
    rheologies.insert(input.elastomer.rheology_name());
    shapes.insert(input.indenter.shape);
    n_unlocked += !input.motion.phase;
    n_at_rest += input.motion.tangential_amplitude == 0;
    const auto& mdr = prepared.mdr;
    const auto radii = mdr::stick_radii(mdr.profile, mdr.body, mdr.friction_coefficient, mdr.motion);
    n_without_first_slip += !radii.first_slip;
    const double c = radii.shakedown.value_or(0) / prepared.fem.units.length;
    n_small += c > 0 && c < 0.11;
    n_narrow += c > 0.98 && c < 1;
  }
  EXPECT_EQ(names.size(), 50U);
  EXPECT_EQ(rheologies.size(), 4U);
  EXPECT_EQ(shapes.size(), 5U);
  EXPECT_GE(n_unlocked, 3);
  EXPECT_EQ(n_at_rest, 2);
  EXPECT_GE(n_without_first_slip, 2);
  EXPECT_GE(n_small, 5);
  EXPECT_GE(n_narrow, 4);
}

// k = 3 mu Delta d/(2 u_x0), and A/d0 with A = 2 u_x0/(3 mu).
TEST(ToleranceCases, HaveTheAmplitudesThatTheirNumbersMean) {
  std::map<std::string, Case::Motion> motions;
  for (const auto& one : tolerance_cases(1e-3)) motions.emplace(one.name, case_of(one).motion);
  const auto k = [&](const char* name, double friction) {
    const auto& motion = motions.at(name);
    return 1.5 * friction * motion.normal_amplitude / motion.tangential_amplitude;
  };
  EXPECT_NEAR(k("parabola-elastic-45", 0.7), 2, 1e-9);
  EXPECT_NEAR(k("parabola-elastic-135", 0.2), 0.3, 1e-9);
  EXPECT_NEAR(k("cone-voigt-120", 0.3), 0.5625, 1e-9);
  const auto& steady = motions.at("parabola-elastic-steady");
  EXPECT_NEAR(steady.tangential_amplitude / (1.5 * 0.5 * steady.indentation), 0.3, 1e-9);
}

std::vector<SuiteCase> some_cases() {
  std::vector<SuiteCase> some;
  for (const auto& one : tolerance_cases(1e-2))
    if (one.name == "parabola-elastic-90" || one.name == "cone-solid-45") some.push_back(one);
  return some;
}

TEST(ToleranceSuite, MeetsATolerance) {
  const auto run = run_suite("tolerance", "", some_cases());
  ASSERT_EQ(run.rows.size(), 2U);
  for (const auto& row : run.rows) {
    EXPECT_EQ(verdict_of(row), RowVerdict::agrees) << remarks_of(run);
    for (const auto& [quantity, q] : row.compared) EXPECT_LE(std::abs(q.error()), q.tolerance) << name_of(quantity);
  }
}

TEST(ToleranceSuiteGuard, ReportsAMissForAnotherCase) {
  auto cases = some_cases();
  for (auto& one : cases) one.change = [](PreparedCase& prepared) { prepared.fem.friction_coefficient *= 1.4; };
  for (const auto& row : run_suite("tolerance", "", cases).rows) {
    EXPECT_EQ(verdict_of(row), RowVerdict::fails);
    const auto& c = row.compared.at(Quantity::stick_radius_shakedown);
    EXPECT_GT(std::abs(c.error()), c.tolerance);
  }
}

}  // namespace
}  // namespace fretval
