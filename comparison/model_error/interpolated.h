#pragma once

#include <optional>
#include <vector>

namespace fretval {

/// A value at a place, and what it may be off by.
struct Node {
  double at, value, bar;
};

/// Interpolated, with its uncertainty: the bars of the nodes, and what interpolation is off by: a third of the
/// difference from what every other node gives, which an error of second order in their distance has; cubics are of
/// fourth.
struct Interpolated {
  double value, uncertainty;
};

/// The polynomial through the four nodes about a place, or all if there are fewer; nodes: rising. Empty: it lies
/// outside the nodes, or there are fewer than two.
std::optional<Interpolated> interpolated(const std::vector<Node>& nodes, double at);

}  // namespace fretval
