#include "comparison/simulation/bodies/body.h"
#include "comparison/verification/exact/exact_rows.h"
#include "fem/full_model/manufactured_solution.h"
#include "fem/operators/grid_refinement.h"
#include "meshes/grading.h"

namespace fretval {

std::vector<BulkMesh> bulk_meshes(int n_meshes) {
  constexpr int coarsest = 4;
  const auto grid = grid_of(mesh_of({meshes::uniform_nodes(1, coarsest), 0.6, 6, 3}), {});
  std::vector<BulkMesh> meshes{{coarsest, grid}};
  while (static_cast<int>(meshes.size()) < n_meshes)
    meshes.push_back({2 * meshes.back().n_rings, fem::refined(meshes.back().grid)});
  return meshes;
}

/// Displacement and pressure in the body under the tractions of a unit force, see
/// fem/full_model/manufactured_solution.h.
Rows bulk_rows(const std::vector<BulkMesh>& meshes, double exact_force) {
  const ConvergenceDemand displacement{2e-8, 4, 1e-11, "cubic displacement, quadratic pressure; floor: roundoff", 32};
  const ConvergenceDemand pressure{4e-6, 3, 1e-11, displacement.note, 32};
  Rows rows;
  for (const auto order : {fem::axisymmetric, fem::lateral}) {
    const char* name = order == fem::axisymmetric ? "Kelvin's force along z" : "Kelvin's force along x";
    append(rows, mesh_rows(Rows{{name, "displacement in the bulk", "Kelvin 1848", displacement},
                                {name, "pressure in the bulk", "Kelvin 1848", pressure}},
                           meshes, [&](const BulkMesh& mesh) {
                             const auto error =
                                 fem::bulk_error(fem::HarmonicSpace(mesh.grid, order, 3), fem::point_force(order, 1),
                                                 fem::point_force(order, exact_force));
                             return std::vector<double>{error.displacement, error.pressure};
                           }));
  }
  return rows;
}

}  // namespace fretval
