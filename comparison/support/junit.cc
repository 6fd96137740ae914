#include "comparison/support/junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "comparison/support/text.h"

namespace fretval {

std::string junit_document(const std::string& name, const std::vector<JUnitCase>& cases) {
  std::string class_name = name;
  std::replace(class_name.begin(), class_name.end(), ' ', '.');
  std::string text;
  int n_failed = 0, n_errors = 0;
  for (const auto& one : cases) {
    const bool is_error = !one.error.empty(), fails = !is_error && !one.failure.empty();
    n_failed += fails ? 1 : 0;
    n_errors += is_error ? 1 : 0;
    text += fmt::format("  <testcase classname=\"{}\" name=\"{}\"", class_name, html_escaped(one.name));
    if (one.seconds > 0) text += fmt::format(" time=\"{:.3f}\"", one.seconds);
    std::string inside;
    if (fails) inside = fmt::format("<failure message=\"{}\"/>", html_escaped(one.failure));
    if (is_error) inside = fmt::format("<error message=\"{}\"/>", html_escaped(one.error));
    if (!one.output.empty()) inside += fmt::format("<system-out>{}</system-out>", html_escaped(one.output));
    text += inside.empty() ? "/>\n" : ">" + inside + "</testcase>\n";
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
      "errors=\"{}\">\n{}</testsuite>\n",
      name, cases.size(), n_failed, n_errors, text);
}

}  // namespace fretval
