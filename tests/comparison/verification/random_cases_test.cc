#include <gtest/gtest.h>

#include <set>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/verification/suite.h"
#include "comparison/verification/suites.h"
#include "comparison/verification/written_case.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/suite_rows.h"

namespace fretval::random_cases_test {
namespace {

TEST(RandomCases, AreReproducibleAndVaried) {
  std::set<std::string> shapes, rheologies;
  int n_worn = 0, n_free = 0, n_at_rest = 0, n_layers = 0, n_compressible = 0, n_normal = 0, n_tangential = 0;
  for (std::size_t k = 0; k < 300; ++k) {
    const auto entries = random_entries({1, k});
    if (k < 20) {
      EXPECT_EQ(entries, random_entries({1, k}));
    }
    shapes.insert(entries.at("Indenter / Shape"));
    rheologies.insert(entries.at("Elastomer / Rheology"));
    n_worn += entries.count("Wear / State") > 0 ? 1 : 0;
    n_free += entries.at("Motion / Phase") == "free" ? 1 : 0;
    const auto amplitude = entries.find("Motion / Tangential amplitude");
    n_at_rest += amplitude != entries.end() && amplitude->second == "0" ? 1 : 0;
    n_layers += static_cast<int>(entries.count("Body / Thickness"));
    n_compressible += static_cast<int>(entries.count("Elastomer / Poisson ratio"));
    n_normal += static_cast<int>(entries.count("Motion / Normal force"));
    n_tangential += static_cast<int>(entries.count("Motion / Tangential force amplitude"));
    EXPECT_NE(entries.count("Motion / Normal force"), entries.count("Motion / Indentation"));
  }
  for (const int n : {n_layers, n_compressible}) EXPECT_NEAR(n, 75, 40);
  for (const int n : {n_normal, n_tangential}) EXPECT_NEAR(n, 30, 20);
  EXPECT_EQ(shapes.size(), 6U);
  EXPECT_EQ(rheologies.size(), 5U);
  EXPECT_GT(n_worn, 0);
  EXPECT_GT(n_free, 0);
  EXPECT_GT(n_at_rest, 0);
  EXPECT_NE(random_entries({1, 0}), random_entries({2, 0}));
  EXPECT_NE(random_entries({1, 0}), random_entries({1, 0, 1}));
}

// Each one that the tool refuses as bad input is drawn again, and is a case that nobody looks at.
TEST(RandomCases, AreHardlyEverRefused) {
  int n_refused = 0;
  for (std::size_t k = 0; k < 200; ++k)
    n_refused += refusal([&] { prepare({case_of(random_entries({1, k}), "case")}); }) == "no error" ? 0 : 1;
  EXPECT_LE(n_refused, 2);
}

SuiteRun only(std::size_t number) {
  return run_random_suite({1, 1, number});
}

TEST(RandomSuiteSlow, RunsEveryCaseWithinItsBars) {
  const auto run = run_random_suite({1, 40});
  EXPECT_TRUE(run.passes()) << remarks_of(run);
  ASSERT_EQ(run.rows.size(), 40U);
  EXPECT_GT(suite_json(run)["summary"]["errors"].get<int>(), 150);
  long n_computations = 0;
  for (const auto& row : run.rows) {
    EXPECT_EQ(row.n_refinements, 0);
    n_computations += row.n_computations;
  }
  EXPECT_GT(n_computations, 300);
}

/// A case on the suite's discretisation with its error bars.
SuiteCase found(const std::string& name, Entries indenter, Entries elastomer, double frequency,
                const std::string& phase, const std::map<std::string, double>& numbers, const Entries& others = {}) {
  indenter.merge(elastomer);
  const auto entries = with(with_numbers(indenter, numbers), others);
  SuiteCase one{"", name};
  one.proof = Proof::bars;
  one.text = case_text(with_numbers(with(entries, {{"Friction / Law", "unidirectional"}, {"Motion / Phase", phase}}),
                                    {{"Accuracy / Tolerance", 1e-2},
                                     {"Accuracy / Rings per radius", 32},
                                     {"Accuracy / Steps per cycle", 32},
                                     {"Motion / Normal frequency", frequency},
                                     {"Motion / Tangential frequency", frequency}}));
  return one;
}

// Random cases of which an error was above its bar, by what their bars missed.
TEST(RandomSuiteSlow, KeepsWhatItFoundWithinTheBars) {
  const std::vector<SuiteCase> cases{
      found("a flat face that sticks as a whole, by a depth that is smaller than its error",
            truncated_sphere(6.13832e-05, 1.2856e-07), elastic(199666), 59.1765, "90",
            {{"Friction / Coefficient", 0.0176992},
             {"Motion / Indentation", 1.76586e-09},
             {"Motion / Normal amplitude", 0},
             {"Motion / Tangential amplitude", 4.688146396799999e-11}}),
      found("a phase that drifts faster than the body relaxes", parabola(1.00033e-05),
            branches("prony", 10111300, {926866, 693273000}, {3.27059e-09, 1.57255e-07}), 532810, "free",
            {{"Friction / Coefficient", 0.132235},
             {"Motion / Indentation", 5.50988e-07},
             {"Motion / Normal amplitude", 2.508198715449365e-10},
             {"Motion / Tangential amplitude", 3.312903436788405e-09}}),
      found("likewise, under a limiting profile", Entries{{"Indenter / Shape", "power"}},
            branches("standard solid", 1752850000, {36284700000}, {6.1785}), 0.00210092, "free",
            {{"Friction / Coefficient", 5.52486},
             {"Indenter / Coefficient", 91594100000},
             {"Indenter / Exponent", 3.09527},
             {"Motion / Indentation", 5.09789e-08},
             {"Motion / Normal amplitude", 6.500816462684713e-10}},
            {{"Motion / Tangential amplitude", "shakedown"},
             {"Wear / State", "limiting"},
             {"Wear / Stick radius ratio", "0.25"}}),
      found("the edge of a contact that travels by half a ring", cone(0.55555),
            branches("standard solid", 471265000000, {15823200000000}, {3.82321e-07}), 103873, "-98.009",
            {{"Friction / Coefficient", 0.0308286},
             {"Motion / Indentation", 0.0100657},
             {"Motion / Normal amplitude", 0.000132694726716374},
             {"Motion / Tangential amplitude", 7.464656164102064e-09}})};
  BodyStore bodies;
  for (const auto& row : run_cases(cases, bodies)) EXPECT_EQ(failure_of(row), "") << title_of(row.asked);
}

TEST(RandomSuite, RepeatsASingleCase) {
  const auto all = run_random_suite({1, 2});
  const auto one = only(1);
  ASSERT_EQ(one.rows.size(), 1U);
  EXPECT_EQ(one.rows[0].asked.name, "random-1-1");
  EXPECT_EQ(one.rows[0].asked.text, all.rows[1].asked.text);
  const auto &mine = one.rows[0].compared.at(Quantity::stick_radius_shakedown),
             &other = all.rows[1].compared.at(Quantity::stick_radius_shakedown);
  EXPECT_EQ(mine.fe, other.fe);
  EXPECT_EQ(mine.bar, other.bar);
}

}  // namespace
}  // namespace fretval::random_cases_test
