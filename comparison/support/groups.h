#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fretval {

/// Indices in groups of equal ones, by their first members. same(i, j): whether two are equal.
template <class Same>
std::vector<std::vector<std::size_t>> groups_of(const std::vector<std::size_t>& indices, const Same& same) {
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t i : indices) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return same(g.front(), i); });
    if (group == groups.end()) group = groups.emplace(group);
    group->push_back(i);
  }
  return groups;
}

}  // namespace fretval
