#include "comparison/support/junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "comparison/support/escape.h"

namespace fretval {

std::string junit_document(const std::string& name, const std::vector<JUnitCase>& cases) {
  std::string class_name = name;
  std::replace(class_name.begin(), class_name.end(), ' ', '.');
  std::string text;
  int n_failed = 0;
  for (const auto& one : cases) {
    const bool pass = one.failure.empty();
    n_failed += pass ? 0 : 1;
    text += fmt::format("  <testcase classname=\"{}\" name=\"{}\"", class_name, html_escaped(one.name));
    if (one.seconds > 0) text += fmt::format(" time=\"{:.3f}\"", one.seconds);
    std::string inside;
    if (!pass) inside = fmt::format("<failure message=\"{}\"/>", html_escaped(one.failure));
    if (!one.output.empty()) inside += fmt::format("<system-out>{}</system-out>", html_escaped(one.output));
    text += inside.empty() ? "/>\n" : ">" + inside + "</testcase>\n";
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n"
      "{}</testsuite>\n",
      name, cases.size(), n_failed, text);
}

}  // namespace fretval
