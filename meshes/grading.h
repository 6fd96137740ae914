#pragma once

#include <vector>

namespace fretval::meshes {

/// n + 1 equidistant nodes on [0, length]; the first is 0 and the last is length, exactly.
/// Throws MeshError unless length > 0 and n >= 1.
std::vector<double> uniform_nodes(double length, unsigned n);

/// Nodes on [0, length], graded towards a node at edge_radius (where a stress is singular), in the unit of length.
///
/// Away from edge_radius the elements are fine_size * (1 + growth)^k, k = 0, 1, ..., at most coarse_size. On either
/// side the sizes are then shrunk by one common factor so that a whole number of them fits: an element is never larger
/// than asked. 0, edge_radius and length are nodes exactly. edge_radius = 0 or length grades from one side alone.
///
/// Throws MeshError unless 0 <= edge_radius <= length, 1e-9 length <= fine_size <= coarse_size and growth >= 0, and if
/// more than 100000 elements were needed on one side.
std::vector<double> graded_nodes(double edge_radius, double length, double coarse_size, double fine_size,
                                 double growth);

}  // namespace fretval::meshes
