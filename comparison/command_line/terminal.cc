#include "comparison/command_line/terminal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "comparison/report/sections/values_table.h"

namespace fretval {
namespace {

/// Largest use of a tolerance among the lines of one case file; a case without error bars is not held to a tolerance.
ToleranceUse largest_use_of(const std::vector<BatchLine>& lines) {
  ToleranceUse largest;
  for (const auto& line : lines)
    if (line.outcome != Outcome::not_proved && line.largest_use.share > largest.share) largest = line.largest_use;
  return largest;
}

/// A row for each value, where the results are one sweep for which a terminal has room.
void print_sweep(const std::vector<StoredResult>& results) {
  constexpr std::size_t most_rows = 60;
  const bool is_one = results.size() > 1 && results.size() <= most_rows &&
                      std::all_of(results.begin(), results.end(), [&](const auto& r) {
                        return !r.sweep().empty() && r.family() == results.front().family();
                      });
  if (is_one) fmt::print("\n{}\n", text_of(sweep_rows(results)));
}

/// The answers, before how they agree.
void print_values(const std::vector<BatchLine>& lines) {
  std::vector<StoredResult> results;
  for (const auto& line : lines)
    if (!line.failed() && line.outcome != Outcome::not_compared && !line.json.empty())
      results.push_back({nlohmann::ordered_json::parse(line.json), {}});
  if (!results.empty()) fmt::print("{}", text_of(values_table(results, main_quantities())));
  print_sweep(results);
}

/// Number of the cases whose model is MDR's, failed ones among them.
long n_of_model(const std::vector<BatchLine>& lines) {
  return std::count_if(lines.begin(), lines.end(), [](const auto& line) {
    return line.failed() || (line.outcome != Outcome::not_compared && line.outcome != Outcome::other_model);
  });
}

/// Outcome of several cases: the worst of them.
std::string heading_of(const std::vector<BatchLine>& lines) {
  const auto any = [&](Outcome outcome) {
    return std::any_of(lines.begin(), lines.end(), [=](const auto& line) { return line.outcome == outcome; });
  };
  if (std::any_of(lines.begin(), lines.end(), [](const auto& line) { return line.failed(); })) return "FAILED";
  for (const auto outcome : {Outcome::disagree, Outcome::not_resolved, Outcome::not_proved})
    if (any(outcome)) return outcome == Outcome::disagree ? "DISAGREE" : name_of(outcome);
  return name_of(n_of_model(lines) > 0 ? Outcome::agree : Outcome::other_model);
}

/// "11 of 13 agree, 1 not resolved, 1 failed": of those whose model is MDR's; "MDR computes another model in 2".
std::string counts_text(const std::vector<BatchLine>& lines) {
  const auto count = [&](const auto& is) { return std::count_if(lines.begin(), lines.end(), is); };
  const auto n_failed = count([](const auto& line) { return line.failed(); });
  const auto with = [&](Outcome outcome) {
    return count([=](const auto& line) { return !line.failed() && line.outcome == outcome; });
  };
  const auto n = n_of_model(lines);
  auto text = n > 0 ? fmt::format("{:>3} of {:>3} agree", with(Outcome::agree), n) : "";
  if (const auto others = with(Outcome::other_model); others > 0)
    text += fmt::format("{}MDR computes another model in {}", text.empty() ? "" : ", ", others);
  for (const auto outcome : {Outcome::disagree, Outcome::not_resolved, Outcome::not_proved})
    if (const auto some = with(outcome); some > 0) text += fmt::format(", {} {}", some, name_of(outcome));
  return text + (n_failed > 0 ? fmt::format(", {} failed", n_failed) : "");
}

}  // namespace

std::string outcome_text(const BatchLine& line) {
  if (line.failed()) return fmt::format("{}: FAILED: {}", line.name, line.failure);
  // In the order of the enumeration.
  static constexpr std::array words{"agrees",
                                    "not resolved to the tolerance that was asked for,",
                                    "DISAGREES",
                                    "not proved, without error bars,",
                                    "MDR computes another model,",
                                    "not compared, as MDR does not hold,"};
  return fmt::format("{}: {} in {:.1f} s", line.name, words[static_cast<std::size_t>(line.outcome)], line.seconds);
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
    std::size_t n_beyond = 0;
    for (const auto& line : members) {
      const bool beyond = !line.failed() && line.outcome == Outcome::not_compared;
      n_beyond += beyond ? 1 : 0;
      if (line.failed()) fmt::print("{:<12} {}: {}\n", "FAILED", line.name, line.failure);
      if (beyond) fmt::print("{:<12} {}", "no MDR", line.answer);
    }
    if (n_beyond == members.size()) continue;
    const auto use = largest_use_of(members);
    const char* told = n_of_model(members) > 0 ? "closest to its tolerance" : "MDR is off most";
    fmt::print("{:<12} {:<34} {}{}\n", heading_of(members), family, counts_text(members),
               use.share < 0 ? "" : fmt::format("; {}: {}", told, use.text));
  }
  std::fflush(stdout);  // before the log goes on
}

}  // namespace fretval
