#include "comparison/simulation/body.h"
#include "comparison/verification/exact/exact_rows.h"
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
                                      const fem::StokesField& exact) {
  const char* source = "Kelvin 1848";
  ConvergenceDemand displacement{
      bulk.displacement_tolerance, 4, 1e-11, std::nullopt, "cubic displacement, quadratic pressure; floor: roundoff",
      meshes.back().n_rings};
  ConvergenceDemand pressure = displacement;
  pressure.tolerance = bulk.pressure_tolerance;
  pressure.expected_order = 3;
  return mesh_rows({{bulk.name, "displacement in the bulk", source, displacement},
                    {bulk.name, "pressure in the bulk", source, pressure}},
                   meshes, [&](const BulkMesh& mesh) {
                     const auto error = fem::bulk_error(fem::HarmonicSpace(mesh.grid, bulk.harmonic, 3),
                                                        fem::point_force(bulk.harmonic, 1), exact);
                     return std::vector<double>{error.displacement, error.pressure};
                   });
}

}  // namespace fretval
