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

/// Every row fails if the exact solutions are of some other scene. That all pass otherwise is for exact_rows_test.cc.
inline void expect_to_guard(Rows (*rows_of)(const Meshes&, const ExactScene&), const std::vector<ExactScene>& others) {
  NamesOfRows caught, all;
  for (const auto& other : others) {
    const auto rows = rows_of(goal_mesh(), other);
    caught.merge(names_of(rows, true));
    all.merge(names_of(rows));
  }
  EXPECT_EQ(caught, all);
}

}  // namespace fretval
