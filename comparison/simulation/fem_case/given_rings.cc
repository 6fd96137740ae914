#include "comparison/simulation/fem_case/given_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/case_file/case_sections.h"
#include "meshes/mesh.h"

namespace fretval {
namespace {

constexpr double reserve = 1.05;  // of the contact line, so that some rings do not touch

void require_rings(const Case& input, const GivenBody& given, double length) {
  const double end = given.scale * length;
  if (end < reserve * length)
    throw InputError(
        fmt::format("{}: Body / Mesh = {}: the physical curve \"contact\" ends at r = {:.4g} m, and the contact radius "
                    "is some {:.4g} m; expected a contact line of at least {:.4g} m, or a smaller indentation",
                    input.file, input.body.mesh, end, length, reserve * length));
  const unsigned usual = resolution_for(input.tolerance).elements_per_radius;
  if (given.rings_per_radius < fewest_given_rings)
    throw InputError(fmt::format(
        "{}: Body / Mesh = {}: the physical curve \"contact\" has {} edges within the contact radius of some {:.4g} m; "
        "expected at least {}; a tolerance of {:g} usually takes {}",
        input.file, input.body.mesh, given.rings_per_radius, length, fewest_given_rings, input.tolerance,
        std::max(usual, fewest_given_rings)));
}

/// With a node in the middle of each edge, as the cells have that are split into four.
std::vector<double> refined(const std::vector<double>& radii) {
  std::vector<double> fine{radii.front()};
  for (std::size_t i = 1; i < radii.size(); ++i) {
    fine.push_back((radii[i - 1] + radii[i]) / 2);
    fine.push_back(radii[i]);
  }
  return fine;
}

/// Every so many of them, from the offset on, and both ends.
std::vector<double> every(std::size_t n_together, std::size_t offset, const std::vector<double>& radii) {
  std::vector<double> some{radii.front()};
  for (std::size_t i = offset == 0 ? n_together : offset; i + 1 < radii.size(); i += n_together)
    some.push_back(radii[i]);
  some.push_back(radii.back());
  return some;
}

}  // namespace

GivenBody given_body(const Case& input, double length) {
  const auto& body = input.body;
  GivenBody given{{body.mesh, body.mesh_hash, moduli_of_materials(body)}, meshes::contact_radii(*body.grid), 0, 0};
  given.scale = given.radii.back() * body.mesh_unit / length;
  constexpr double roundoff = 1e-9;
  for (std::size_t i = 1; i < given.radii.size(); ++i)
    if (given.radii[i] * body.mesh_unit <= (1 + roundoff) * length) ++given.rings_per_radius;
  require_rings(input, given, length);
  return given;
}

void take_given(const GivenBody& given, double thickness, const Resolution& resolution, BodyDescription& body) {
  const int finer = static_cast<int>(
      std::lround(std::log2(static_cast<double>(resolution.elements_per_radius) / given.rings_per_radius)));
  const auto n_refinements = std::max(finer, 0) + static_cast<int>(resolution.mesh_refinements.value_or(0));
  const std::size_t n_together = std::size_t{1} << (n_refinements - finer);
  const auto offset =
      static_cast<std::size_t>(std::lround((resolution.edge_before_node - usual_edge_before_node) * n_together)) %
      n_together;
  auto radii = given.radii;
  for (int k = 0; k < n_refinements; ++k) radii = refined(radii);
  const double end = radii.back();
  for (double& radius : radii) radius /= end;
  body.given = given.mesh;
  body.given.n_refinements = static_cast<unsigned>(n_refinements);
  body.contact_nodes = n_together == 1 ? radii : every(n_together, offset, radii);
  if (n_together > 1) body.given.radii = std::move(radii);
  body.scale = given.scale;
  body.thickness = thickness / given.scale;
}

}  // namespace fretval
