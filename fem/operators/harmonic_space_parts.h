#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include "fem/operators/harmonic.h"

namespace fretval::fem {

/// Number of displacement components: 2 (U, W) or 3 (s, m, W). The pressure component follows.
constexpr unsigned n_displacements(Harmonic harmonic) {
  return harmonic == Harmonic::normal ? 2 : 3;
}

/// Index of the vertical displacement W.
constexpr unsigned vertical_component(Harmonic harmonic) {
  return n_displacements(harmonic) - 1;
}

/// Index of the contact unknown: W (n = 0) or s (n = 1).
constexpr unsigned contact_component(Harmonic harmonic) {
  return harmonic == Harmonic::normal ? 1 : 0;
}

/// The deal.II side of a HarmonicSpace, for the few files that assemble or write fields. The mesh is 2-D, here and
/// everywhere: the meridian half-plane.
struct HarmonicSpaceParts {
  dealii::Triangulation<2> triangulation;
  dealii::FESystem<2> element;
  dealii::DoFHandler<2> dofs;
  dealii::AffineConstraints<double> constraints;

  HarmonicSpaceParts(Harmonic harmonic, unsigned degree)
      : element(dealii::FE_Q<2>(degree), n_displacements(harmonic), dealii::FE_Q<2>(degree - 1), 1),
        dofs(triangulation) {}
};

}  // namespace fretval::fem
