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
  double share = 0;       ///< of the whole that is done, with the shares of parts under way
  std::string what = {};  ///< name and state of a part that is under way
  double expected = 0;    ///< s, estimated for all parts beforehand; 0: not estimated
};

/// A line of at most `columns` characters: a bar as far as there is room, the counts, the time that is left, and what
/// is under way. The time left follows the estimate first ("about"), and goes over to that by the share done until a
/// tenth or a hundred parts are done. seconds: since the start.
std::string progress_text(const Advance& advance, double seconds, int columns);

/// Tells on the standard error how far many parts have come: on a terminal a line that redraws itself every second,
/// from the start on; elsewhere a line for each part. Says nothing before log::start() and after log::keep_quiet().
class Progress {
 public:
  /// expected: estimated seconds of each part by its name; a part that is not named counts as their mean. With an
  /// estimate a log begins with the time for all parts, if that is long.
  explicit Progress(std::size_t n_parts, std::map<std::string, double> expected = {});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more part is done. what: its name and result; part: its name in under_way() or in `expected`, if it has one
  /// there. May be called by several threads.
  void done(const std::string& what, bool is_good = true, const std::string& part = {});

  /// Tells how far a long part has come, and its state in words, on a terminal alone.
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
  double done_ = 0;                       // weights of the parts that are done
  std::map<std::string, double> shares_;  // of the parts under way
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread ticker_;
};

}  // namespace fretval
