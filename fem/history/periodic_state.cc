#include "fem/history/periodic_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/support/constants.h"
#include "fem/support/dense.h"

namespace fretval::fem {
namespace {

using Rings = std::vector<Eigen::Index>;

/// Rings that are held in all steps, and those that are not.
std::pair<Rings, Rings> held_and_moving(const std::vector<FrozenStep>& steps) {
  std::pair<Rings, Rings> rings;
  for (std::size_t i = 0; i < steps.front().held.size(); ++i) {
    const bool held = std::all_of(steps.begin(), steps.end(), [i](const FrozenStep& step) { return step.held[i]; });
    (held ? rings.first : rings.second).push_back(static_cast<Eigen::Index>(i));
  }
  return rings;
}

/// The compliance of the moving rings, while the others are held.
Eigen::MatrixXd condensed(const Eigen::MatrixXd& compliance, const Rings& held, const Rings& moving) {
  Eigen::MatrixXd left = compliance(moving, moving);
  if (held.empty()) return left;
  const Eigen::MatrixXd across = compliance(held, moving);
  return left - across.transpose() * Eigen::MatrixXd(compliance(held, held)).llt().solve(across);
}

/// Small changes of the state of the moving rings at the start of a period, a column for each entry, and what becomes
/// of them.
class Perturbations {
 public:
  Perturbations(Eigen::MatrixXd compliance, Eigen::VectorXd areas, Eigen::Index n_branches)
      : compliance_(std::move(compliance)), areas_(std::move(areas)), m_(areas_.size()), n_(m_ * (1 + n_branches)) {
    columns_ = {Eigen::VectorXd::Zero(m_ * n_), Eigen::MatrixXd::Zero(m_ * n_, n_branches)};
    for (Eigen::Index k = 0; k < m_; ++k) {
      columns_.displacement[k * m_ + k] = 1;
      for (Eigen::Index i = 0; i < n_branches; ++i) columns_.memory((m_ * (i + 1) + k) * m_ + k, i) = 1;
    }
  }

  /// held, free: indices of the rings that are held and that are not in this step.
  void step(const RelaxationStep& relaxation, const Rings& held, const Rings& free, Hold hold) {
    const IndenterMove rest = steady_move(0, 1);
    const Eigen::VectorXd response = relaxation.response_without_slip(columns_, rest);
    const Eigen::Map<const Eigen::MatrixXd> w(response.data(), m_, n_), u(columns_.displacement.data(), m_, n_);
    Eigen::MatrixXd slip = Eigen::MatrixXd::Zero(m_, n_), left = w(free, Eigen::all);
    if (hold == Hold::closes) slip(held, Eigen::all) = u(held, Eigen::all);
    if (!held.empty()) {
      const Eigen::MatrixXd wanted =
          areas_(held).asDiagonal() * (w(held, Eigen::all) - relaxation.instantaneous() * slip(held, Eigen::all));
      if (held != factored_) factor_.compute(compliance_(held, held));
      factored_ = held;
      left -= areas_(free).cwiseInverse().asDiagonal() * (compliance_(free, held) * factor_.solve(wanted));
    }
    slip(free, Eigen::all) = left / relaxation.instantaneous();
    relaxation.advance(columns_, rest, slip.reshaped());
  }

  /// 1 - J, entries of the displacement first.
  [[nodiscard]] Eigen::MatrixXd one_minus_columns() const {
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n_, n_);
    system.topRows(m_) -= columns_.displacement.reshaped(m_, n_);
    for (Eigen::Index i = 0; i < columns_.memory.cols(); ++i)
      system.middleRows(m_ * (i + 1), m_) -= columns_.memory.col(i).reshaped(m_, n_);
    return system;
  }

 private:
  Eigen::MatrixXd compliance_;
  Eigen::VectorXd areas_;
  Eigen::Index m_, n_;
  RingState columns_;  // one below the other
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Rings factored_;
};

Eigen::MatrixXd change_of_moving(const std::vector<FrozenStep>& steps, Perturbations perturbations, const Rings& moving,
                                 Hold hold) {
  for (const auto& [relaxation, held] : steps) {
    Rings places_held, places_free;
    for (std::size_t k = 0; k < moving.size(); ++k)
      (held[static_cast<std::size_t>(moving[k])] ? places_held : places_free).push_back(static_cast<Eigen::Index>(k));
    perturbations.step(relaxation, places_held, places_free, hold);
  }
  return perturbations.one_minus_columns();
}

Eigen::VectorXd relaxed_response(const RelaxationModel& relaxation, const RingState& state) {
  return relaxation.relaxed * state.displacement + state.memory.rowwise().sum();
}

RingState sum(const RingState& a, const RingState& b, double sign = 1) {
  return {a.displacement + sign * b.displacement, a.memory + sign * b.memory};
}

}  // namespace

RingState correction_to_periodic(const Compliance& compliance, const std::vector<FrozenStep>& steps, Hold hold,
                                 const RingState& change) {
  const auto [held, moving] = held_and_moving(steps);
  const auto m = static_cast<Eigen::Index>(moving.size()), n_branches = change.memory.cols();
  RingState correction{Eigen::VectorXd::Zero(change.displacement.size()), change.memory};
  for (Eigen::Index i = 0; i < n_branches; ++i) {
    double relaxation_times = 0;
    for (const auto& step : steps) relaxation_times += step.relaxation.rate_of_decay(static_cast<std::size_t>(i));
    correction.memory.col(i) /= -std::expm1(-relaxation_times);
  }
  if (m == 0) return correction;
  const Perturbations perturbations(condensed(compliance.matrix, held, moving), compliance.areas(moving), n_branches);
  Eigen::VectorXd right(m * (1 + n_branches));
  right.head(m) = change.displacement(moving);
  for (Eigen::Index i = 0; i < n_branches; ++i) right.segment(m * (i + 1), m) = change.memory.col(i)(moving);
  const Eigen::VectorXd moved = solve_square(change_of_moving(steps, perturbations, moving, hold), std::move(right));
  correction.displacement(moving) = moved.head(m);
  for (Eigen::Index i = 0; i < n_branches; ++i) correction.memory.col(i)(moving) = moved.segment(m * (i + 1), m);
  return correction;
}

PeriodicState find_periodic_state(const Compliance& compliance, const RelaxationModel& relaxation, Hold hold,
                                  RingState start, double tolerance,
                                  const std::function<FrozenPeriod(const RingState&)>& period) {
  constexpr int most_periods = 15;
  PeriodicState found{start, infinity, 0};
  RingState begin = std::move(start);
  double stiff_to_come = infinity, smallest = infinity;
  while (found.n_periods < most_periods) {
    const auto [end, steps] = period(begin);
    ++found.n_periods;
    // What a contact that opens altogether bears when it touches again, error bars of slow bodies do not cover.
    if (hold == Hold::closes && held_and_moving(steps).first.empty()) break;
    const auto correction = correction_to_periodic(compliance, steps, hold, sum(end, begin, -1));
    if (!correction.displacement.allFinite() || !correction.memory.allFinite()) break;
    begin = sum(begin, correction);
    const Eigen::VectorXd response = relaxed_response(relaxation, correction).cwiseAbs();
    const double largest = relaxed_response(relaxation, end).cwiseAbs().maxCoeff(),
                 stiffness = steps.front().relaxation.instantaneous(), before = stiff_to_come;
    // A ring that is held right after it has moved responds with the instantaneous stiffness.
    stiff_to_come = (response + stiffness * correction.displacement.cwiseAbs()).maxCoeff() / largest;
    if (stiff_to_come < smallest) {
      smallest = stiff_to_come;
      found.state = begin;
      found.to_come = response.maxCoeff() / largest;
    }
    const bool at_roundoff = found.to_come < tolerance && stiff_to_come > before / 2;
    if (stiff_to_come < tolerance || at_roundoff) break;
  }
  return found;
}

}  // namespace fretval::fem
