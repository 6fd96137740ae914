#include "comparison/support/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "comparison/support/log.h"
#include "comparison/support/text.h"

namespace fretval {
namespace {

constexpr int widest_bar = 30, narrowest_bar = 5;

bool on_terminal() {
  return isatty(STDERR_FILENO) == 1;
}

int terminal_columns() {
  winsize size{};
  constexpr int usual = 80;
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

/// "1:05", "2:00:00"
std::string clock_text(double seconds) {
  const auto s = static_cast<long>(std::lround(seconds));
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

std::string left_text(const Advance& advance, double seconds) {
  if (advance.n_done == advance.n_parts) return "in " + clock_text(seconds);
  constexpr double begins = 0.01;  // of one part; less than that is how it begins
  // Share done from which the time left follows the time spent alone: a tenth, or a hundred parts, whose total chance
  // moves by a tenth even where parts differ by as much as their mean.
  const double tells = std::min(0.1, 100.0 / static_cast<double>(advance.n_parts));
  const bool has_begun = advance.share * static_cast<double>(advance.n_parts) >= begins;
  const double rest = has_begun ? seconds * (1 - advance.share) / advance.share : 0;
  if (advance.share < tells && advance.expected > seconds) {
    // When a tenth of that share is done, the time spent weighs as much as the estimate, which is right to a factor of
    // three, or on other or shared processors to another factor.
    const double belief = has_begun ? advance.share / (advance.share + tells / 10) : 0;
    return "about " + clock_text((1 - belief) * (advance.expected - seconds) + belief * rest) + " left";
  }
  return has_begun ? clock_text(rest) + " left" : clock_text(seconds) + " so far";
}

double sum_of(const std::map<std::string, double>& expected) {
  double sum = 0;
  for (const auto& [part, seconds] : expected) sum += seconds;
  return sum;
}

}  // namespace

std::string progress_text(const Advance& advance, double seconds, int columns) {
  auto text = fmt::format("{}/{}, {}", advance.n_done, advance.n_parts, left_text(advance, seconds));
  if (advance.n_bad > 0) text += fmt::format(", {} not good", advance.n_bad);
  if (!advance.what.empty()) text += "; " + advance.what;
  const int room = columns - 1 - static_cast<int>(text.size()) - 3;  // brackets, a blank, and none in the last column
  if (room < narrowest_bar) return text.substr(0, static_cast<std::size_t>(std::max(0, columns - 1)));
  const auto width = static_cast<std::size_t>(std::min(room, widest_bar));
  const auto filled =
      static_cast<std::size_t>(static_cast<double>(width) * (advance.n_done == advance.n_parts ? 1 : advance.share));
  return fmt::format("[{}{}] {}", std::string(filled, '#'), std::string(width - filled, '.'), text);
}

Progress::Progress(std::size_t n_parts, std::map<std::string, double> expected)
    : expected_(std::move(expected)),
      weight_of_others_(expected_.empty() ? 1 : sum_of(expected_) / static_cast<double>(expected_.size())),
      advance_{0, n_parts} {
  if (!expected_.empty()) advance_.expected = static_cast<double>(n_parts) * weight_of_others_;
  if (!log::tells()) return;
  constexpr double long_enough = 10;
  if (!on_terminal()) {
    if (advance_.expected >= long_enough) fmt::print(stderr, "0/{}; {}\n", n_parts, left_text(advance_, 0));
    return;
  }
  draw();  // before any part can have begun
  ticker_ = std::thread([this] {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!wake_.wait_for(lock, std::chrono::seconds(1), [this] { return ends_; })) draw();
  });
}

Progress::~Progress() {
  if (!ticker_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  ticker_.join();
  std::fputs("\r\033[K", stderr);
}

void Progress::done(const std::string& what, bool is_good, const std::string& part) {
  const std::lock_guard<std::mutex> lock(mutex_);
  shares_.erase(part);
  done_ += weight_of(part);
  ++advance_.n_done;
  count_shares();
  advance_.n_bad += is_good ? 0 : 1;
  if (!log::tells()) return;
  if (on_terminal()) return draw();
  fmt::print(stderr, "{}/{} {}; {}\n", advance_.n_done, advance_.n_parts, without_control_characters(what),
             left_text(advance_, seconds()));
}

void Progress::under_way(const std::string& part, double share, const std::string& what) {
  const std::lock_guard<std::mutex> lock(mutex_);
  shares_[part] = share;
  count_shares();
  advance_.what = part + ": " + what;
}

void Progress::count_shares() {
  double done = done_;
  for (const auto& [part, share] : shares_) done += share * weight_of(part);
  const double all = static_cast<double>(advance_.n_parts) * weight_of_others_;
  advance_.share = all > 0 ? std::min(1.0, done / all) : 0;
  if (shares_.empty()) advance_.what.clear();
}

double Progress::weight_of(const std::string& part) const {
  const auto found = expected_.find(part);
  return found == expected_.end() ? weight_of_others_ : found->second;
}

double Progress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::draw() const {
  fmt::print(stderr, "\r\033[K{}", progress_text(advance_, seconds(), terminal_columns()));
  std::fflush(stderr);
}

}  // namespace fretval
