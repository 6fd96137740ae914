#pragma once

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>

#include <functional>

#include "fem/operators/harmonic_space_parts.h"
#include "tests/fem/half_space.h"

namespace fretval::fem {

/// All dofs of a space from a function of the component and the point (r, z), z up.
inline Eigen::VectorXd field_of(const HarmonicSpace& space,
                                const std::function<double(unsigned component, double r, double z)>& f) {
  const auto& parts = space.parts();
  std::vector<dealii::Point<2>> points(parts.dofs.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<2>(), parts.dofs, points);
  Eigen::VectorXd field(space.n_dofs());
  for (unsigned c = 0; c < parts.element.n_components(); ++c) {
    dealii::ComponentMask mask(parts.element.n_components(), false);
    mask.set(c, true);
    for (const auto dof : dealii::DoFTools::extract_dofs(parts.dofs, mask))
      field[static_cast<Eigen::Index>(dof)] = f(c, points[dof][0], points[dof][1]);
  }
  return field;
}

}  // namespace fretval::fem
