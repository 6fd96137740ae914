#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace fretval {

/// How far many parts have come, for one line of so many columns: a bar as far as there is room, the counts, and the
/// time that is left if the rest takes as long for each part as what is done. seconds: since the start.
std::string progress_text(std::size_t n_done, std::size_t n_parts, std::size_t n_bad, double seconds, int columns);

/// Tells on the standard error how far many parts have come: on a terminal a line that redraws itself every second,
/// from the start on; elsewhere a line for each part. Says nothing before log::start() and after log::keep_quiet().
class Progress {
 public:
  explicit Progress(std::size_t n_parts);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more part is done. what: its name and what became of it. May be called by several threads.
  void done(const std::string& what, bool is_good = true);

 private:
  void draw() const;

  using Clock = std::chrono::steady_clock;
  const std::size_t n_parts_;
  const Clock::time_point start_ = Clock::now();
  std::size_t n_done_ = 0, n_bad_ = 0;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread ticker_;
};

}  // namespace fretval
