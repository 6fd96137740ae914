#pragma once

#include <vector>

#include "comparison/case/case.h"
#include "comparison/simulation/fem_case/body_description.h"
#include "comparison/simulation/fem_case/resolution.h"

namespace fretval {

/// A mesh that the case brings along.
struct GivenBody {
  GivenMesh mesh;
  std::vector<double> radii;  ///< of the nodes of its contact line, as in the file
  double scale;               ///< the last of them over the unit of length
  unsigned rings_per_radius;  ///< edges within the unit of length
};

/// What finite elements take from a mesh that the case brings along. length: the unit, in m. Throws InputError for a
/// contact line of too few edges within that, or one that ends there.
GivenBody given_body(const Case& input, double length);

/// How many rings within the contact radius it takes to tell a contact.
constexpr unsigned fewest_given_rings = 6;

/// The body of a resolution: rings are edges of the mesh, or 2, 4 ... neighbours together where the resolution has
/// fewer, beginning elsewhere where its edge_before_node says so; cells are split into four as often as it has more
/// rings, and as its mesh_refinements ask for. Of the description the mesh, the rings, the thickness and the scale are
/// set. thickness: over the unit of length.
void take_given(const GivenBody& given, double thickness, const Resolution& resolution, BodyDescription& body);

}  // namespace fretval
