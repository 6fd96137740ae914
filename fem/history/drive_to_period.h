#pragma once

#include <algorithm>
#include <utility>

#include "fem/history/cycle_jump.h"
#include "fem/support/constants.h"

namespace fretval::fem {

/// Creep in periods from which on the periodic state is found directly (find_periodic_state).
constexpr double slow_creep = 3;
/// Tolerance of the search for the periodic state, over the periodicity that is asked for.
constexpr double share_of_search = 0.01;

/// By what the way to a periodic state may be shortened.
struct Shortening {
  double creep = 0;               ///< longest creep time, in periods: bodies that creep for many are moved by CycleJump
  int n_searches = 0;             ///< searches for the state that repeats, at most; jumps take their place afterwards
  bool begins_by_search = false;  ///< one more search, before the first period
};

/// A way that nothing shortens, to a state that repeats.
struct PlainWay {
  [[nodiscard]] bool is_single_pass() const { return false; }
  double search() { return infinity; }
  bool jump(CycleJump& /*jump*/) { return false; }
};

struct DriveToPeriod {
  double periodicity = infinity;  ///< reached, see HistoryControl; 0: a single pass, which has no other period
  bool moved = false;             ///< whether a search or a jump has moved the state
};

/// Steps a contact period by period until its response repeats. Only plain periods count: the one after a search or a
/// jump is not compared with the one before. A Way is a contact with the record of its last period:
///
///   bool is_at_end(periodicity)      whether it is given up before another period; may throw instead
///   void step_through_period()
///   bool is_single_pass()            one period is all
///   bool is_in_start()               the last period says nothing yet, as on the ramp
///   double change()                  largest relative change of the last period from the one before
///   bool goes_on(periodicity, change)   whether another period is needed; asked after plain periods
///   double search()                  moves the contact to the state of a search; PeriodicState::to_come
///   bool jump(CycleJump&)            moves it along its drift; whether it did
template <class Way>
DriveToPeriod drive_to_period(Way& way, const Shortening& by) {
  DriveToPeriod drive;
  CycleJump jump(by.creep);
  int n_searches = by.n_searches;
  bool jumped = false, goes_on = true;
  double to_come = infinity;  // as a search found
  const auto search = [&] {
    to_come = way.search();
    jumped = true;
  };
  if (by.begins_by_search) search();
  while (jumped || goes_on) {
    if (way.is_at_end(drive.periodicity)) break;
    way.step_through_period();
    if (way.is_single_pass()) {
      drive.periodicity = 0;
      break;
    }
    drive.moved |= jumped;
    const bool after_jump = std::exchange(jumped, false);
    if (way.is_in_start()) continue;
    if (!after_jump) {
      const double change = way.change();
      drive.periodicity = std::min(change_to_come(change, by.creep), std::max(change, to_come));
      goes_on = way.goes_on(drive.periodicity, change);
    }
    const bool after_search = after_jump && to_come < infinity;  // which is followed by two plain periods
    if (!goes_on || after_search) continue;
    if (n_searches > 0) {
      --n_searches;
      search();
    } else {
      to_come = infinity;
      jumped = way.jump(jump);
    }
  }
  return drive;
}

}  // namespace fretval::fem
