#include "fem/full_model/strain_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fem/operators/harmonic_space_parts.h"
#include "fem/operators/stiffness.h"
#include "tests/fem/half_space.h"
#include "tests/fem/random_vector.h"

namespace fretval::fem::strain_memory_test {
namespace {

std::vector<bool> pressure_dofs(const HarmonicSpace& space) {
  const auto& parts = space.parts();
  std::vector<bool> is_pressure(space.n_dofs(), false);
  std::vector<dealii::types::global_dof_index> dofs(parts.element.n_dofs_per_cell());
  for (const auto& cell : parts.dofs.active_cell_iterators()) {
    cell->get_dof_indices(dofs);
    for (unsigned i = 0; i < dofs.size(); ++i)
      if (parts.element.system_to_component_index(i).first == n_displacements(space.order()))
        is_pressure[dofs[i]] = true;
  }
  return is_pressure;
}

class StrainFieldOf : public testing::TestWithParam<FourierOrder> {
 protected:
  HarmonicSpace space_{quarter_disc_grid(1, 8, 6, 0.35), GetParam(), 3};
  StrainField strain_{space_};
};

INSTANTIATE_TEST_SUITE_P(Harmonics, StrainFieldOf, testing::Values(axisymmetric, lateral));

// Elastic stresses are the strains, and their forces those of the stiffness matrix, far boundary included.
TEST_P(StrainFieldOf, ForcesOfElasticStressesAreThoseOfTheStiffness) {
  const auto is_pressure = pressure_dofs(space_);
  Eigen::VectorXd u = random_vector(space_.n_dofs(), 1);
  for (unsigned i = 0; i < space_.n_dofs(); ++i)
    if (is_pressure[i] || space_.parts().constraints.is_constrained(i)) u[i] = 0;
  const Eigen::VectorXd force = strain_.force(strain_.of(u));
  Eigen::VectorXd expected = multiply(assemble_stiffness(space_), u);
  for (unsigned i = 0; i < space_.n_dofs(); ++i)
    if (is_pressure[i]) expected[i] = 0;  // divergences
  EXPECT_LT((force - expected).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());
}

TEST_P(StrainFieldOf, ForcesAreConjugateToFields) {
  Eigen::VectorXd v = random_vector(space_.n_dofs(), 2);
  for (unsigned i = 0; i < space_.n_dofs(); ++i)
    if (space_.parts().constraints.is_constrained(i)) v[i] = 0;
  const Eigen::VectorXd strain = strain_.of(v), stress = random_vector(strain.size(), 3);
  EXPECT_NEAR(v.dot(strain_.force(stress)), strain.dot(stress), 1e-12 * strain.norm() * stress.norm());
}

}  // namespace
}  // namespace fretval::fem::strain_memory_test
