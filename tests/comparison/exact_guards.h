#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "comparison/verification/exact/exact_rows.h"

namespace fretval {

/// The mesh of the goals, alone.
inline const Meshes& goal_mesh() {
  static const auto meshes = half_space_meshes({64});
  return meshes;
}

using NamesOfRows = std::set<std::string>;

inline NamesOfRows names_of(const Rows& rows, bool failing_only = false) {
  NamesOfRows names;
  for (const auto& row : rows)
    if (!failing_only || !failure_of(row).empty()) names.insert(row.solution + ": " + row.quantity);
  return names;
}

/// Every row passes, and fails if the exact solutions are of some other scene.
inline void expect_to_guard(Rows (*rows_of)(const Meshes&, const ExactScene&), const std::vector<ExactScene>& others) {
  const auto rows = rows_of(goal_mesh(), {});
  EXPECT_EQ(names_of(rows, true), NamesOfRows{});
  NamesOfRows caught;
  for (const auto& other : others) caught.merge(names_of(rows_of(goal_mesh(), other), true));
  EXPECT_EQ(caught, names_of(rows));
}

}  // namespace fretval
