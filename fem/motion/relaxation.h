#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <vector>

namespace fretval::fem {

/// Shear relaxation of the body: `G(t) = relaxed + sum_i moduli_i exp(-t/times_i) + viscosity delta(t)`.
/// Any consistent units; the drivers scale moduli by the relaxed modulus and times by 1/omega.
struct RelaxationModel {
  double relaxed = 1;
  std::vector<double> moduli;
  std::vector<double> times;
  double viscosity = 0;

  /// Whether the stress depends on more than the present strain; false: elastic.
  [[nodiscard]] bool has_memory() const { return !moduli.empty() || viscosity > 0; }
};

/// `G(omega)` over the relaxed modulus: the factor from an oscillating displacement to the force that it makes.
std::complex<double> stiffening_at(const RelaxationModel& relaxation, double omega);

struct ValueAndRate {
  double value, rate;
};

/// Motion of the indenter over an interval of time: its increment, and its rate at the start, middle and end.
struct IndenterMove {
  double increment;
  std::array<double, 3> rates;
};

IndenterMove indenter_move(const std::function<ValueAndRate(double)>& motion, double begin, double end);

/// The move of an indenter that stands still.
constexpr IndenterMove standing_still{0, {0, 0, 0}};

/// A move at constant rate, for an indenter that follows a force, of which nothing is known inside a step.
IndenterMove steady_move(double increment, double duration);

/// Exact update of the memories of Prony branches over an interval of time.
class PronyInterval {
 public:
  PronyInterval(const RelaxationModel& model, double duration);

  /// Memory of a branch at the end per its memory at the start.
  [[nodiscard]] double decay(std::size_t branch) const { return decay_[branch]; }
  /// Memory per displacement made at constant rate: `G_i (tau/dt)(1 - exp(-dt/tau))`.
  [[nodiscard]] double gain(std::size_t branch) const { return gain_[branch]; }
  /// Memory left by a move of the indenter, its rate interpolated quadratically (relative error (omega dt)^3 / 100).
  [[nodiscard]] double memory_of(std::size_t branch, const IndenterMove& move) const;
  /// Memory left by a detour, per its largest distance: displacements leave the straight line at a constant rate until
  /// `share` of the interval, and are back on it at its end. until: share of the interval at which the memory is read.
  /// For branches faster than the interval it is only the part in which they act as springs.
  [[nodiscard]] double memory_of_turn(std::size_t branch, double share, double until = 1) const;
  /// The whole memory left by such a detour, and the part of it in which the branch acts as a dashpot; memory_of_turn()
  /// is the rest.
  [[nodiscard]] double whole_memory_of_turn(std::size_t branch, double share, double until) const;
  [[nodiscard]] double passing_memory_of_turn(std::size_t branch, double share, double until) const;
  [[nodiscard]] std::size_t n_branches() const { return decay_.size(); }

 private:
  std::vector<double> modulus_, rate_;  // duration over relaxation time
  std::vector<double> decay_, gain_;
  std::vector<std::array<double, 3>> weights_;  // of the rates
};

/// Displacements of the rings, or strains of a whole body, and the memory of their Prony branches.
struct RingState {
  Eigen::VectorXd displacement;  ///< n
  Eigen::MatrixXd memory;        ///< n x n_branches

  template <class Archive>
  void serialize(Archive& archive) {
    archive(displacement, memory);
  }
};

/// `w(t) = int G(t-t') du/dt' dt'` on the rings of the contact line, stepped in time.
///
/// A ring moves like the indenter less its slip, `u = U(t) - s(t)`. The indenter's share of the convolution is exact
/// (but for the interpolation of its rate), the slip is linear in time over the step. So a ring that sticks has no
/// error of time discretisation, whatever the rheology, and a free or sliding one is of second order.
///
/// Forces are balanced at the fraction theta of the step. Without a dashpot theta = 1. With one, or with branches
/// faster than the step, which act as one, the mean slip rate belongs to the middle of the step: `theta = 1/(1 -
/// e^{-z}) - 1/z`, z = step over the retardation time, relaxes a free ring exactly and goes from 1/2 (mild) to 1
/// (stiff).
class RelaxationStep {
 public:
  /// dt > 0.
  RelaxationStep(const RelaxationModel& model, double dt);

  /// Duration of the step over the relaxation time of a branch.
  [[nodiscard]] double rate_of_decay(std::size_t branch) const { return -std::log(whole_.decay(branch)); }
  /// Fraction of the step at which forces are balanced.
  [[nodiscard]] double fraction() const { return fraction_; }
  [[nodiscard]] Eigen::Index n_branches() const { return static_cast<Eigen::Index>(whole_.n_branches()); }
  /// PronyInterval::memory_of_turn of the whole step, at its end.
  [[nodiscard]] double memory_of_turn(Eigen::Index branch, double share) const {
    return whole_.memory_of_turn(static_cast<std::size_t>(branch), share);
  }
  /// Response w at the balance time to such a detour, of the relaxed body and of the branches as far as they act as
  /// springs; per its largest distance.
  [[nodiscard]] double response_to_turn(double share) const;
  /// What response_to_turn() leaves out: the response at the balance time of the dashpot and of branches as far as they
  /// act as one, which passes within the step.
  [[nodiscard]] double passing_response_to_turn(double share) const;

  /// Change of w at the balance time per unit of (minus) slip made in the whole step.
  [[nodiscard]] double instantaneous() const { return instantaneous_; }

  /// Change of w at the balance time per unit of (minus) slip that was made before the balance time.
  [[nodiscard]] double stiffness_before_balance() const { return stiffness_before_balance_; }

  /// w at the balance time of what has been at rest and moves along with the indenter.
  [[nodiscard]] double response_to(const IndenterMove& move) const;

  /// w at the balance time of rings that do not slip; move: that of the indenter up to the balance time.
  [[nodiscard]] Eigen::VectorXd response_without_slip(const RingState& state, const IndenterMove& move) const;
  /// Writes response_without_slip() into a vector, whose memory is used again.
  void find_response_without_slip(const RingState& state, const IndenterMove& move, Eigen::VectorXd& response) const;

  /// w at the balance time where the indenter moves each entry by its share, such as strains at the points of a body.
  /// driven: the shares, what a unit displacement of the indenter makes of each entry.
  [[nodiscard]] Eigen::VectorXd response_without_slip(const RingState& state, const IndenterMove& move,
                                                      const Eigen::VectorXd& driven) const;

  /// Moves the state to the end of the step; move: that of the indenter over the whole step; slip: its increments in
  /// the step.
  void advance(RingState& state, const IndenterMove& move, const Eigen::VectorXd& slip) const;
  void advance(RingState& state, const IndenterMove& move, const Eigen::VectorXd& slip,
               const Eigen::VectorXd& driven) const;

 private:
  RelaxationModel model_;
  double dt_, fraction_;
  PronyInterval to_balance_, whole_;
  double instantaneous_, stiffness_before_balance_;
};

}  // namespace fretval::fem
