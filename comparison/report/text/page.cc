#include "comparison/report/text/page.h"

#include <fmt/format.h>

#include "comparison/support/escape.h"

namespace fretval {
namespace {

/// JSON as it may stand in a script.
std::string in_script(std::string json) {
  const std::string sign = "<", code = "\\u003c";
  for (auto at = json.find(sign); at != std::string::npos; at = json.find(sign, at))
    json.replace(at, sign.size(), code);
  return json;
}

}  // namespace

std::string page_of(const std::string& title, const std::string& words, const Filling& document) {
  const auto& pieces = page_pieces();
  const auto data = document.dump(-1, ' ', false, Filling::error_handler_t::replace);
  return fmt::format("{}{}{}{}{}{}{}", pieces[0], html_escaped(title), pieces[1], html_escaped(words), pieces[2],
                     in_script(data), pieces[3]);
}

}  // namespace fretval
