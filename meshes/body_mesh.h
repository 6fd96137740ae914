#pragma once

#include <functional>
#include <string>
#include <vector>

#include "meshes/coarse_mesh.h"
#include "meshes/mesh.h"

namespace fretval::meshes {

/// The meridian section of a body r >= 0, z <= 0 with a contact line on z = 0. All lengths in one unit, of any choice:
/// the mesh scales with it.
struct BodySection {
  std::vector<double> contact_nodes;  ///< r of the nodes on the contact line: 0 first, strictly increasing
  Outline outline;                    ///< its radius is larger than the last contact node
  double growth;                      ///< alpha: element size per distance from the contact line, 0.02 to 1
};

/// Element size wanted at (r, z), the smallest over the contact elements i of
///     max(size of element i, growth * distance from element i).
double element_size(const std::vector<double>& contact_nodes, double growth, double r, double z);

/// All-quadrilateral mesh of a section, of the size `element_size`, and of no more than half the thickness. The nodes
/// of the contact line are exactly the given ones; axis nodes lie exactly on r = 0, surface nodes exactly on z = 0,
/// those of a base and of a side on these, far nodes on the arc to roundoff. An arc is the far boundary, a flat side is
/// free. The same input gives the same mesh. The result passes `audit`. name: of the body, for messages.
///
/// gmsh triangulates the section at twice the size and merges triangles to quadrilaterals; splitting every cell at its
/// centre then leaves quadrilaterals alone, whatever could not be merged. Under a contact line of equal elements the
/// two topmost layers are squares, unless the body is thinner than three of them. Neighbouring contact elements should
/// differ by less than a factor of 2, and none be smaller than 1e-9 of the rest: otherwise cells get poor, down to an
/// error.
///
/// Throws MeshError for input outside the ranges above, if gmsh fails, or if a cell comes out not convex.
/// Threads wait for each other: gmsh keeps global state, initialised and finalised here. It must not be in use
/// elsewhere in the program meanwhile. gmsh leaves OpenMP at one thread (omp_set_num_threads) for the whole program.
Mesh body_mesh(const BodySection& section, const std::string& name);

}  // namespace fretval::meshes
