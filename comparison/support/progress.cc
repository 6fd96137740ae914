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

std::string left_text(std::size_t n_done, std::size_t n_parts, double seconds) {
  if (n_done == 0) return clock_text(seconds) + " so far";
  if (n_done == n_parts) return "in " + clock_text(seconds);
  return clock_text(seconds * static_cast<double>(n_parts - n_done) / static_cast<double>(n_done)) + " left";
}

}  // namespace

std::string progress_text(std::size_t n_done, std::size_t n_parts, std::size_t n_bad, double seconds, int columns) {
  auto text = fmt::format("{}/{}, {}", n_done, n_parts, left_text(n_done, n_parts, seconds));
  if (n_bad > 0) text += fmt::format(", {} not good", n_bad);
  const int room = columns - 1 - static_cast<int>(text.size()) - 3;  // brackets, a blank, and none in the last column
  if (room < narrowest_bar) return text.substr(0, static_cast<std::size_t>(std::max(0, columns - 1)));
  const auto width = static_cast<std::size_t>(std::min(room, widest_bar));
  const auto filled = width * n_done / std::max<std::size_t>(1, n_parts);
  return fmt::format("[{}{}] {}", std::string(filled, '#'), std::string(width - filled, '.'), text);
}

Progress::Progress(std::size_t n_parts) : n_parts_(n_parts) {
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

void Progress::done(const std::string& what, bool is_good) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++n_done_;
  n_bad_ += is_good ? 0 : 1;
  if (!log::tells()) return;
  if (on_terminal()) return draw();
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  fmt::print(stderr, "{}/{} {}; {}\n", n_done_, n_parts_, without_control_characters(what),
             left_text(n_done_, n_parts_, seconds));
}

void Progress::draw() const {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  fmt::print(stderr, "\r\033[K{}", progress_text(n_done_, n_parts_, n_bad_, seconds, terminal_columns()));
  std::fflush(stderr);
}

}  // namespace fretval
