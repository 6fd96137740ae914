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
  double reading = 0;  ///< from a store of operators, in the place of the other three

  [[nodiscard]] double total() const { return mesh + assembly + factorisation + reading; }
};

/// The mesh that a description asks for. Throws meshes::MeshError, also where the file of a given mesh has changed.
meshes::Mesh mesh_of(const BodyDescription& description);

/// Number of degrees of freedom of a body on a mesh without holes, before it is made; of both harmonics together if
/// tangential.
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

/// Half-spaces by which the edges of a body's rings are found (fem::Compliance::half_space); null: the body is a
/// half-space itself.
struct RingEdges {
  std::shared_ptr<const fem::Compliance> normal, tangential;
};

/// Factorises the operators and condenses them to the contact line. Throws fem::SolverError.
Body condense(Operators&& operators, const RingEdges& edges = {});

/// The body of a description on a generated mesh; its cost includes the meshing.
Body make_body(const BodyDescription& description);

/// The same with ring edges that are known, or none where nothing is read at an edge.
Body make_body(const BodyDescription& description, const RingEdges& edges);

/// Mesh quality, cost and size of a body.
struct BodySummary {
  meshes::MeshQuality mesh_quality;
  BodyCost cost;
  unsigned n_dofs;
  std::size_t n_contact_nodes;
  std::vector<double> radii;                         ///< of the rings
  bool from_store = false;                           ///< whether it was taken from a store of operators, not made
  std::shared_ptr<const BodySummary> original = {};  ///< body that it was scaled or merged from, or null
};

/// Number of bodies that differ in more than their scale, and how many of them came from a store of operators.
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

/// The ring edges of another body from a half-space with its rings.
RingEdges ring_edges(const ContactBody& half_space);

/// A body with all of its lengths larger by a factor: areas grow with its square, and the compliance of rings
/// (see fem::Compliance) with its cube.
ContactBody scaled(const ContactBody& body, double factor);

/// The body with rings that are wider by a factor; coarse: the same body under coarse rings, see fem::moved_rings.
ContactBody with_moved_rings(const ContactBody& body, const ContactBody& coarse, double factor);

/// The body with wider rings, whose radii are a selection of those of the body; see fem::merged_rings.
ContactBody with_merged_rings(const ContactBody& body, const std::vector<double>& radii);

}  // namespace fretval
