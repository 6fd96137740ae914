#include "comparison/verification/exact/exact_rows.h"

#include "comparison/support/progress.h"

namespace fretval {

Rows exact_rows() {
  const auto meshes = half_space_meshes({16, 32, 64, 128});
  Rows rows;
  const auto themes = {indentation_rows, sliding_rows,  oblique_rows, worn_edge_rows,
                       relaxation_rows,  pressing_rows, periodic_rows};
  Progress progress(themes.size() + 1);
  const auto add = [&](const Rows& more) {
    append(rows, more);
    progress.done(more.front().solution);
  };
  for (const auto theme : themes) add(theme(meshes, {}));
  add(bulk_rows(bulk_meshes(4), 1));
  return rows;
}

}  // namespace fretval
