#include "comparison/command_line/terminal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "comparison/report/sections/values_table.h"

namespace fretval {
namespace {

/// Among the lines of one case file.
ToleranceUse largest_use_of(const std::vector<BatchLine>& lines) {
  const auto worst = std::max_element(lines.begin(), lines.end(), [](const BatchLine& a, const BatchLine& b) {
    return a.largest_use.share < b.largest_use.share;
  });
  return worst->largest_use;
}

/// The answers, before how they agree.
void print_values(const std::vector<BatchLine>& lines) {
  std::vector<StoredResult> results;
  for (const auto& line : lines)
    if (line.failure.empty() && line.compared && !line.json.empty())
      results.push_back({nlohmann::ordered_json::parse(line.json), {}});
  if (!results.empty()) fmt::print("{}", text_of(values_table(results, main_quantities())));
}

}  // namespace

std::string outcome_text(const BatchLine& line) {
  if (!line.failure.empty()) return fmt::format("{}: FAILED: {}", line.name, line.failure);
  const char* verdict = !line.compared ? "not compared, as MDR does not hold,"
                        : line.pass    ? "agrees"
                        : line.open    ? "open, its error bars are wider than the tolerance,"
                                       : "DISAGREES";
  return fmt::format("{}: {} in {:.1f} s", line.name, verdict, line.seconds);
}

void print_answer(const BatchLine& line) {
  fmt::print("{}", line.answer);
  std::fflush(stdout);  // before the log goes on
}

void print_line(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

void print_verdicts(const std::vector<BatchLine>& lines) {
  print_values(lines);
  std::map<std::string, std::vector<BatchLine>> families;
  for (const auto& line : lines) families[line.name.substr(0, line.name.find('/'))].push_back(line);
  for (const auto& [family, members] : families) {
    std::size_t n_pass = 0;
    std::size_t n_beyond = 0;
    std::size_t n_open = 0;
    for (const auto& line : members) {
      n_pass += line.pass ? 1 : 0;
      n_beyond += line.compared ? 0 : 1;
      n_open += line.open ? 1 : 0;
      if (!line.failure.empty()) fmt::print("FAILED   {}: {}\n", line.name, line.failure);
      if (!line.compared) fmt::print("no MDR   {}", line.answer);
    }
    if (n_beyond == members.size()) continue;
    const char* verdict = n_pass == members.size()            ? "agree   "
                          : n_pass + n_open == members.size() ? "open    "
                                                              : "DISAGREE";
    fmt::print("{} {:<34} {:>3} of {:>3} agree; largest use of a tolerance: {}\n", verdict, family, n_pass,
               members.size(), largest_use_of(members).text);
  }
  std::fflush(stdout);  // before the log goes on
}

}  // namespace fretval
