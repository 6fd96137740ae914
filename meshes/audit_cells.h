#pragma once

#include <string>

#include "meshes/mesh.h"

namespace fretval::meshes {

/// The steps of `audit` for nodes and cells, in the order in which they rely on each other. All throw MeshError.

/// There is at least one cell, and every node index of cells and edges is that of a node.
void audit_indices(const Mesh& mesh, const std::string& name);

/// Coordinates finite, r >= 0, z <= 0.
void audit_nodes(const Mesh& mesh, const std::string& name);

/// Every cell convex and counter-clockwise, and there once.
void audit_cells(const Mesh& mesh, const std::string& name);

/// Every node is used by a cell, and no two coincide.
void audit_node_use(const Mesh& mesh, const std::string& name);

/// "node 3 at (0.1, -0.2)"
std::string describe_node(const Mesh& mesh, unsigned node);

}  // namespace fretval::meshes
