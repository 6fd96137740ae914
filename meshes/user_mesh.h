#pragma once

#include <filesystem>

#include "meshes/mesh.h"
#include "meshes/mesh_error.h"

namespace fretval::meshes {

/// Reads a mesh that somebody has drawn of the meridian section of their own body: an ASCII .msh file of version 2.2 or
/// 4.1, in any unit of length.
///
/// x is r and y is z, or, where y is 0 throughout, z is z; the contact surface is level, wherever it lies, and becomes
/// z = 0. Groups are known by name: physical curves "contact", "axis" and "base" have to be there; "side" and "free"
/// are free, as is every edge of the boundary that is in no group or in one of another name. Curves inside the body,
/// points, and nodes that no cell uses do not matter. Physical surfaces are materials, in the order in which they
/// appear; cells in no group are of the material "". A surface that is drawn clockwise is turned round. Where there are
/// triangles, they are split into three quadrilaterals each, and all quadrilaterals into four, so that contact edges
/// get half as wide. Coordinates off r = 0 or the contact surface by roundoff are moved there.
///
/// Throws MeshError "FILE: what, value, what would be valid" for what read_sections refuses, a group that is missing,
/// one named "far", a contact surface that is not level or has something above it, a hanging node, and for all that
/// `audit` refuses.
Mesh read_user_mesh(const std::filesystem::path& file);

}  // namespace fretval::meshes
