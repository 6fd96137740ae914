#include "comparison/report/sections/exact_section.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

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
}  // namespace fretval
