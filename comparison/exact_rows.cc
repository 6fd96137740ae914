#include "comparison/exact_rows.h"

#include "comparison/exact_parts.h"
#include "comparison/exact_time_rows.h"

namespace fretval {
namespace {

using Rows = std::vector<LadderRow>;

void add(Rows& rows, const Rows& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

void add_indentation(Rows& rows, const std::vector<LadderMesh>& meshes) {
  add(rows, indentation_rows(meshes, exact_indentation("Hertz", "Hertz 1882, Johnson 1985", 2),
                             {1e-6, 3, far_field, 1e-6, far_field_note}, {1.5e-4, 2, far_field, 1e-5, rings_note}));
  add(rows, indentation_rows(meshes, exact_indentation("cone", "Love 1939, Sneddon 1965", 1),
                             {1e-6, 3, far_field, 1e-6, far_field_note}, {1.5e-4, 2, far_field, 1e-5, rings_note}));
  add(rows,
      indentation_rows(meshes, exact_indentation("power law n = 4", "Galin 1946, Sneddon 1965", 4),
                       {3e-6, 3, far_field, 1e-6, far_field_note + std::string("; third order with a larger constant")},
                       {3e-4, 2, far_field, 1e-5, rings_note}));
  add(rows, punch_rows(meshes, exact_punch()));
}

void add_sliding(Rows& rows, const std::vector<LadderMesh>& meshes) {
  add(rows, sliding_rows(meshes, exact_sliding()));
  add(rows, {cycle_row(meshes, exact_sliding()), unloading_row(meshes, exact_sliding())});
  const ObliqueLoading oblique{0.4, 0.8, 0.925, 0.3, 3};
  add(rows, oblique_rows(meshes, oblique, exact_oblique(oblique)));
  add(rows, {worn_edge_row(meshes, mdr::parabola(1), mdr::parabola(1))});
}

void add_time(Rows& rows, const std::vector<LadderMesh>& meshes) {
  const auto body = mdr::standard_solid(1, 2, 0.4);
  add(rows, {step_row(meshes.front(), body, body), hertz_step_row(meshes, body, body),
             growing_contact_time_row(meshes.front(), body, body), growing_contact_mesh_row(meshes, body, body),
             retraction_time_row(meshes.front(), body, body), retraction_mesh_row(meshes, body, body)});
  add(rows, rebound_rows(meshes, body, body));
}

}  // namespace

std::vector<LadderRow> exact_rows() {
  const auto meshes = half_space_ladder({16, 32, 64, 128});
  Rows rows;
  add_indentation(rows, meshes);
  add_sliding(rows, meshes);
  add_time(rows, meshes);
  return rows;
}

}  // namespace fretval
