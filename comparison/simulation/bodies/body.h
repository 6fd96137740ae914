#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comparison/simulation/fem_case/fem_case.h"
#include "fem/condensation/condensation.h"
#include "fem/operators/harmonic_space.h"
#include "fem/operators/sparse_matrix.h"
#include "fem/ring_contact/contact_problem.h"
#include "meshes/mesh.h"
#include "meshes/quality.h"

namespace fretval {

/// Seconds spent on a body.
struct BodyCost {
  double mesh = 0, assembly = 0, factorisation = 0;
  double reading = 0;  ///< from a store of operators, instead of the three

  [[nodiscard]] double total() const { return mesh + assembly + factorisation + reading; }
};

/// The mesh that a description asks for. Throws meshes::MeshError, also where the file of a given one has changed.
meshes::Mesh mesh_of(const BodyDescription& description);

/// Degrees of freedom of a body on a mesh without holes, before it is made: of both harmonics if it has two.
std::size_t n_dofs_on(const meshes::Mesh& mesh, unsigned degree, bool tangential);

/// The mesh as the finite elements take it: with Poisson's ratio and what the base does.
fem::GridData grid_of(const meshes::Mesh& mesh, const BodyDescription& description);

/// One harmonic of the body before it is factorised.
struct HarmonicOperators {
  fem::HarmonicSpace space;
  fem::SparseMatrix stiffness;
};

/// What finite elements make of a mesh.
struct Operators {
  HarmonicOperators normal;
  std::optional<HarmonicOperators> tangential;  ///< only if the indenter moves tangentially
  meshes::MeshQuality mesh_quality;
  BodyCost cost;
};

/// Audits the mesh and assembles its stiffness. name: of the mesh, for messages. Throws meshes::MeshError.
Operators assemble_operators(const meshes::Mesh& mesh, const std::string& name, const BodyDescription& description);

/// One harmonic of the body: its space, its factorised stiffness and the contact problem condensed from it.
struct HarmonicBody {
  fem::HarmonicSpace space;
  fem::Condensation condensation;
  fem::ContactProblem contact;
};

/// The elastic body with its harmonics, ready for any motion, friction, rheology and profile on its contact line.
struct Body {
  HarmonicBody normal;
  std::optional<HarmonicBody> tangential;  ///< only if the indenter moves tangentially
  meshes::MeshQuality mesh_quality;
  BodyCost cost;

  [[nodiscard]] unsigned n_dofs() const {
    return normal.space.n_dofs() + (tangential ? tangential->space.n_dofs() : 0);
  }
};

/// Half-spaces that know where the edges of a body's rings lie (fem::Compliance::half_space); null: it is one itself.
struct RingEdges {
  std::shared_ptr<const fem::Compliance> normal, tangential;
};

/// Factorises the operators and condenses them to the contact line. Throws fem::SolverError.
Body condense(Operators&& operators, const RingEdges& edges = {});

/// On a generated mesh, with the time of that in the cost.
Body make_body(const BodyDescription& description);

/// Figures of a body.
struct BodySummary {
  meshes::MeshQuality mesh_quality;
  BodyCost cost;
  unsigned n_dofs;
  std::size_t n_contact_nodes;
  std::vector<double> radii;                         ///< of the rings
  bool from_store = false;                           ///< not made, but taken from a store of operators
  std::shared_ptr<const BodySummary> original = {};  ///< of a scaled body: what it was scaled from
};

/// Different bodies but for their scales, and those of them that came from a store of operators.
struct BodyCount {
  int all = 0, from_store = 0;
};
BodyCount count_of(const std::vector<std::shared_ptr<const BodySummary>>& bodies);

/// The bodies of computations by resolution; a failed one has no body.
template <class Computations>
BodyCount count_bodies_of(const Computations& all) {
  std::vector<std::shared_ptr<const BodySummary>> bodies;
  for (const auto& [resolution, computation] : all) bodies.push_back(computation.fe.body);
  return count_of(bodies);
}

/// What histories need of a body: a thousandth of its memory.
struct ContactBody {
  fem::ContactProblem normal;
  std::optional<fem::ContactProblem> tangential;  ///< only if the indenter moves tangentially
  std::shared_ptr<const BodySummary> summary;
};

ContactBody contact_body(const Body& body);

/// What a half-space tells of the rings of another body.
RingEdges ring_edges(const ContactBody& half_space);

/// A body with all of its lengths larger by a factor: areas grow with its square, and the compliance of rings
/// (see fem::Compliance) with its cube.
ContactBody scaled(const ContactBody& body, double factor);

/// With wider rings, whose radii are some of those of the body; see fem::merged_rings.
ContactBody with_merged_rings(const ContactBody& body, const std::vector<double>& radii);

}  // namespace fretval
