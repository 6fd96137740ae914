#include "tests/fem/half_space.h"

#include <map>
#include <tuple>

#include "fem/condensation/condensation.h"
#include "fem/operators/stiffness.h"
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

const ContactProblem& condensed(const Line& line, Harmonic harmonic, unsigned degree) {
  static std::map<std::tuple<Line, Harmonic, unsigned>, ContactProblem> problems;
  const auto key = std::make_tuple(line, harmonic, degree);
  auto found = problems.find(key);
  if (found == problems.end()) {
    const HarmonicSpace space(half_space_grid(line), harmonic, degree);
    const Condensation condensation(assemble_skeleton_stiffness(space), space.contact_line().dofs, "half-space");
    found = problems.emplace(key, contact_compliance(space.contact_line(), condensation.schur_complement())).first;
  }
  return found->second;
}

}  // namespace

GridData quarter_disc_grid(double contact_length, unsigned n_contact, double far_radius, double growth) {
  const auto mesh = meshes::quarter_disc({meshes::uniform_nodes(contact_length, n_contact), far_radius, growth});
  GridData grid{mesh.nodes, mesh.cells, {}};
  for (const auto& edge : mesh.edges) grid.boundary.push_back({edge.nodes, static_cast<BoundaryPart>(edge.boundary)});
  return grid;
}

const ContactProblem& half_space(Harmonic harmonic, unsigned n_per_radius, unsigned degree) {
  return condensed({1.125, n_per_radius}, harmonic, degree);
}

const ContactProblem& long_half_space(Harmonic harmonic, unsigned n_per_radius) {
  return condensed({1.375, n_per_radius}, harmonic, 3);
}

}  // namespace fretval::fem
