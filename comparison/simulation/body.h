#pragma once

#include <memory>
#include <optional>
#include <string>

#include "comparison/simulation/fem_case.h"
#include "fem/condensation/condensation.h"
#include "fem/history/normal_history.h"
#include "fem/operators/harmonic_space.h"
#include "meshes/mesh.h"
#include "meshes/quality.h"

namespace fretval {

/// One harmonic of the body: its space, its factorised stiffness and the contact problem condensed from it.
struct HarmonicBody {
  fem::HarmonicSpace space;
  fem::Condensation condensation;
  fem::ContactProblem contact;
};

/// Seconds spent on a body.
struct BodyCost {
  double mesh = 0, assembly = 0, factorisation = 0;

  [[nodiscard]] double total() const { return mesh + assembly + factorisation; }
};

/// The elastic body with its harmonics, ready for any motion, friction, rheology and profile on its contact line.
struct Body {
  meshes::MeshQuality mesh_quality;
  HarmonicBody normal;
  std::optional<HarmonicBody> tangential;  ///< only if the indenter moves tangentially
  BodyCost cost;

  [[nodiscard]] unsigned n_dofs() const {
    return normal.space.n_dofs() + (tangential ? tangential->space.n_dofs() : 0);
  }
};

/// The mesh that a specification asks for.
meshes::Mesh mesh_of(const BodySpecification& specification);

/// The mesh as the finite elements take it.
fem::GridData grid_of(const meshes::Mesh& mesh);

/// Audits the mesh, assembles and condenses. name: of the mesh, for messages. Throws meshes::MeshError,
/// fem::SolverError.
Body make_body(const meshes::Mesh& mesh, const std::string& name, unsigned degree, bool tangential = true);

/// Both at once, with the time of the mesh in the cost.
Body make_body(const BodySpecification& specification);

}  // namespace fretval
