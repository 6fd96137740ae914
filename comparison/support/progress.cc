#include "comparison/support/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "comparison/support/escape.h"
#include "comparison/support/log.h"

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
  const auto n_parts = static_cast<double>(advance.n_parts);
  const double done = static_cast<double>(advance.n_done) + advance.under_way;
  constexpr double tells = 0.01;  // of one part; less than that is how it begins
  if (done < tells)
    return advance.expected > seconds ? "about " + clock_text(advance.expected - seconds) + " left"
                                      : clock_text(seconds) + " so far";
  if (advance.n_done == advance.n_parts) return "in " + clock_text(seconds);
  return clock_text(seconds * (n_parts - done) / done) + " left";
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
      static_cast<std::size_t>(static_cast<double>(width) * (static_cast<double>(advance.n_done) + advance.under_way) /
                               static_cast<double>(std::max<std::size_t>(1, advance.n_parts)));
  return fmt::format("[{}{}] {}", std::string(filled, '#'), std::string(width - filled, '.'), text);
}

Progress::Progress(std::size_t n_parts, double expected) : advance_{0, n_parts, 0, 0, {}, expected} {
  if (!log::tells() || !on_terminal()) return;
  ticker_ = std::thread([this] {
    std::unique_lock<std::mutex> lock(mutex_);
    do draw();
    while (!wake_.wait_for(lock, std::chrono::seconds(1), [this] { return ends_; }));
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
  count_shares();
  ++advance_.n_done;
  advance_.n_bad += is_good ? 0 : 1;
  if (!log::tells()) return;
  if (on_terminal()) return draw();
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  fmt::print(stderr, "{}/{} {}; {}\n", advance_.n_done, advance_.n_parts, without_control_characters(what),
             left_text(advance_, seconds));
}

void Progress::under_way(const std::string& part, double share, const std::string& what) {
  const std::lock_guard<std::mutex> lock(mutex_);
  shares_[part] = share;
  count_shares();
  advance_.what = part + ": " + what;
}

void Progress::count_shares() {
  advance_.under_way = 0;
  for (const auto& [part, share] : shares_) advance_.under_way += share;
  if (shares_.empty()) advance_.what.clear();
}

void Progress::draw() const {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  fmt::print(stderr, "\r\033[K{}", progress_text(advance_, seconds, terminal_columns()));
  std::fflush(stderr);
}

}  // namespace fretval
