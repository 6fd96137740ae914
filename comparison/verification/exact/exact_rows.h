#pragma once

#include <vector>

#include "comparison/verification/exact/exact_parts.h"
#include "fem/operators/grid_data.h"

namespace fretval {

/// The suite `exact`: finite elements against exact solutions, on meshes and steps that are refined. Every row, on 16,
/// 32, 64 and 128 rings per contact radius.
Rows exact_rows();

// Rows of the suite `exact` by theme.

/// A mesh of the quarter disc of radius 6 for the fields in the body, n_rings on a contact line of length 1.
struct BulkMesh {
  int n_rings;
  fem::GridData grid;
};

/// A mesh with 4 rings, and n_meshes - 1 refinements of it, each with every cell split into four.
std::vector<BulkMesh> bulk_meshes(int n_meshes);

Rows indentation_rows(const Meshes& meshes, const ExactScene& exact);  ///< Hertz, cone, power law, flat punch, stick
Rows sliding_rows(const Meshes& meshes, const ExactScene& exact);      ///< Cattaneo-Mindlin, unloading, cycle
Rows oblique_rows(const Meshes& meshes, const ExactScene& exact);      ///< Jaeger
Rows worn_edge_rows(const Meshes& meshes, const ExactScene& exact);    ///< the paper's limiting profile
Rows relaxation_rows(const Meshes& meshes, const ExactScene& exact);   ///< steps of the indentation
Rows pressing_rows(const Meshes& meshes, const ExactScene& exact);     ///< Lee-Radok, Ting
Rows periodic_rows(const Meshes& meshes, const ExactScene& exact);     ///< stick radii under the paper's motion
Rows poisson_rows(const std::vector<int>& n_rings, const ExactScene& exact);  ///< compressible half-spaces
Rows layer_rows(const std::vector<int>& n_rings, const ExactScene& exact);    ///< parabolas and punches on layers
Rows bulk_rows(const std::vector<BulkMesh>& meshes, double exact_force);      ///< Kelvin

}  // namespace fretval
