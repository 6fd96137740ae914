#include "fem/operators/harmonic_space.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "fem/operators/harmonic_space_parts.h"
#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

unsigned stable_degree(unsigned degree) {
  if (degree < 2)
    throw std::invalid_argument("displacement degree " + std::to_string(degree) + " is too low: 2 or more is stable");
  return degree;
}

bool has_part(const GridData& grid, BoundaryPart part) {
  return std::any_of(grid.boundary.begin(), grid.boundary.end(),
                     [part](const auto& edge) { return edge.part == part; });
}

/// A flat base on which the body slides holds it along the axis alone; orders of n >= 2 need nothing that holds them.
bool is_held(const GridData& grid, const FourierOrder& order) {
  if (order.n >= 2 || has_part(grid, BoundaryPart::far) || has_part(grid, BoundaryPart::bonded)) return true;
  return order == axisymmetric && has_part(grid, BoundaryPart::sliding);
}

void require_usable(const GridData& grid, const FourierOrder& order) {
  if (!has_part(grid, BoundaryPart::contact))
    throw std::invalid_argument("the grid has no edge in the boundary part 'contact'");
  if (!is_held(grid, order))
    throw std::invalid_argument(
        "nothing holds the body of the grid: it has no edge in the boundary parts 'far' and "
        "'bonded', and 'sliding' holds it along the axis alone");
  const auto& [poisson_ratio, moduli] = grid.elasticity;
  if (!(poisson_ratio >= 0 && poisson_ratio <= 0.5))
    throw std::invalid_argument("Poisson's ratio is " + std::to_string(poisson_ratio) + ", must be from 0 to 0.5");
  if (!moduli.empty() && moduli.size() != grid.cells.size())
    throw std::invalid_argument("moduli of " + std::to_string(moduli.size()) + " cells, must be of all " +
                                std::to_string(grid.cells.size()));
  if (!std::all_of(moduli.begin(), moduli.end(), [](double modulus) { return modulus > 0 && std::isfinite(modulus); }))
    throw std::invalid_argument("the shear modulus of a cell is not positive");
}

void build_triangulation(const GridData& grid, dealii::Triangulation<2>& triangulation) {
  std::vector<dealii::Point<2>> points;
  for (const auto& p : grid.points) points.emplace_back(p[0], p[1]);
  std::vector<dealii::CellData<2>> cells(grid.cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto& c = grid.cells[i];
    cells[i].vertices = {c[0], c[1], c[3], c[2]};  // deal.II numbers corners lexicographically
  }
  dealii::SubCellData boundary;
  for (const auto& edge : grid.boundary) {
    dealii::CellData<1> line;
    line.vertices = {edge.points[0], edge.points[1]};
    line.boundary_id = static_cast<dealii::types::boundary_id>(edge.part);
    boundary.boundary_lines.push_back(line);
  }
  triangulation.create_triangulation(points, cells, boundary);
}

/// The number of the others is returned.
unsigned number_interiors_last(HarmonicSpaceParts& parts) {
  std::vector<bool> interior(parts.dofs.n_dofs(), false);
  std::vector<dealii::types::global_dof_index> dofs(parts.element.n_dofs_per_cell());
  for (const auto& cell : parts.dofs.active_cell_iterators()) {
    cell->get_dof_indices(dofs);
    for (unsigned i = 0; i < dofs.size(); ++i) interior[dofs[i]] = i >= parts.element.get_first_quad_index();
  }
  dealii::DoFRenumbering::sort_selected_dofs_back(parts.dofs, interior);
  return static_cast<unsigned>(std::count(interior.begin(), interior.end(), false));
}

bool is_part(const dealii::TriaAccessor<1, 2, 2>& face, BoundaryPart part) {
  return face.at_boundary() && face.boundary_id() == static_cast<dealii::types::boundary_id>(part);
}

/// Components that vanish on the axis.
std::vector<bool> zero_on_axis(const FourierOrder& order, unsigned n_components) {
  std::vector<bool> zero(n_components, order.n > 0);
  zero[0] = order.n != 1;
  return zero;
}

void constrain(HarmonicSpaceParts& parts, BoundaryPart part, const std::vector<bool>& zero) {
  dealii::DoFTools::make_zero_boundary_constraints(parts.dofs, static_cast<dealii::types::boundary_id>(part),
                                                   parts.constraints, dealii::ComponentMask(zero));
}

/// Holds all displacements of a base that is bonded, and the vertical one of a base on which the body slides.
void constrain_base(HarmonicSpaceParts& parts, const FourierOrder& order) {
  std::vector<bool> all(parts.element.n_components(), true), vertical(parts.element.n_components(), false);
  if (has_pressure(order)) all.back() = false;
  constrain(parts, BoundaryPart::bonded, all);
  if (order.is_torsion()) return;
  vertical[vertical_component(order)] = true;
  constrain(parts, BoundaryPart::sliding, vertical);
}

// A rotation about y leaves u.n = 0 on the far hemisphere, so the Robin term does not resist it. W vanishes at the
// surface in Cerruti's solution for an incompressible body, which makes the far end of the surface the right place to
// pin it.
void pin_rotation(HarmonicSpaceParts& parts) {
  double farthest = -1;
  dealii::types::global_dof_index pinned = dealii::numbers::invalid_dof_index;
  const unsigned w = vertical_component(lateral);
  for (const auto& cell : parts.dofs.active_cell_iterators())
    for (const unsigned v : cell->vertex_indices())
      if (cell->vertex(v)[1] == 0 && cell->vertex(v)[0] > farthest) {
        farthest = cell->vertex(v)[0];
        pinned = cell->vertex_dof_index(v, w);
      }
  if (farthest <= 0) throw std::invalid_argument("the grid has no surface z = 0");
  parts.constraints.add_line(pinned);
}

struct RingNode {
  unsigned dof;
  double force;  // nodal, of unit traction
  double radius;
};

struct Ring {
  std::vector<RingNode> nodes;
  double inner, outer;
};

Ring integrate_ring(const HarmonicSpaceParts& parts, unsigned component, double angle,
                    const dealii::DoFHandler<2>::active_cell_iterator& cell, unsigned face,
                    dealii::FEFaceValues<2>& values) {
  values.reinit(cell, face);
  std::vector<dealii::types::global_dof_index> dofs(parts.element.n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  const dealii::MappingQ1<2> mapping;
  Ring ring{};
  for (unsigned i = 0; i < dofs.size(); ++i) {
    if (parts.element.system_to_component_index(i).first != component) continue;
    if (!parts.element.has_support_on_face(i, face) || parts.constraints.is_constrained(dofs[i])) continue;
    double force = 0;
    for (const unsigned q : values.quadrature_point_indices())
      force += angle * values.quadrature_point(q)[0] * values.shape_value(i, q) * values.JxW(q);
    const auto support = mapping.transform_unit_to_real_cell(cell, parts.element.unit_support_point(i));
    ring.nodes.push_back({static_cast<unsigned>(dofs[i]), force, support[0]});
  }
  const double r0 = cell->face(face)->vertex(0)[0], r1 = cell->face(face)->vertex(1)[0];
  ring.inner = std::min(r0, r1);
  ring.outer = std::max(r0, r1);
  return ring;
}

// The nodes of the line, each once: a node between two rings belongs to both.
std::vector<unsigned> sort_by_radius(const std::vector<Ring>& rings) {
  std::vector<RingNode> nodes;
  for (const auto& ring : rings) nodes.insert(nodes.end(), ring.nodes.begin(), ring.nodes.end());
  std::sort(nodes.begin(), nodes.end(), [](const RingNode& a, const RingNode& b) { return a.radius < b.radius; });
  std::vector<unsigned> dofs;
  for (const auto& node : nodes) dofs.push_back(node.dof);
  dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
  return dofs;
}

/// angle: integral of the square of the component's angular part, of s and m with that of their partner.
std::vector<Ring> rings_of(const HarmonicSpaceParts& parts, unsigned component, double angle) {
  dealii::FEFaceValues<2> values(parts.element, dealii::QGauss<1>(parts.element.degree + 1),
                                 dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points);
  std::vector<Ring> rings;
  for (const auto& cell : parts.dofs.active_cell_iterators())
    for (const unsigned face : cell->face_indices())
      if (is_part(*cell->face(face), BoundaryPart::contact))
        rings.push_back(integrate_ring(parts, component, angle, cell, face, values));
  std::sort(rings.begin(), rings.end(), [](const Ring& a, const Ring& b) { return a.inner < b.inner; });
  return rings;
}

/// The radii and areas of a contact line; its dofs and loads stay empty.
ContactLine line_of(const std::vector<Ring>& rings) {
  ContactLine line;
  line.areas.resize(static_cast<Eigen::Index>(rings.size()));
  line.radii.push_back(rings.front().inner);
  for (Eigen::Index e = 0; e < line.areas.size(); ++e) {
    const Ring& ring = rings[static_cast<std::size_t>(e)];
    line.radii.push_back(ring.outer);
    line.areas[e] = pi * (ring.outer - ring.inner) * (ring.outer + ring.inner);
  }
  return line;
}

/// Appends the dofs of one component, and its loads behind those that are there.
void append(const std::vector<Ring>& rings, ContactLine& line) {
  const auto dofs = sort_by_radius(rings);
  const auto n_dofs = line.loads.rows(), n_loads = line.loads.cols();
  std::map<unsigned, Eigen::Index> position;
  for (std::size_t i = 0; i < dofs.size(); ++i) position[dofs[i]] = n_dofs + static_cast<Eigen::Index>(i);
  line.dofs.insert(line.dofs.end(), dofs.begin(), dofs.end());
  line.loads.conservativeResizeLike(
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(line.dofs.size()), n_loads + line.n_elements()));
  for (Eigen::Index e = 0; e < line.n_elements(); ++e)
    for (const auto& node : rings[static_cast<std::size_t>(e)].nodes)
      line.loads(position[node.dof], n_loads + e) = node.force;
}

}  // namespace

HarmonicSpace::HarmonicSpace(const GridData& grid, const FourierOrder& order, unsigned degree)
    : parts_(std::make_unique<HarmonicSpaceParts>(order, stable_degree(degree))),
      order_(order),
      elasticity_(grid.elasticity) {
  require_usable(grid, order);
  build_triangulation(grid, parts_->triangulation);
  parts_->dofs.distribute_dofs(parts_->element);
  n_skeleton_dofs_ = number_interiors_last(*parts_);
  constrain(*parts_, BoundaryPart::axis, zero_on_axis(order, parts_->element.n_components()));
  constrain_base(*parts_, order);
  if (order.n == 1 && !has_part(grid, BoundaryPart::bonded)) pin_rotation(*parts_);
  parts_->constraints.close();
  contact_line_ = contact_line({ring_component(order)});
}

ContactLine HarmonicSpace::contact_line(const std::vector<unsigned>& components) const {
  ContactLine line;
  for (const unsigned component : components) {
    const bool halves = order_.n > 0 && component == vertical_component(order_);
    const auto rings = rings_of(*parts_, component, halves ? pi : 2 * pi);
    if (line.radii.empty()) line = line_of(rings);
    append(rings, line);
  }
  return line;
}

HarmonicSpace::~HarmonicSpace() = default;
HarmonicSpace::HarmonicSpace(HarmonicSpace&&) noexcept = default;

unsigned HarmonicSpace::n_dofs() const {
  return parts_->dofs.n_dofs();
}

}  // namespace fretval::fem
