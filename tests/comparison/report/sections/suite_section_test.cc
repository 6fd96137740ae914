#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "comparison/report/sections/sections.h"
#include "comparison/verification/suite.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"
#include "tests/comparison/suite_rows.h"

namespace fretval::suite_section_test {
namespace {

TEST(SuiteSection, ShowsVerdictQuantitiesAndRows) {
  const auto run = run_of({row_of(1e-3, 2e-3, "good"), row_of(3e-2, 2e-3, "<bad>"), refused_row("a", "a <b>"),
                           row_of(std::numeric_limits<double>::quiet_NaN(), std::nullopt, "broken")});
  const auto html = rendered(suite_section(suite_json(run)));
  expect_parts(
      html,
      {"<h2>Suite extremes</h2>", "<span class=\"badge bad\">fail</span> About &lt;it&gt;.",
       "4 cases: 1 agree, 1 are refused", "2 fail.", "2 of 3 errors are above their bars",
       "<td>stick radius, shakedown</td><td>1.0e-02</td><td>3</td><td class=\"bad-cell\">2</td>",
       "<summary>family: &lt;bad&gt;</summary><pre>text of &lt;bad&gt;</pre></details></td><td class=\"bad-cell\">FAIL",
       "<td>refused</td><td>refused</td>", "a &lt;b&gt;",
       "<td>0.600000</td><td>0.601000</td><td>1.0e-03</td><td>2.0e-03</td><td>1.0e-02</td>"});
  expect_parts(rendered(suite_section(suite_json(run_of({row_of(1e-3, 2e-3)})))),
               {"<span class=\"badge good\">pass</span>"});
}

TEST(SuiteSection, DrawsTheBarOverTheError) {
  const auto section =
      suite_section(suite_json(run_of({row_of(1e-3, 2e-3, "a"), row_of(1e-3, 8e-3, "b"), row_of(4e-3, 8e-3, "c")})));
  const auto& plot = section.at("figures").at("figures").at(0).at("plot");
  EXPECT_EQ(plot.at("series").at(0).at("x").dump(), "[0.001,0.001,0.004]");
  EXPECT_EQ(plot.at("series").at(0).at("y").dump(), "[0.002,0.008,0.008]");
}

// The points of the figure would be the worst ones alone.
TEST(SuiteSection, HasNoFigureOfSomeRows) {
  const std::vector<SuiteRow> rows(300, row_of(1e-3, 2e-3));
  const auto section = suite_section(suite_json(run_of(rows)));
  EXPECT_TRUE(section.at("figures").at("figures").empty());
  expect_parts(rendered(section), {"10 cases, each with"});
}

TEST(SuiteText, HasALineARowAndAQuantity) {
  expect_parts(suite_text(suite_json(mixed_run())),
               {"family: good         agrees  stick radius, shakedown  0.600000  0.601000  1.0e-03  2.0e-03    1.0e-02",
                "bar 2.0e-02, mostly rings, tolerance 1e-02\n", "is above its bar 2.0e-03\n", "a b\n",
                "stick radius, shakedown    1.0e-02       3", "FAIL: 4 cases: 1 agree, ", "1 of 3 errors are above"});
  expect_parts(suite_text(suite_json(run_of({row_of(1e-3, 2e-3)}))), {"pass: 1 case: 1 agree"});
}

TEST(SuiteText, HasTheWorstOfManyRowsAlone) {
  std::vector<SuiteRow> rows(300, row_of(1e-3, 2e-3, "usual"));
  rows[200] = row_of(1.5e-3, 2e-3, "worst");
  const auto text = suite_text(suite_json(run_of(rows)));
  expect_parts(text, {"the worst of 300\n", "\nfamily: worst   agrees", "pass: 300 cases"});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + (1 + 10) + 1 + (1 + 1) + 1 + 1);
}

TEST(SuiteSection, RefusesJsonOfAnotherKind) {
  EXPECT_THROW(suite_section(nlohmann::ordered_json::parse(R"({"records": [1]})")), nlohmann::json::exception);
}

TEST(ConvergenceSection, HasErrorsOrdersAndVerdictsOfEachRow) {
  auto failing = stored_convergence_row(), plain = stored_convergence_row();
  failing["errors"][1] = nullptr;
  failing["observed_order"] = nullptr;
  failing["verdict"] = "the error is <not> finite";
  plain["note"] = "to roundoff";
  const auto html = rendered(convergence_section({stored_convergence_row(), failing, plain}));
  expect_parts(html, {"2 of 3 rows pass.",
                      "<td>16 to 32 rings</td><td>1.0e-03, 2.5e-04</td><td>2.0 (2)</td><td>1.0e-03</td><td>pass</td>",
                      "<td>1.0e-03, not finite</td><td>floor (2)</td><td>1.0e-03</td>"
                      "<td class=\"bad-cell\">the error is &lt;not&gt; finite</td>",
                      "<td>pass</td><td class=\"words\">Hertz 1882; to roundoff</td>"});
}

TEST(ConvergenceText, HasALineARow) {
  const auto text = convergence_text({stored_convergence_row(), stored_convergence_row()});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 2 + 1) << text;
  expect_parts(text, {"\nHertz: force        16 to 32 rings  1.0e-03, 2.5e-04", "2 of 2 rows pass."});
}

}  // namespace
}  // namespace fretval::suite_section_test
