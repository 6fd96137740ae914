#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace fretval {

/// How far many parts have come.
struct Advance {
  std::size_t n_done, n_parts, n_bad = 0;
  double share = 0;       ///< of the whole that is done, with what is under way
  std::string what = {};  ///< is under way
  double expected = 0;    ///< s that all will take, of an estimate beforehand; 0: there is none
};

/// For one line of so many columns: a bar as far as there is room, the counts, the time that is left, and what is under
/// way. What is left goes from what an estimate leaves ("about") to what the done share says by the time that a tenth
/// is done, or a hundred parts. seconds: since the start.
std::string progress_text(const Advance& advance, double seconds, int columns);

/// Tells on the standard error how far many parts have come: on a terminal a line that redraws itself every second,
/// from the start on; elsewhere a line for each part. Says nothing before log::start() and after log::keep_quiet().
class Progress {
 public:
  /// expected: the seconds of each part by its name, of an estimate; a part that is not named counts as their mean.
  /// Where there is one, a log begins with what is left of all, if that is long enough to be waited for.
  explicit Progress(std::size_t n_parts, std::map<std::string, double> expected = {});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more part is done. what: its name and what became of it; part: as it was called under way or is expected, if
  /// it was. May be called by several threads.
  void done(const std::string& what, bool is_good = true, const std::string& part = {});

  /// How far a part has come that takes long, and what there is to say of it, for the terminal alone.
  void under_way(const std::string& part, double share, const std::string& what);

 private:
  void draw() const;
  void count_shares();
  [[nodiscard]] double seconds() const;
  [[nodiscard]] double weight_of(const std::string& part) const;

  using Clock = std::chrono::steady_clock;
  const Clock::time_point start_ = Clock::now();
  const std::map<std::string, double> expected_;
  const double weight_of_others_;
  Advance advance_;
  double done_ = 0;                       // weights of the parts that are
  std::map<std::string, double> shares_;  // of the parts under way
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread ticker_;
};

}  // namespace fretval
