#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include "fem/operators/fourier_order.h"

namespace fretval::fem {

/// The deal.II side of a HarmonicSpace, for the few files that assemble or write fields. The mesh is 2-D, here and
/// everywhere: the meridian half-plane.
struct HarmonicSpaceParts {
  dealii::Triangulation<2> triangulation;
  dealii::FESystem<2> element;
  dealii::DoFHandler<2> dofs;
  dealii::AffineConstraints<double> constraints;

  HarmonicSpaceParts(const FourierOrder& order, unsigned degree)
      : element(dealii::FE_Q<2>(degree), n_displacements(order), dealii::FE_Q<2>(degree - 1),
                has_pressure(order) ? 1 : 0),
        dofs(triangulation) {}
};

}  // namespace fretval::fem
