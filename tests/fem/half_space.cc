#include "tests/fem/half_space.h"

#include <map>
#include <tuple>

#include "fem/condensation/condensation.h"
#include "fem/operators/stiffness.h"
#include "meshes/cylinder.h"
#include "meshes/grading.h"
#include "meshes/quarter_disc.h"

namespace fretval::fem {
namespace {

using Line = std::tuple<double, unsigned>;  // its length, rings per unit length

const GridData& half_space_grid(const Line& line) {
  static std::map<Line, GridData> grids;
  auto found = grids.find(line);
  const auto [length, n_per_radius] = line;
  if (found == grids.end())
    found =
        grids.emplace(line, quarter_disc_grid(length, static_cast<unsigned>(n_per_radius * length), 25, 0.15)).first;
  return found->second;
}

const ContactProblem& condensed(const Line& line, const FourierOrder& order, unsigned degree) {
  static std::map<std::tuple<Line, FourierOrder, unsigned>, ContactProblem> problems;
  const auto key = std::make_tuple(line, order, degree);
  auto found = problems.find(key);
  if (found == problems.end()) {
    const HarmonicSpace space(half_space_grid(line), order, degree);
    const Condensation condensation(assemble_skeleton_stiffness(space), space.contact_line().dofs, "half-space");
    found = problems.emplace(key, contact_compliance(space.contact_line(), condensation.schur_complement())).first;
  }
  return found->second;
}

}  // namespace

GridData layer_grid(double contact_length, unsigned n_contact, double thickness, double growth, BoundaryPart base) {
  const auto mesh = meshes::cylinder(
      {meshes::uniform_nodes(contact_length, n_contact), thickness, contact_length + 12 * thickness, growth});
  GridData grid{mesh.nodes, mesh.cells, {}};
  for (const auto& edge : mesh.edges)
    grid.boundary.push_back(
        {edge.nodes, edge.boundary == meshes::Boundary::base ? base : static_cast<BoundaryPart>(edge.boundary)});
  return grid;
}

GridData quarter_disc_grid(double contact_length, unsigned n_contact, double far_radius, double growth) {
  const auto mesh = meshes::quarter_disc({meshes::uniform_nodes(contact_length, n_contact), far_radius, growth});
  GridData grid{mesh.nodes, mesh.cells, {}};
  for (const auto& edge : mesh.edges) grid.boundary.push_back({edge.nodes, static_cast<BoundaryPart>(edge.boundary)});
  return grid;
}

const ContactProblem& half_space(const FourierOrder& order, unsigned n_per_radius, unsigned degree) {
  return condensed({1.125, n_per_radius}, order, degree);
}

const ContactProblem& long_half_space(const FourierOrder& order, unsigned n_per_radius) {
  return condensed({1.375, n_per_radius}, order, 3);
}

}  // namespace fretval::fem
