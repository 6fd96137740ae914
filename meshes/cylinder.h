#pragma once

#include <vector>

#include "meshes/mesh.h"

namespace fretval::meshes {

/// A cylinder on a flat base, its side free: its meridian section 0 <= r <= radius, -thickness <= z <= 0. A layer that
/// goes on outwards is a cylinder so wide that its side does not matter. All lengths in one unit, of any choice: the
/// mesh scales with it.
struct Cylinder {
  std::vector<double> contact_nodes;  ///< r of the nodes on the contact line: 0 first, strictly increasing
  double thickness;                   ///< positive
  double radius;                      ///< larger than the last contact node
  double growth = 0.15;               ///< see body_mesh
};

/// The mesh of a cylinder. Throws MeshError, see body_mesh.
Mesh cylinder(const Cylinder& body);

}  // namespace fretval::meshes
