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

/// `G(omega)` over the relaxed modulus, by which a displacement that oscillates leads to a force that does.
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

/// None.
constexpr IndenterMove standing_still{0, {0, 0, 0}};

/// At constant rate: while the indenter follows a force, which says nothing of what it does inside a step.
IndenterMove steady_move(double increment, double duration);

/// Exact Prony update over an interval.
class PronyInterval {
 public:
  PronyInterval(const RelaxationModel& model, double duration);

  /// Memory of a branch at the end per its memory at the start.
  [[nodiscard]] double decay(std::size_t branch) const { return decay_[branch]; }
  /// Memory per displacement made at constant rate: `G_i (tau/dt)(1 - exp(-dt/tau))`.
  [[nodiscard]] double gain(std::size_t branch) const { return gain_[branch]; }
  /// Memory left by a move of the indenter, its rate interpolated quadratically (relative error (omega dt)^3 / 100).
  [[nodiscard]] double memory_of(std::size_t branch, const IndenterMove& move) const;
  /// Memory left by a way that leaves the straight one at a constant rate until a share of the interval, and is back at
  /// its end, per distance when it turns; until: a share as well, when the memory is asked for. Of branches faster than
  /// the interval only as far as they act as springs.
  [[nodiscard]] double memory_of_turn(std::size_t branch, double share, double until = 1) const;
  /// The same of all of the branch, and as far as it acts as a dashpot.
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

  /// Of a branch in the step: its duration over the relaxation time.
  [[nodiscard]] double rate_of_decay(std::size_t branch) const { return -std::log(whole_.decay(branch)); }
  /// Fraction of the step at which forces are balanced.
  [[nodiscard]] double fraction() const { return fraction_; }
  [[nodiscard]] Eigen::Index n_branches() const { return static_cast<Eigen::Index>(whole_.n_branches()); }
  /// See PronyInterval, of the whole step.
  [[nodiscard]] double memory_of_turn(Eigen::Index branch, double share) const {
    return whole_.memory_of_turn(static_cast<std::size_t>(branch), share);
  }
  /// Of the relaxed body and the branches at the balance time, likewise.
  [[nodiscard]] double response_to_turn(double share) const;
  /// What is left out there, of a dashpot and of branches that act as one: what they bear at the balance time, beyond
  /// what belongs to the whole step.
  [[nodiscard]] double passing_response_to_turn(double share) const;

  /// Change of w at the balance time per unit of (minus) slip made in the whole step.
  [[nodiscard]] double instantaneous() const { return instantaneous_; }

  /// Change of w at the balance time per unit of (minus) slip that was made before the balance time.
  [[nodiscard]] double stiffness_before_balance() const { return stiffness_before_balance_; }

  /// w at the balance time of what moves along with the indenter, from rest.
  [[nodiscard]] double response_to(const IndenterMove& move) const;

  /// w at the balance time of rings that do not slip; move: of the indenter up to the balance time.
  [[nodiscard]] Eigen::VectorXd response_without_slip(const RingState& state, const IndenterMove& move) const;
  /// Into one that is there.
  void find_response_without_slip(const RingState& state, const IndenterMove& move, Eigen::VectorXd& response) const;

  /// The same where the indenter moves each entry by its share: strains at the points of a body, of which driven is
  /// that of a unit displacement of the indenter.
  [[nodiscard]] Eigen::VectorXd response_without_slip(const RingState& state, const IndenterMove& move,
                                                      const Eigen::VectorXd& driven) const;

  /// Moves the state to the end of the step; move: of the indenter over the whole step; slip: increments.
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
