#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <ctime>

#include "comparison/report/sections/sections.h"
#include "comparison/report/text/numbers.h"
#include "comparison/support/versions.h"

namespace fretval {
namespace {

constexpr std::size_t most_names = 3;

std::string list_of(const std::set<std::string>& names) {
  std::string text;
  std::size_t n = 0;
  for (const auto& name : names) {
    if (n++ == most_names) return text + fmt::format(" and {} more", names.size() - most_names);
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

std::string title_of(const std::vector<StoredResult>& results) {
  std::set<std::string> families;
  for (const auto& r : results) families.insert(r.family());
  if (families.size() > 1) return fmt::format("{}: {}", counted(results.size(), "case"), list_of(families));
  if (results.front().sweep().empty()) return results.front().name();
  const auto second = results.front().second_entry();
  return fmt::format("{}: {} over {}{}", *families.begin(), counted(results.size(), "case"), results.front().entry(),
                     second.empty() ? "" : " and " + second);
}

/// "27 November 2026", of the newest result; empty: none is a file.
std::string date_of(const std::vector<StoredResult>& results) {
  std::time_t newest = 0;
  for (const auto& r : results) {
    struct stat status {};
    if (stat((r.folder / "result.json").c_str(), &status) == 0) newest = std::max(newest, status.st_mtime);
  }
  return newest == 0 ? "" : fmt::format("{:%d %B %Y}", fmt::localtime(newest));
}

std::string libraries_text() {
  std::string text;
  for (const auto& [name, version] : versions())
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, version);
  return text;
}

}  // namespace

Filling heading_of(const std::vector<StoredResult>& results, const std::set<std::string>& of_this_run,
                   const std::string& no_results) {
  const auto title = results.empty() ? no_results : title_of(results);
  Filling heading{{"template", "heading"},
                  {"title", title},
                  {"date", date_of(results)},
                  {"libraries", libraries_text()},
                  {"citation", fmt::format("The fretval authors, fretval {}: finite elements and the method of "
                                           "dimensionality reduction compared for fretting on an elastomer",
                                           versions().front().second)}};
  std::set<std::string> earlier;
  for (const auto& r : results)
    if (const auto name = r.name(); of_this_run.count(name) == 0) earlier.insert(name);
  if (!of_this_run.empty() && !earlier.empty())
    heading["earlier"] = {{"count", counted(earlier.size(), "result")}, {"names", list_of(earlier)}};
  return heading;
}

}  // namespace fretval
