#pragma once

#include <string>

#include "meshes/mesh.h"
#include "meshes/quality.h"

namespace fretval::meshes {

/// Throws MeshError for the first defect found that would make a finite element result wrong without a word:
///  - a node that is not finite, has r < 0 or z > 0, that no cell uses or that coincides with another one (closer than
///    1e-6 of the shortest edge);
///  - a cell that is collapsed, inverted, a bow-tie or not convex (smallest scaled corner Jacobian below 1e-8), or that
///    is there twice;
///  - an edge of one cell alone that is in no part of the boundary (a hanging node, or an untagged edge), one of the
///    boundary that is in two parts or inside the body, one of more than two cells;
///  - a part of the boundary without edges, axis edges off r = 0, edges on r = 0 that are not axis, contact edges off
///    z = 0, a contact line that does not start at r = 0 or has gaps;
///  - a body in several parts, with holes, or with cells that overlap (area of the cells unlike that of the polygon of
///    the boundary by more than 1e-10 of it).
/// The message is "name: entity, value, what would be valid"; cells, edges and nodes are counted from 0 in the order of
/// the mesh and given with coordinates (r, z).
void audit(const Mesh& mesh, const std::string& name);

}  // namespace fretval::meshes
