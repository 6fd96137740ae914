#include "comparison/verification/exact/exact_bulk_rows.h"

#include "comparison/simulation/body.h"
#include "fem/operators/grid_refinement.h"
#include "meshes/grading.h"
#include "meshes/quarter_disc.h"

namespace fretval {

std::vector<BulkMesh> bulk_meshes(int n_meshes) {
  constexpr int coarsest = 4;
  const auto grid = grid_of(meshes::quarter_disc({meshes::uniform_nodes(1, coarsest), 6, 0.6}));
  std::vector<BulkMesh> meshes{{coarsest, grid}};
  while (static_cast<int>(meshes.size()) < n_meshes)
    meshes.push_back({2 * meshes.back().n_rings, fem::refined(meshes.back().grid)});
  return meshes;
}

std::vector<ConvergenceRow> bulk_rows(const std::vector<BulkMesh>& meshes, const BulkCase& bulk,
                                      const fem::StokesField& load, const fem::StokesField& exact) {
  const ConvergenceDemand demand{
      0, 0, 1e-11, std::nullopt, "cubic displacement, quadratic pressure; floor: roundoff", meshes.back().n_rings};
  ConvergenceRow displacement{bulk.name, "displacement in the bulk", "Kelvin 1848", "rings", {}, {}, demand};
  ConvergenceRow pressure{bulk.name, "pressure in the bulk", "Kelvin 1848", "rings", {}, {}, demand};
  displacement.demand.tolerance = bulk.displacement_tolerance;
  displacement.demand.expected_order = 4;
  pressure.demand.tolerance = bulk.pressure_tolerance;
  pressure.demand.expected_order = 3;
  for (const auto& mesh : meshes) {
    const auto error = fem::bulk_error(fem::HarmonicSpace(mesh.grid, bulk.harmonic, 3), load, exact);
    for (auto* row : {&displacement, &pressure}) row->resolutions.push_back(mesh.n_rings);
    displacement.errors.push_back(error.displacement);
    pressure.errors.push_back(error.pressure);
  }
  return {displacement, pressure};
}

}  // namespace fretval
