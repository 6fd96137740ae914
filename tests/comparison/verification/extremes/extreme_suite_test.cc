#include "comparison/verification/extremes/extreme_suite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "comparison/verification/suite_summary.h"
#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

TEST(ExtremeRows, CoverWhatTheyShould) {
  const auto rows = extreme_rows();
  std::set<std::string> names, families;
  for (const auto& row : rows) {
    EXPECT_TRUE(names.insert(row.family + ": " + row.value).second) << row.family << ": " << row.value;
    families.insert(row.family);
  }
  EXPECT_EQ(rows.size(), 157U);
  EXPECT_EQ(families.size(), 31U);
  EXPECT_TRUE(only_family(rows, "no such family").empty());
  EXPECT_EQ(only_family(rows, "power law").size(), 10U);
}

TEST(ExtremeRows, TheShortFormHasEveryKindOfRow) {
  const auto rows = short_extreme_rows();
  const auto has = [&](auto property) { return std::any_of(rows.begin(), rows.end(), property); };
  EXPECT_TRUE(has([](const ExtremeRow& r) { return r.refusal.empty(); }));
  EXPECT_TRUE(has([](const ExtremeRow& r) { return !r.refusal.empty() && !r.springs; }));
  EXPECT_TRUE(has([](const ExtremeRow& r) { return r.springs; }));
  EXPECT_EQ(rows.size(), 31U);
}

TEST(ExtremesSlow, OfTheShortFormEndInAnAnswerOrANamedRefusal) {
  const auto rows = short_extreme_rows();
  const auto run = run_extreme_suite(rows);
  EXPECT_EQ(run.rows.size(), rows.size());
  EXPECT_TRUE(run.passes()) << remarks_of(run);
  EXPECT_EQ(count(run.rows, RowVerdict::inconclusive), 0U) << remarks_of(run);
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_EQ(verdict_of(run.rows[i]) == RowVerdict::refused, !rows[i].refusal.empty()) << rows[i].value;
}

// The folder of the measured profiles is no part of the result.
TEST(Extremes, NameNoFolderOfTheMachine) {
  const auto run = run_extreme_suite({only_family(extreme_rows(), "measured profile").at(1)});
  ASSERT_EQ(run.rows.size(), 1U);
  EXPECT_EQ(verdict_of(run.rows[0]), RowVerdict::refused);
  EXPECT_EQ(run.rows[0].refusal.rfind("terrace.csv: ", 0), 0U) << run.rows[0].refusal;
  EXPECT_NE(run.rows[0].asked.text.find("set Table = terrace.csv\n"), std::string::npos) << run.rows[0].asked.text;
}

// Springs and cycles of a row reach its case.
TEST(ExtremeCases, DoWhatTheirRowsSay) {
  ExtremeRow springs{"family", "springs", extremes_base()}, cycles = springs;
  springs.springs = true;
  cycles.ramp_cycles = 77;
  const auto cases = extreme_cases({springs, cycles});
  EXPECT_TRUE(cases[0].second_way);
  EXPECT_FALSE(cases[1].second_way);
  auto prepared = prepare({case_of(cases[1])}).front();
  cases[1].change(prepared);
  EXPECT_EQ(prepared.fem.resolution.n_ramp_cycles, 77);
}

}  // namespace
}  // namespace fretval
