#pragma once

#include <string>
#include <vector>

#include "comparison/verification/exact/convergence_rows.h"
#include "fem/full_model/manufactured_solution.h"
#include "fem/operators/grid_data.h"

namespace fretval {

/// A mesh of the quarter disc of radius 6 for the fields in the body, n_rings on a contact line of length 1.
struct BulkMesh {
  int n_rings;
  fem::GridData grid;
};

/// 4 rings, and each further mesh with every cell split into four.
std::vector<BulkMesh> bulk_meshes(int n_meshes);

struct BulkCase {
  std::string name;
  fem::Harmonic harmonic;
  double displacement_tolerance, pressure_tolerance;  ///< on the finest mesh
};

/// Displacement and pressure in the body under the tractions of a field: see fem/manufactured_solution.h.
std::vector<ConvergenceRow> bulk_rows(const std::vector<BulkMesh>& meshes, const BulkCase& bulk,
                                      const fem::StokesField& load, const fem::StokesField& exact);

}  // namespace fretval
