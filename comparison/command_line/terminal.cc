#include "comparison/command_line/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <map>

namespace fretval {
namespace {

/// The largest use of a tolerance among the lines of one case file.
struct Worst {
  double use = -1;
  std::string text;
};

Worst worst_of(const std::vector<BatchLine>& lines) {
  Worst worst;
  for (const auto& line : lines)
    for (const auto& [quantity, d] : line.comparison) {
      const double difference = d.difference.value_or(d.only_one), use = std::abs(difference) / d.tolerance;
      if (use <= worst.use) continue;
      worst = {use, fmt::format("{} in {}: {:.1e} of {:.1e}{}", name_of(quantity), line.name, difference, d.tolerance,
                                d.only_one != 0 ? ", only one of the two sticks" : "")};
    }
  return worst;
}

}  // namespace

Progress::Progress() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::show(const BatchLine& line, std::size_t n_done, std::size_t n_cases) {
  if (!line.failure.empty()) n_failed_ += 1;
  if (line.failure.empty() && !line.pass) n_disagree_ += 1;
  const auto tenth = 10 * n_done / n_cases;
  if (!on_terminal_ && tenth == last_tenth_) return;
  last_tenth_ = tenth;
  const std::string counts =
      fmt::format("{}/{} cases, {} disagree, {} failed", n_done, n_cases, n_disagree_, n_failed_);
  if (!on_terminal_) {
    fmt::print(stderr, "{}\n", counts);
    return;
  }
  const auto filled = 30 * n_done / n_cases;
  fmt::print(stderr, "\r[{}{}] {} {}", std::string(filled, '#'), std::string(30 - filled, '.'), counts,
             n_done == n_cases ? "\n" : "");
}

void print_answer(const BatchLine& line) {
  fmt::print("{}", line.answer);
  std::fflush(stdout);  // before the log goes on
}

void print_verdicts(const std::vector<BatchLine>& lines) {
  std::map<std::string, std::vector<BatchLine>> families;
  for (const auto& line : lines) families[line.name.substr(0, line.name.find('/'))].push_back(line);
  for (const auto& [family, members] : families) {
    std::size_t n_pass = 0;
    for (const auto& line : members) {
      n_pass += line.pass ? 1 : 0;
      if (!line.failure.empty()) fmt::print("FAILED   {}: {}\n", line.name, line.failure);
    }
    fmt::print("{} {:<34} {:>3} of {:>3} agree; largest use of a tolerance: {}\n",
               n_pass == members.size() ? "agree   " : "DISAGREE", family, n_pass, members.size(),
               worst_of(members).text);
  }
  std::fflush(stdout);  // before the log goes on
}

}  // namespace fretval
