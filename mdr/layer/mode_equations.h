#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

#include "mdr/layer/coupled_bed.h"

namespace fretval::mdr {

/// The linear equations of one step of RowSolver, x + response(give) x = rest in the modes of a layer. From one step to
/// the next few springs give by another amount. What was factored for the others is kept, and those that changed are a
/// correction of low rank (Woodbury's formula):
///
///   A = A0 + S^T D P,   A^-1 rest = x0 - Z (1 + D P Z)^-1 D P x0,   x0 = A0^-1 rest,   Z = A0^-1 S^T
///
/// with a row of S (shape) and of P (pulled) for each spring that changed, by D. The solution is that of the equations
/// to roundoff, whatever was solved before.
class ModeEquations {
 public:
  explicit ModeEquations(const LayerModes& modes);  ///< which outlive the equations

  void take(const Eigen::ArrayXd& give);  ///< of each spring, 0 to 1
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& rest) const;

 private:
  void factor(const Eigen::ArrayXd& give);
  void correct(const Eigen::ArrayXd& give);
  [[nodiscard]] Eigen::VectorXd pulled_at_changed(const Eigen::VectorXd& x) const;

  const LayerModes& modes_;
  Eigen::ArrayXd factored_give_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
  Eigen::MatrixXd answers_;  // modes x springs: Z, of those springs that have been asked for
  std::vector<bool> has_answer_;
  std::vector<Eigen::Index> changed_;
  Eigen::ArrayXd change_;
  Eigen::PartialPivLU<Eigen::MatrixXd> correction_;  // of 1 + D P Z
};

}  // namespace fretval::mdr
