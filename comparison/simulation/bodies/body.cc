#include "comparison/simulation/bodies/body.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <utility>

#include "comparison/support/content_hash.h"
#include "comparison/support/files.h"
#include "comparison/support/parallel.h"
#include "comparison/support/stopwatch.h"
#include "fem/condensation/far_field.h"
#include "fem/condensation/merged_rings.h"
#include "fem/condensation/moved_rings.h"
#include "fem/operators/stiffness.h"
#include "meshes/audit.h"
#include "meshes/cylinder.h"
#include "meshes/mesh_error.h"
#include "meshes/quarter_disc.h"
#include "meshes/refined.h"
#include "meshes/user_mesh.h"

namespace fretval {
namespace {

HarmonicOperators assemble_harmonic(const fem::GridData& grid, const fem::FourierOrder& order, unsigned degree) {
  fem::HarmonicSpace space(grid, order, degree);
  auto stiffness = fem::assemble_skeleton_stiffness(space);
  return {std::move(space), std::move(stiffness)};
}

/// The body with other contact problems in the place of its own.
ContactBody with_problems(const ContactBody& body, fem::ContactProblem normal,
                          std::optional<fem::ContactProblem> tangential) {
  auto summary = *body.summary;
  summary.original = body.summary->original ? body.summary->original : body.summary;
  summary.radii = normal.compliance.radii;
  return {std::move(normal), std::move(tangential), std::make_shared<const BodySummary>(std::move(summary))};
}

/// The body with a changed compliance in the place of each.
template <class Change>
ContactBody changed(const ContactBody& body, const Change& change) {
  std::optional<fem::ContactProblem> tangential;
  if (body.tangential) tangential.emplace(change(body.tangential->compliance));
  return with_problems(body, fem::ContactProblem(change(body.normal.compliance)), std::move(tangential));
}

/// The mesh of a given file, scaled so that its contact line has the length of the scale.
meshes::Mesh given_mesh(const BodyDescription& description) {
  const auto& given = description.given;
  if (const auto now = content_hash(content_of(given.file)); now != given.content)
    throw meshes::MeshError(fmt::format("{}: its content is {} now, must stay what it was when the case was read, {}",
                                        given.file, now, given.content));
  auto mesh = meshes::read_user_mesh(given.file);
  for (unsigned k = 0; k < given.n_refinements; ++k) mesh = meshes::refined(mesh);
  const double length = meshes::contact_radii(mesh).back();
  for (auto& node : mesh.nodes)
    for (double& x : node) x = description.scale * (x / length);
  return mesh;
}

HarmonicBody condense_harmonic(HarmonicOperators&& operators, std::shared_ptr<const fem::Compliance> edges,
                               const std::string& name) {
  fem::Condensation condensation(operators.stiffness, operators.space.contact_line().dofs, name);
  auto compliance = fem::contact_compliance(operators.space.contact_line(), condensation.schur_complement());
  fem::add_far_field(operators.space, condensation, {fem::ring_component(operators.space.order())}, compliance);
  compliance.half_space = std::move(edges);
  fem::ContactProblem contact(std::move(compliance));
  return {std::move(operators.space), std::move(condensation), std::move(contact)};
}

}  // namespace

meshes::Mesh mesh_of(const BodyDescription& description) {
  if (!description.given.file.empty()) return given_mesh(description);
  auto nodes = description.contact_nodes;
  for (double& node : nodes) node *= description.scale;
  if (!description.is_half_space())
    return meshes::cylinder({std::move(nodes), description.thickness, description.far_radius, description.growth});
  return meshes::quarter_disc({std::move(nodes), description.scale * description.far_radius, description.growth});
}

std::size_t n_dofs_on(const meshes::Mesh& mesh, unsigned degree, bool tangential) {
  const std::size_t n_corners = mesh.nodes.size(), n_cells = mesh.cells.size();
  const std::size_t n_edges = n_corners + n_cells - 1;  // Euler
  const auto n_nodes = [&](std::size_t k) { return n_corners + (k - 1) * n_edges + (k - 1) * (k - 1) * n_cells; };
  const std::size_t n_displacements = tangential ? 2 + 3 : 2, n_pressures = tangential ? 2 : 1;
  return n_displacements * n_nodes(degree) + n_pressures * n_nodes(degree - 1);
}

fem::GridData grid_of(const meshes::Mesh& mesh, const BodyDescription& description) {
  fem::GridData grid{mesh.nodes, mesh.cells, {}, {description.poisson_ratio, {}}};
  const auto part_of = [&](meshes::Boundary boundary) {
    if (boundary != meshes::Boundary::base) return static_cast<fem::BoundaryPart>(boundary);
    return description.slides_on_base ? fem::BoundaryPart::sliding : fem::BoundaryPart::bonded;
  };
  if (!description.given.moduli.empty())
    for (const unsigned material : mesh.material)
      grid.elasticity.moduli.push_back(description.given.moduli.at(material));
  for (const auto& edge : mesh.edges) grid.boundary.push_back({edge.nodes, part_of(edge.boundary)});
  return grid;
}

Operators assemble_operators(const meshes::Mesh& mesh, const std::string& name, const BodyDescription& description) {
  meshes::audit(mesh, name);
  Stopwatch watch;
  const auto grid = grid_of(mesh, description);
  std::optional<HarmonicOperators> harmonics[2];
  for_each_in_parallel(description.tangential ? 2 : 1, [&](std::size_t n) {
    harmonics[n].emplace(assemble_harmonic(grid, n == 0 ? fem::axisymmetric : fem::lateral, description.degree));
  });
  Operators operators{std::move(*harmonics[0]), std::move(harmonics[1]), meshes::quality(mesh), {}};
  operators.cost.assembly = watch.lap();
  return operators;
}

Body condense(Operators&& operators, const RingEdges& edges) {
  Stopwatch watch;
  std::optional<HarmonicBody> harmonics[2];
  for_each_in_parallel(operators.tangential ? 2 : 1, [&](std::size_t n) {
    harmonics[n].emplace(
        n == 0 ? condense_harmonic(std::move(operators.normal), edges.normal, "stiffness of the normal harmonic")
               : condense_harmonic(std::move(*operators.tangential), edges.tangential,
                                   "stiffness of the tangential harmonic"));
  });
  Body body{std::move(*harmonics[0]), std::move(harmonics[1]), operators.mesh_quality, operators.cost};
  body.cost.factorisation = watch.lap();
  return body;
}

Body make_body(const BodyDescription& description) {
  RingEdges edges;
  if (!description.is_half_space()) edges = ring_edges(contact_body(make_body(half_space_with_rings_of(description))));
  return make_body(description, edges);
}

Body make_body(const BodyDescription& description, const RingEdges& edges) {
  Stopwatch watch;
  const auto mesh = mesh_of(description);
  const double seconds = watch.lap();
  Body body = condense(assemble_operators(mesh, "generated mesh", description), edges);
  body.cost.mesh = seconds;
  return body;
}

BodyCount count_of(const std::vector<std::shared_ptr<const BodySummary>>& bodies) {
  BodyCount count;
  std::set<std::shared_ptr<const BodySummary>> different;
  for (const auto& body : bodies)
    if (body) different.insert(body->original ? body->original : body);  // null: of a computation that failed
  for (const auto& body : different) {
    ++count.all;
    count.from_store += body->from_store ? 1 : 0;
  }
  return count;
}

RingEdges ring_edges(const ContactBody& half_space) {
  const auto edges_of = [](const fem::ContactProblem& problem) {
    return std::make_shared<const fem::Compliance>(problem.compliance);
  };
  return {edges_of(half_space.normal), half_space.tangential ? edges_of(*half_space.tangential) : nullptr};
}

ContactBody contact_body(const Body& body) {
  const auto summary = std::make_shared<const BodySummary>(BodySummary{body.mesh_quality, body.cost, body.n_dofs(),
                                                                       body.normal.space.contact_line().dofs.size(),
                                                                       body.normal.contact.compliance.radii, false});
  std::optional<fem::ContactProblem> tangential;
  if (body.tangential) tangential.emplace(body.tangential->contact);
  return {body.normal.contact, std::move(tangential), summary};
}

ContactBody scaled(const ContactBody& body, double factor) {
  return changed(body, [factor](const fem::Compliance& compliance) { return fem::scaled(compliance, factor); });
}

ContactBody with_moved_rings(const ContactBody& body, const ContactBody& coarse, double factor) {
  const auto moved = [factor](const fem::ContactProblem& of_rings, const fem::ContactProblem& of_coarse) {
    return fem::ContactProblem(fem::moved_rings(of_rings.compliance, of_coarse.compliance, factor));
  };
  std::optional<fem::ContactProblem> tangential;
  if (body.tangential) tangential.emplace(moved(*body.tangential, *coarse.tangential));
  return with_problems(body, moved(body.normal, coarse.normal), std::move(tangential));
}

ContactBody with_merged_rings(const ContactBody& body, const std::vector<double>& radii) {
  return changed(body, [&](const fem::Compliance& compliance) { return fem::merged_rings(compliance, radii); });
}

}  // namespace fretval
