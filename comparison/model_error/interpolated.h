#pragma once

#include <optional>
#include <vector>

namespace fretval {

/// A value at a place, and what it may be off by.
struct Node {
  double at, value, bar;
};

/// Interpolated, with its uncertainty: the bars of the nodes, and the difference from what every other node gives.
struct Interpolated {
  double value, uncertainty;
};

/// The polynomial through the four nodes about a place, or all if there are fewer; nodes: rising. Empty: it lies
/// outside the nodes, or there are fewer than two.
std::optional<Interpolated> interpolated(const std::vector<Node>& nodes, double at);

}  // namespace fretval
