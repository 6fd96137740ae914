#pragma once

#include <vector>

#include "meshes/mesh.h"

namespace fretval::meshes {

/// An elastic half-space cut off at a hemisphere: its meridian section r >= 0, z <= 0, r^2 + z^2 <= far_radius^2.
/// All lengths in one unit, of any choice: the mesh scales with it.
struct QuarterDisc {
  std::vector<double> contact_nodes;  ///< r of the nodes on the contact line: 0 first, strictly increasing
  double far_radius;                  ///< larger than the last contact node; 20 to 30 times suits a half-space
  double growth = 0.15;               ///< alpha: element size per distance from the contact line, 0.02 to 1
};

/// Element size wanted at (r, z), the smallest over the contact elements i of
///     max(size of element i, growth * distance from element i).
double element_size(const QuarterDisc& disc, double r, double z);

/// All-quadrilateral mesh of the quarter disc, of the size `element_size`. The nodes of the contact line are exactly
/// the given ones; axis nodes lie exactly on r = 0, surface nodes exactly on z = 0, far nodes on the arc to roundoff.
/// The same input gives the same mesh. The result passes `audit`.
///
/// gmsh triangulates the disc at twice the size and merges triangles to quadrilaterals; splitting every cell at its
/// centre then leaves quadrilaterals alone, whatever could not be merged. Under a contact line of equal elements the
/// two topmost layers are squares. Neighbouring contact elements should differ by less than a factor of 2, and none be
/// smaller than 1e-9 of the rest: otherwise cells get poor, down to an error.
///
/// Throws MeshError for input outside the ranges above, if gmsh fails, or if a cell comes out not convex.
/// Threads wait for each other: gmsh keeps global state, initialised and finalised here. It must not be in use
/// elsewhere in the program meanwhile. gmsh leaves OpenMP at one thread (omp_set_num_threads) for the whole program.
Mesh quarter_disc(const QuarterDisc& disc);

}  // namespace fretval::meshes
