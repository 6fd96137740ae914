#pragma once

#include <optional>
#include <vector>

namespace fretval {

/// A value at a place, and its error bar.
struct Node {
  double at, value, bar;
};

/// An interpolated value, and its uncertainty: the bars of the nodes and the error of the interpolation. For the latter
/// a third of the difference from the interpolation of every other node is taken, as for an error of second order in
/// the distance of the nodes; cubics are of fourth order.
struct Interpolated {
  double value, uncertainty;
};

/// The polynomial through the four nodes about a place, or all if there are fewer; nodes: rising. Empty: it lies
/// outside the nodes, or there are fewer than two.
std::optional<Interpolated> interpolated(const std::vector<Node>& nodes, double at);

}  // namespace fretval
