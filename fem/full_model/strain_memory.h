#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/history/relaxation.h"
#include "fem/operators/harmonic_space.h"

namespace fretval::fem {

/// The generalised strains of a body: the strain tensor at every quadrature point of the cells, and the normal
/// displacement at those of the far boundary, which resists it like a spring of the same material (see
/// assemble_stiffness). Each carries the root of its weight and stiffness per shear modulus, so that for fields u, v
/// the virtual work of the stresses of u on v, at unit shear modulus, is `of(u).dot(of(v))`.
///
/// The pressure is no strain: entries of fields that belong to it are ignored.
class StrainField {
 public:
  explicit StrainField(const HarmonicSpace& space);

  /// Generalised strains of a displacement field; field: n_dofs.
  [[nodiscard]] Eigen::VectorXd of(const Eigen::VectorXd& field) const;

  /// Nodal forces of generalised stresses, `v . force = of(v) . stress` for every field v; 0 on constrained dofs.
  [[nodiscard]] Eigen::VectorXd force(const Eigen::VectorXd& stress) const;

 private:
  struct Cell {
    std::vector<unsigned> dofs;
    Eigen::MatrixXd strain;  // n_strains x n_dofs
  };
  std::vector<Cell> cells_;
  std::vector<unsigned> constrained_;
  Eigen::Index n_dofs_, n_strains_;
};

/// Viscoelastic memory at the quadrature points, stepped like the rings of RelaxationStep: the strain moves by `move *
/// driven - slip`, where the driven strain is that of a unit displacement of the indenter. The indenter's share of the
/// convolution is exact (but for the interpolation of its rate), the slip is linear in time over the step.
class StrainMemory {
 public:
  /// strain: relaxed, at the start; driven: see above; dt > 0.
  StrainMemory(const RelaxationModel& model, double dt, Eigen::VectorXd strain, Eigen::VectorXd driven);

  /// Fraction theta of the step at which forces are balanced, see RelaxationStep.
  [[nodiscard]] double fraction() const { return fraction_; }

  /// Stress released at the balance time per unit of slip strain made in the whole step: a modulus.
  [[nodiscard]] double instantaneous() const { return instantaneous_; }

  /// Stresses at the balance time where nothing slips; move: of the indenter up to the balance time.
  [[nodiscard]] Eigen::VectorXd stress_without_slip(const IndenterMove& move) const;

  /// Moves on to the end of the step; move: of the indenter over the whole step; slip: strain.
  void advance(const IndenterMove& move, const Eigen::VectorXd& slip);

 private:
  RelaxationModel model_;
  double fraction_;
  PronyInterval to_balance_, whole_;
  double instantaneous_;
  Eigen::VectorXd driven_, strain_;
  std::vector<Eigen::VectorXd> branches_;
};

}  // namespace fretval::fem
