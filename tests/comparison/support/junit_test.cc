#include "comparison/support/junit.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"

namespace fretval {
namespace {

TEST(JUnit, HasACaseEachAndCountsFailures) {
  const auto xml = junit_document("fretval run", {{"a & b", ""}, {"c", "0.1 < 0.2"}, {"d", ""}});
  expect_parts(xml, {"<testsuite name=\"fretval run\" tests=\"3\" failures=\"1\" errors=\"0\">",
                     "<testcase classname=\"fretval.run\" name=\"a &amp; b\"/>",
                     "name=\"c\"><failure message=\"0.1 &lt; 0.2\"/></testcase>", "</testsuite>\n"});
}

// What came to no answer, is no answer that is wrong.
TEST(JUnit, TellsErrorsFromFailures) {
  JUnitCase broken{"a", "and this as well"};
  broken.error = "the pump is broken";
  const auto xml = junit_document("fretval run", {broken, {"b", "off by 1"}});
  expect_parts(xml, {"failures=\"1\" errors=\"1\">", "name=\"a\"><error message=\"the pump is broken\"/>"});
}

}  // namespace
}  // namespace fretval
