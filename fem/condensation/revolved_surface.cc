#include "fem/condensation/revolved_surface.h"

#include <array>
#include <cmath>
#include <map>

#include "fem/condensation/vtu_file.h"
#include "fem/operators/harmonic_space_parts.h"
#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

/// `u_r = r0 + r1 cos(theta), u_theta = t1 sin(theta), u_z = z0 + z1 cos(theta)`, z down.
struct NodeAmplitudes {
  double r0 = 0, z0 = 0, r1 = 0, t1 = 0, z1 = 0;
};

/// Calls see(radius, values of the components) for the corners of the rings, those between two of them twice.
template <class See>
void for_each_corner(const HarmonicState& state, const See& see) {
  const auto contact = static_cast<dealii::types::boundary_id>(BoundaryPart::contact);
  for (const auto& cell : state.space.parts().dofs.active_cell_iterators())
    for (const unsigned face : cell->face_indices()) {
      if (!cell->face(face)->at_boundary() || cell->face(face)->boundary_id() != contact) continue;
      for (unsigned v = 0; v < 2; ++v) {
        std::array<double, 3> x{};
        for (unsigned c = 0; c < n_displacements(state.space.order()); ++c)
          x[c] = state.moved[static_cast<Eigen::Index>(cell->face(face)->vertex_dof_index(v, c))];
        see(cell->face(face)->vertex(v)[0], x);
      }
    }
}

/// Displacements by radius. Components of the normal harmonic count inwards and down, of the tangential one outwards
/// and up.
std::map<double, NodeAmplitudes> nodes_of(const BodyState& state) {
  std::map<double, NodeAmplitudes> nodes;
  for_each_corner(state.normal, [&](double radius, const std::array<double, 3>& x) {
    nodes[radius].r0 = -x[0];
    nodes[radius].z0 = x[1];
  });
  if (!state.tangential) return nodes;
  for_each_corner(*state.tangential, [&](double radius, const std::array<double, 3>& x) {
    nodes[radius].r1 = x[0] + x[1];
    nodes[radius].t1 = x[1] - x[0];
    nodes[radius].z1 = -x[2];
  });
  return nodes;
}

std::array<double, 3> displacement_at(const NodeAmplitudes& node, double c, double s) {
  const double u_r = node.r0 + node.r1 * c, u_theta = node.t1 * s;
  return {u_r * c - u_theta * s, u_r * s + u_theta * c, node.z0 + node.z1 * c};
}

const std::vector<Field>& surface_fields() {
  static const std::vector<Field> fields{{"displacement (m)", 3},
                                         {"traction (Pa)", 3},
                                         {"contact pressure (Pa)", 1},
                                         {"shear traction (Pa)", 1},
                                         {"zone (0 open, 1 sticks, 2 slips forward, 3 backward)", 1}};
  return fields;
}

}  // namespace

void write_revolved_surface(const BodyState& state, const RingTractions& rings, const FieldUnits& units,
                            unsigned n_sectors, std::ostream& stream) {
  constexpr unsigned n_components = 3 + 3 + 1 + 1 + 1;
  const auto nodes = nodes_of(state);
  std::vector<Patch> patches;
  auto inner = nodes.begin();
  for (Eigen::Index ring = 0; ring < rings.pressure.size(); ++ring, ++inner) {
    const double p = units.pressure * rings.pressure[ring], tau = units.pressure * rings.traction[ring];
    const auto zone = static_cast<double>(rings.zones[static_cast<std::size_t>(ring)]);
    for (unsigned sector = 0; sector < n_sectors; ++sector) {
      Patch patch = new_patch(1, n_components);
      patch.patch_index = static_cast<unsigned>(patches.size());
      for (unsigned v = 0; v < 4; ++v) {
        const double angle = 2 * pi / n_sectors * ((sector + v / 2) % n_sectors);
        const double c = std::cos(angle), s = std::sin(angle);
        const auto& [radius, node] = *(v % 2 == 0 ? inner : std::next(inner));
        patch.vertices[v] = {units.length * radius * c, units.length * radius * s, 0};
        const auto u = displacement_at(node, c, s);
        unsigned k = 0;
        for (const double value :
             {units.depth * u[0], units.depth * u[1], units.depth * u[2], tau, 0.0, p, p, tau, zone})
          patch.data(k++, v) = static_cast<float>(value);
      }
      patches.push_back(std::move(patch));
    }
  }
  write_vtu(patches, surface_fields(), stream);
}

}  // namespace fretval::fem
