#include "comparison/report/text/page.h"

#include <fmt/format.h>

namespace fretval {
namespace {

std::string with(std::string text, const std::string& part, const std::string& other) {
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + other.size()))
    text.replace(at, part.size(), other);
  return text;
}

std::string escaped(const std::string& text) {
  return with(with(text, "&", "&amp;"), "<", "&lt;");
}

}  // namespace

std::string page_of(const std::string& title, const std::string& words, const Filling& document) {
  const auto& pieces = page_pieces();
  const auto data = document.dump(-1, ' ', false, Filling::error_handler_t::replace);
  return fmt::format("{}{}{}{}{}{}{}", pieces[0], escaped(title), pieces[1], escaped(words), pieces[2],
                     with(data, "<", "\\u003c"), pieces[3]);
}

}  // namespace fretval
