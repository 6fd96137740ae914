#pragma once

#include <vector>

#include "meshes/mesh.h"

namespace fretval::meshes {

/// An elastic half-space cut off at a hemisphere: its meridian section r >= 0, z <= 0, r^2 + z^2 <= far_radius^2.
/// All lengths in one unit, of any choice: the mesh scales with it.
struct QuarterDisc {
  std::vector<double> contact_nodes;  ///< r of the nodes on the contact line: 0 first, strictly increasing
  double far_radius;                  ///< larger than the last contact node; 20 to 30 times suits a half-space
  double growth = 0.15;               ///< see body_mesh
};

/// The mesh of a quarter disc. Throws MeshError, see body_mesh.
Mesh quarter_disc(const QuarterDisc& disc);

}  // namespace fretval::meshes
