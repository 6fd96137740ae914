#pragma once

#include <filesystem>

#include "meshes/mesh.h"
#include "meshes/mesh_error.h"

namespace fretval::meshes {

/// Writes a mesh as ASCII MSH 2.2 with the physical curves axis (1), contact (2), free (3), far (4) and the physical
/// surface body (10), or those of its materials from 10 on. Coordinates keep all their digits. Nodes, cells and edges
/// keep their order; nodes are counted from 1 in the file, elements from 1 with the edges first. The file appears under
/// its name only when it is complete: it is written next to it as FILE.partial, then renamed. Throws
/// std::filesystem::filesystem_error if the system refuses to write.
void write_msh(const Mesh& mesh, const std::filesystem::path& file);

/// Reads an ASCII .msh file of version 2.2 or 4.1, from `write_msh` or gmsh: 4-node quadrilaterals in the physical
/// surface "body", 2-node lines in the physical curves "axis", "contact", "free" and "far", x = r, y = z, third
/// coordinate 0. Groups are known by name, whatever their numbers. Points in physical groups are ignored. If the whole
/// body is clockwise it is turned round.
///
/// Throws MeshError "FILE: what, value, what would be valid" for a file that is missing, empty, truncated, binary, or
/// of another version; counts that the file cannot hold; nodes out of the plane; other elements; a missing or unknown
/// group, an element in none or two. It does not `audit` the mesh.
Mesh read_msh(const std::filesystem::path& file);

}  // namespace fretval::meshes
