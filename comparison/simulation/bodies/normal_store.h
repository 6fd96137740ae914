#pragma once

#include <Eigen/Dense>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "comparison/simulation/fem_case/fem_case.h"
#include "comparison/support/made_once.h"
#include "fem/history/normal_history.h"

namespace fretval {

/// A normal history, with its values in each step for the friction beside it.
struct NormalRecord {
  fem::NormalHistory history;
  /// Ring pressures at the start, then after each step until the response repeats: those for the friction limit
  /// (fem::pressure_for_friction), or without a tangential problem the pressures of the contact themselves.
  std::vector<Eigen::VectorXd> pressures;
  std::vector<Eigen::VectorXd> depths;  ///< of the pressures, see fem::NormalInstant; empty without tangential problem
  std::vector<double> radii, forces;    ///< of the contact at these instants, see fem::ContactForce

  /// The normal contact after a number of steps, for friction.
  [[nodiscard]] fem::NormalInstant instant(std::size_t step) const;
  double seconds = 0;  ///< that the history took
};

/// The normal histories that cases share which differ in their friction and tangential motion alone, as those of a
/// sweep of the phase: at nu = 1/2 pressures do not depend on either. It keeps the latest ones, as many as there is
/// room for; what it has let go is made again when asked for.
class NormalStore {
 public:
  /// room: for how many numbers of pressures; 256 MB unless given.
  explicit NormalStore(std::size_t room = std::size_t{256} << 17) : room_(room) {}

  /// The history of the case on its body. problem: the normal one of the body, at the slack of the resolution;
  /// friction: the series of its tangential problem, or null without one; profile: ring means. Throws fem::SolverError,
  /// see fem::normal_history.
  std::shared_ptr<const NormalRecord> find_or_make(const FemCase& fem, const fem::ContactProblem& problem,
                                                   const fem::PunchSeries* friction, const Eigen::VectorXd& profile,
                                                   const fem::HistoryControl& control);

 private:
  using Key = std::pair<BodyDescription, std::vector<std::vector<double>>>;

  void make_room_for(const Key& key, std::size_t n_numbers);

  std::size_t room_;
  MadeOnce<Key, NormalRecord> records_;
  std::deque<std::pair<Key, std::size_t>> kept_;  // the oldest first, with its numbers
  std::size_t n_numbers_ = 0;                     // of all of them
  std::mutex mutex_;
};

}  // namespace fretval
