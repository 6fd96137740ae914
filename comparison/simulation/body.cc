#include "comparison/simulation/body.h"

#include "comparison/support/stopwatch.h"
#include "fem/operators/stiffness.h"
#include "meshes/audit.h"
#include "meshes/quarter_disc.h"

namespace fretval {
namespace {

HarmonicBody make_harmonic(const fem::GridData& grid, fem::Harmonic harmonic, unsigned degree, BodyCost& cost) {
  Stopwatch watch;
  fem::HarmonicSpace space(grid, harmonic, degree);
  const auto stiffness = fem::assemble_stiffness(space);
  cost.assembly += watch.lap();
  fem::Condensation condensation(
      stiffness, space.contact_line().dofs,
      harmonic == fem::Harmonic::normal ? "stiffness of the normal harmonic" : "stiffness of the tangential harmonic");
  fem::ContactProblem contact(fem::contact_compliance(space.contact_line(), condensation));
  cost.factorisation += watch.lap();
  return {std::move(space), std::move(condensation), std::move(contact)};
}

}  // namespace

fem::GridData grid_of(const meshes::Mesh& mesh) {
  fem::GridData grid{mesh.nodes, mesh.cells, {}};
  for (const auto& edge : mesh.edges)
    grid.boundary.push_back({edge.nodes, static_cast<fem::BoundaryPart>(edge.boundary)});
  return grid;
}

meshes::Mesh mesh_of(const BodySpecification& specification) {
  return meshes::quarter_disc({specification.contact_nodes, specification.far_radius, specification.growth});
}

Body make_body(const meshes::Mesh& mesh, const std::string& name, unsigned degree, bool tangential) {
  meshes::audit(mesh, name);
  const auto grid = grid_of(mesh);
  BodyCost cost;
  auto normal = make_harmonic(grid, fem::Harmonic::normal, degree, cost);
  std::optional<HarmonicBody> second;
  if (tangential) second.emplace(make_harmonic(grid, fem::Harmonic::tangential, degree, cost));
  return {meshes::quality(mesh), std::move(normal), std::move(second), cost};
}

Body make_body(const BodySpecification& specification) {
  Stopwatch watch;
  const auto mesh = mesh_of(specification);
  const double seconds = watch.lap();
  Body body = make_body(mesh, "generated mesh", specification.degree, specification.tangential);
  body.cost.mesh = seconds;
  return body;
}

}  // namespace fretval
