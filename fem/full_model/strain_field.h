#pragma once

#include <Eigen/Dense>
#include <vector>

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

}  // namespace fretval::fem
