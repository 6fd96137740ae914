#include "comparison/report/exact_section.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

TEST(ConvergenceSection, HasErrorsOrdersGoalsAndVerdictsOfEachRow) {
  auto failing = stored_convergence_row(), plain = stored_convergence_row();
  failing["errors"][1] = nullptr;
  failing["observed_order"] = nullptr;
  failing["goal_met"] = false;
  failing["verdict"] = "the error is <not> finite";
  plain["goal"] = plain["goal_met"] = nullptr;
  plain["note"] = "to roundoff";
  const auto html = convergence_section({stored_convergence_row(), failing, plain});
  const std::string not_finite =
      "<td title=\"32 rings\">not finite</td><td>floor (2)</td><td>1e-03</td><td>1e-06, not met</td>"
      "<td class=\"bad-cell\">the error is &lt;not&gt; finite</td>";
  expect_parts(html,
               {"2 of 3 rows pass; 1 of 2 goals", "<td title=\"16 rings\">1.0e-03</td>",
                "<td title=\"32 rings\">2.5e-04</td><td>2.0 (2)</td><td>1e-03</td><td>1e-06, met</td><td>pass</td>",
                not_finite, "<td>–</td><td>pass</td><td class=\"words\">Hertz 1882; to roundoff</td>"});
}

}  // namespace
}  // namespace fretval
