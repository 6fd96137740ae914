#include "comparison/report/text/page.h"

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>

#include "comparison/support/text.h"

namespace fretval {
namespace {

/// JSON as it may stand in a script.
std::string in_script(const std::string& json) {
  return boost::replace_all_copy(json, "<", "\\u003c");
}

}  // namespace

std::string page_of(const std::string& title, const std::string& words, const Filling& document) {
  const auto& pieces = page_pieces();
  const auto data = document.dump(-1, ' ', false, Filling::error_handler_t::replace);
  return fmt::format("{}{}{}{}{}{}{}", pieces[0], html_escaped(title), pieces[1], html_escaped(words), pieces[2],
                     in_script(data), pieces[3]);
}

}  // namespace fretval
