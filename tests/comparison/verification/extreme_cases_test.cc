#include <gtest/gtest.h>

#include <map>
#include <set>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/verification/suites.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

TEST(ExtremeCases, CoverWhatTheyShould) {
  const auto cases = extreme_cases();
  std::set<std::string> titles;
  std::map<std::string, int> families, refused;
  for (const auto& one : cases) {
    EXPECT_TRUE(titles.insert(title_of(one)).second) << title_of(one);
    ++families[one.family];
    if (!one.refusal.empty()) ++refused[one.family];
  }
  EXPECT_EQ(cases.size(), 162U);
  EXPECT_EQ(families.size(), 32U);
  EXPECT_EQ(refused, (std::map<std::string, int>{{"softening, omega tau = 1e6", 1},
                                                 {"softening, contact opens", 1},
                                                 {"frequency ratio", 1},
                                                 {"sphere", 1},
                                                 {"steps per cycle", 2},
                                                 {"rings per radius", 2},
                                                 {"refused input", 6}}));
  EXPECT_TRUE(only_family(cases, "no such family").empty());
  EXPECT_EQ(only_family(cases, "power law").size(), 10U);
}

// What a case file may not say is refused before anything is computed, with the words that the case has to end with.
TEST(ExtremeCases, RefuseBadInputByName) {
  for (const char* family : {"sphere", "refused input", "steps per cycle", "rings per radius", "frequency ratio"})
    for (const auto& one : only_family(extreme_cases(), family)) {
      const auto message = refusal([&] { prepare({case_of(one)}); });
      EXPECT_EQ(message == "no error", one.refusal.empty()) << title_of(one);
      EXPECT_NE((message + "no error").find(one.refusal), std::string::npos) << title_of(one) << ": " << message;
    }
}

TEST(ExtremeCases, ReachWhatTheirNamesSay) {
  const auto named = [](const std::string& family, const std::string& name) {
    for (const auto& one : only_family(extreme_cases(), family))
      if (one.name == name) return one;
    throw std::invalid_argument(name);
  };
  EXPECT_EQ(case_of(named("modulus", "G0 = 1e+12 Pa")).elastomer.branch_moduli, std::vector<double>{1e12});
  EXPECT_EQ(case_of(named("length", "a = 1 km")).motion.indentation, 100);
  EXPECT_EQ(case_of(named("normal amplitude, elastic", "Dd/d0 = 10")).motion.normal_amplitude, 1e-3);
  EXPECT_FALSE(case_of(named("phase at k = 1", "unlocked")).motion.phase);
  auto prepared = prepare({case_of(named("cycles", "100 at least"))}).front();
  named("cycles", "100 at least").change(prepared);
  EXPECT_EQ(prepared.fem.resolution.n_ramp_cycles, 100);
}

TEST(ExtremeCases, TheShortFormHasOneOfEachFamily) {
  const auto cases = short_extreme_cases();
  EXPECT_EQ(cases.size(), 32U);
  EXPECT_EQ(cases.front().name, "omega tau = 1e-06");
}

TEST(ExtremesSlow, OfTheShortFormEndInAnAnswerOrANamedRefusal) {
  const auto cases = short_extreme_cases();
  const auto run = run_extreme_suite(cases);
  EXPECT_EQ(run.rows.size(), cases.size());
  EXPECT_TRUE(run.passes()) << remarks_of(run);
  EXPECT_EQ(count(run.rows, RowVerdict::inconclusive), 0U) << remarks_of(run);
  for (std::size_t i = 0; i < cases.size(); ++i)
    EXPECT_EQ(verdict_of(run.rows[i]) == RowVerdict::refused, !cases[i].refusal.empty()) << cases[i].name;
}

// The folder of the measured profiles is no part of the result.
TEST(Extremes, NameNoFolderOfTheMachine) {
  const auto run = run_extreme_suite({only_family(extreme_cases(), "measured profile").at(0)});
  ASSERT_EQ(run.rows.size(), 1U);
  EXPECT_EQ(verdict_of(run.rows[0]), RowVerdict::agrees);
  EXPECT_NE(run.rows[0].asked.text.find("set Table = flat-face.csv\n"), std::string::npos) << run.rows[0].asked.text;
}

}  // namespace
}  // namespace fretval
