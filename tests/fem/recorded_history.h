#pragma once

#include <Eigen/Dense>
#include <utility>
#include <vector>

#include "fem/history/friction_history.h"
#include "fem/history/normal_history.h"
#include "fem/ring_contact/static_contact.h"

namespace fretval::fem {

/// A normal history with every instant since the start, which the product does not keep: its columns and entries per
/// step begin with the start itself. It remembers what it follows from, so that friction can be driven beside it.
struct NormalRecord : NormalHistory {
  const ContactProblem* problem;
  RelaxationModel model;
  Eigen::VectorXd profile;
  Motion motion;
  HistoryControl control;
  NormalHistory cycle;  ///< as the product has it

  /// Column of `pressure` at a step counted from the start, also beyond the computed ones.
  [[nodiscard]] Eigen::Index column(long step) const {
    return step <= n_steps() ? step : n_steps() - steps_per_cycle + 1 + NormalHistory::column(step);
  }
};

inline NormalRecord normal_history(const ContactProblem& problem, const RelaxationModel& model,
                                   const Eigen::VectorXd& profile, const Motion& motion,
                                   const HistoryControl& control) {
  NormalContact start(problem, model, profile, motion, control.steps_per_cycle);
  std::vector<double> time{0}, force{start.reading.force};
  std::vector<Eigen::VectorXd> pressure{start.pressure};
  const auto record = [&](const NormalContact& contact) {
    time.push_back(contact.time);
    force.push_back(contact.reading.force);
    pressure.push_back(contact.pressure);
  };
  NormalRecord all{normal_history(std::move(start), control, record), &problem, model, profile, motion, control, {}};
  all.cycle = all;
  const auto n = static_cast<Eigen::Index>(time.size());
  all.time = Eigen::Map<Eigen::VectorXd>(time.data(), n);
  all.force = Eigen::Map<Eigen::VectorXd>(force.data(), n);
  all.pressure.resize(problem.n_rings(), n);
  all.indentation.resize(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    all.pressure.col(k) = pressure[static_cast<std::size_t>(k)];
    all.indentation[k] = normal_motion(motion, all.time[k]).value;
  }
  return all;
}

/// Friction beside a recorded contact. Forces stand for every instant since the start, with zeros before the last
/// period.
inline FrictionHistory friction_history(const ContactProblem& problem, const RelaxationModel& model, double mu,
                                        const Motion& motion, const NormalRecord& normal,
                                        const HistoryControl& control) {
  WatchedFriction friction(problem, model, mu, motion, control.steps_per_cycle);
  for (Eigen::Index k = 1; k < normal.pressure.cols(); ++k) friction.step(normal.pressure.col(k));
  auto history = friction_history(std::move(friction), normal.cycle, control);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(history.n_steps + 1);
  force.tail(history.force.size()) = history.force;
  history.force = force;
  return history;
}

}  // namespace fretval::fem
