#pragma once

#include <vector>

namespace fretval::meshes {

/// n + 1 equidistant nodes on [0, length]; the first is 0 and the last is length, exactly.
/// Throws MeshError unless length > 0 and n >= 1.
std::vector<double> uniform_nodes(double length, unsigned n);

/// Where contact elements are fine: equal elements of at most `size` on [inner, outer], in the unit of length. inner =
/// outer makes a single node, for an edge at which a stress is singular.
struct FineBlock {
  double inner, outer, size;
};

/// Nodes on [0, length], graded towards a fine block.
///
/// Away from the block the elements are size * (1 + growth)^k, k = 0, 1, ..., at most coarse_size. On either side the
/// sizes are then shrunk by one common factor so that a whole number of them fits: an element is never larger than
/// asked. 0, the ends of the block and length are nodes exactly.
///
/// Throws MeshError unless 0 <= inner <= outer <= length, 1e-9 length <= size <= coarse_size and growth >= 0, and if
/// more than 100000 elements were needed on one side.
std::vector<double> graded_nodes(const FineBlock& block, double length, double coarse_size, double growth);

}  // namespace fretval::meshes
