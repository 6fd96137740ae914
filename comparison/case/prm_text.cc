#include "comparison/case/prm_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

#include "comparison/case/case.h"
#include "comparison/case/entry_table.h"
#include "comparison/case/trimmed.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

/// Words of a name separated by single blanks.
std::string name_in(const std::string& text) {
  std::istringstream words(text);
  std::string name;
  for (std::string word; words >> word;) name += (name.empty() ? "" : " ") + word;
  return name;
}

class Lines {
 public:
  Lines(fs::path file, Problems& problems) : file_(std::move(file)), problems_(problems) {}

  PrmText read(const std::string& text) {
    std::istringstream stream(text);
    std::string logical;  // a line that ends in a backslash goes on in the next
    for (std::string line; std::getline(stream, line);) {
      ++n_read_;
      logical += trimmed(line.substr(0, line.find('#')));
      if (!logical.empty() && logical.back() == '\\') {
        logical.pop_back();
        result_.text += '\n';
        continue;
      }
      take(logical);
      logical.clear();
    }
    if (!logical.empty()) take(logical);
    return result_;
  }

 private:
  [[nodiscard]] std::string here(const std::string& problem) const {
    return fmt::format("{}: line {}: {}", file_.string(), n_read_, problem);
  }
  [[noreturn]] void fail(const std::string& problem) const { throw InputError(here(problem)); }

  void take(const std::string& line) {
    std::istringstream words(line);
    std::string word, rest;
    words >> word;
    std::getline(words, rest);
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    bool is_known = !in_unknown_section();
    if (word == "include") {
      include(trimmed(rest));
      is_known = false;
    }
    if (word == "subsection") is_known = take_section(name_in(rest)) && is_known;
    if (word == "end" && !sections_.empty()) sections_.pop_back();
    if (word == "set" && is_known) is_known = take_entry(name_in(rest.substr(0, rest.find('='))));
    result_.text += (is_known ? line : "") + '\n';
  }

  void include(const std::string& name) {
    if (name.empty()) fail("the include line names no file");
    if (!sections_.empty() || !line_of_entry_.empty())
      fail(fmt::format("include {} must stand before the first subsection", name));
    result_.included.push_back(file_.parent_path() / name);
    std::error_code error;
    if (!fs::exists(result_.included.back(), error))
      fail(fmt::format("include {}: no such file as {}", name, result_.included.back().string()));
  }

  bool take_section(const std::string& name) {
    sections_.push_back(name);
    // A section within a section is for deal.II, which says where the "end" is missing.
    if (sections_.size() > 1 || is_section(name)) return true;
    problems_.add(here(no_such_section(name, problems_)));
    return false;
  }

  [[nodiscard]] bool in_unknown_section() const { return !sections_.empty() && !is_section(sections_.front()); }

  bool take_entry(const std::string& name) {
    const std::string full = fmt::format("{} / {}", fmt::join(sections_, " / "), name);
    const auto [found, is_new] = line_of_entry_.emplace(full, n_read_);
    if (!is_new) fail(fmt::format("{} is set a second time, first in line {}; must be set once", full, found->second));
    if (sections_.size() != 1 || is_entry(sections_.front(), name)) return true;
    problems_.add(here(no_such_entry(sections_.front(), name, problems_)));
    return false;
  }

  fs::path file_;
  Problems& problems_;
  PrmText result_;
  int n_read_ = 0;
  std::vector<std::string> sections_;
  std::map<std::string, int> line_of_entry_;
};

}  // namespace

PrmText read_prm(const std::string& text, const fs::path& file, Problems& problems) {
  return Lines(file, problems).read(text);
}

}  // namespace fretval
