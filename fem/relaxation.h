#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

namespace fretval::fem {

/// Shear relaxation of the body: `G(t) = relaxed + sum_i moduli_i exp(-t/times_i) + viscosity delta(t)`.
/// Any consistent units; the drivers scale moduli by the relaxed modulus and times by 1/omega.
struct RelaxationModel {
  double relaxed = 1;
  std::vector<double> moduli;
  std::vector<double> times;
  double viscosity = 0;
};

/// Rate of the indenter at the start, middle and end of a step.
using StepRates = std::array<double, 3>;

/// `w(t) = int G(t-t') du/dt' dt'` on the rings of the contact line, stepped in time.
///
/// A ring moves like the indenter less its slip, `u = U(t) - s(t)`. The indenter's share of the convolution is integrated
/// exactly up to a quadratic interpolation of its rate over the step (relative error of order (omega dt)^3 / 100), the slip
/// is linear in time over the step (the exact Prony update `h <- e^{-dt/tau} h + G_i (tau/dt)(1 - e^{-dt/tau}) du`). So a ring
/// that sticks has no error of time discretisation, whatever the rheology.
class RelaxationStep {
 public:
  /// dt > 0.
  RelaxationStep(const RelaxationModel& model, double dt);

  /// w at the end of the step per unit of (minus) slip made during it.
  [[nodiscard]] double instantaneous() const { return instantaneous_; }

  /// w at the end of the step of rings that do not slip. displacement, memory: at its start, n and n x n_branches.
  [[nodiscard]] Eigen::VectorXd response_without_slip(const Eigen::VectorXd& displacement,
                                                      const Eigen::MatrixXd& memory, double indenter_increment,
                                                      const StepRates& rates) const;

  /// Moves displacement and memory to the end of the step; slip: increments during it.
  void advance(Eigen::VectorXd& displacement, Eigen::MatrixXd& memory, double indenter_increment,
               const StepRates& rates, const Eigen::VectorXd& slip) const;

 private:
  [[nodiscard]] double memory_increment(std::size_t branch, const StepRates& rates) const;

  RelaxationModel model_;
  double dt_;
  double instantaneous_;
  std::vector<double> decay_, gain_;
  std::vector<std::array<double, 3>> weights_;  // of the rates, per branch
};

}  // namespace fretval::fem
