#pragma once

#include <string>

#include "meshes/mesh.h"

namespace fretval::meshes {

/// The steps of `audit` for the boundary, of a mesh whose nodes and cells have passed. Each step relies on those before
/// it. All throw MeshError.

/// Edges belong to two cells, or to one cell and one part of the boundary.
void audit_edges(const Mesh& mesh, const std::string& name);

/// All parts of the boundary are there, of far and base at least one; the axis is the line r = 0, and no other edge
/// lies on it.
void audit_parts_of_boundary(const Mesh& mesh, const std::string& name);

/// The contact line is z = 0 from r = 0 on without gaps.
void audit_contact_line(const Mesh& mesh, const std::string& name);

/// The boundary is one closed polygon, and the cells fill it once.
void audit_body(const Mesh& mesh, const std::string& name);

}  // namespace fretval::meshes
