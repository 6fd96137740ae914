#include "comparison/verification/exact/exact_rows.h"

namespace fretval {

Rows exact_rows() {
  const auto meshes = half_space_meshes({16, 32, 64, 128});
  Rows rows;
  for (const auto theme :
       {indentation_rows, sliding_rows, oblique_rows, worn_edge_rows, relaxation_rows, pressing_rows, periodic_rows})
    append(rows, theme(meshes, {}));
  append(rows, bulk_rows(bulk_meshes(4), 1));
  return rows;
}

}  // namespace fretval
