#include "fem/full_contact/surface_compliance.h"

#include <numeric>
#include <string>

#include "fem/condensation/condensation.h"
#include "fem/condensation/far_field.h"
#include "fem/operators/harmonic_space.h"
#include "fem/operators/stiffness.h"

namespace fretval::fem {

Compliance surface_block(const GridData& grid, const FourierOrder& order, unsigned degree) {
  const HarmonicSpace space(grid, order, degree);
  std::vector<unsigned> components(n_displacements(order));
  std::iota(components.begin(), components.end(), 0U);
  const auto line = space.contact_line(components);
  const Condensation condensation(assemble_skeleton_stiffness(space), line.dofs,
                                  "stiffness of order " + std::to_string(order.n));
  auto compliance = contact_compliance(line, condensation.schur_complement());
  add_far_field(space, condensation, components, compliance);
  return compliance;
}

SurfaceCompliance surface_compliance(const GridData& grid, unsigned highest_order, unsigned degree) {
  const auto torsion = surface_block(grid, {0, Parity::odd}, degree);
  SurfaceCompliance surface{torsion.radii, torsion.areas, torsion.matrix, {}};
  for (unsigned n = 0; n <= highest_order; ++n)
    surface.orders.push_back(surface_block(grid, {n, Parity::even}, degree).matrix);
  return surface;
}

Compliance ring_compliance(const SurfaceCompliance& surface, const FourierOrder& order) {
  const Eigen::Index n = surface.n_rings(), first = n * ring_component(order);
  return {surface.radii, surface.areas, Eigen::MatrixXd(surface.of(order).block(first, first, n, n))};
}

}  // namespace fretval::fem
