#include "comparison/simulation/surface_wear.h"

#include <memory>
#include <utility>

#include "comparison/simulation/bodies/surface_store.h"
#include "comparison/simulation/wear_run.h"
#include "comparison/support/stopwatch.h"
#include "fem/full_contact/contact_region.h"
#include "fem/full_contact/fields.h"
#include "fem/wear/rubbing_surface.h"

namespace fretval {

using Eigen::Index;
using Eigen::VectorXd;

Eigen::MatrixXd SurfaceWear::field(const VectorXd& points) const {
  return fem::as_field(points, static_cast<Index>(radii.size()) - 1);
}

Resolution resolution_for_surface_wear(const Case& input, const Resolution& of_the_case) {
  constexpr unsigned rings = 24, degree = 5, angles = 8;
  constexpr int steps = 36;
  constexpr double edge_ring = 1e-2, jump = 0.04;
  Resolution r = of_the_case;
  r.elements_per_radius = input.rings_per_radius.value_or(rings);
  r.degree = degree;
  r.n_angles = angles;
  r.steps_per_cycle = input.steps_per_cycle.value_or(steps);
  r.worn_edge_ring = edge_ring;
  r.wear_jump = jump;
  r.focus.reset();
  return r;
}

WornEdge edge_of_surface_wear(const FemCase& fem, const Case::WearKinetics& wear, double unworn_stick_radius,
                              const Resolution& resolution, BodyStore& bodies,
                              const std::filesystem::path& checkpoints) {
  const auto coarse = with_steps(with_rings(resolution, 0.5), 0.5);
  return settled_edge(fem, unworn_stick_radius, [&](const WornEdge& edge) {
    const auto nothing = [](const fem::WearCourse&) {};
    const auto made = simulate_surface_wear(fem, wear, edge, coarse, bodies, checkpoints, nothing);
    return WearPass{made.course.end, made.course.last.largest_indentation, made.sticks.radius, made.sticks.uncertainty};
  });
}

SurfaceWear simulate_surface_wear(const FemCase& fem_case, const Case::WearKinetics& wear, const WornEdge& edge,
                                  const Resolution& resolution, BodyStore& bodies,
                                  const std::filesystem::path& checkpoints,
                                  const std::function<void(const fem::WearCourse&)>& after_jump) {
  Stopwatch watch;
  FemCase fem = fem_case;
  fem.worn_edge = edge;
  fem = at_resolution(std::move(fem), resolution);
  SurfaceWear simulation;
  simulation.grid =
      fem::angular_grid(resolution.n_angles, fem.motion.moves_across() ? fem::Mirrors::none : fem::Mirrors::x);
  const auto& grid = simulation.grid;
  const auto surface = find_or_make_surface(fem.body, grid.highest_order(), bodies);
  simulation.radii = surface.radii;
  const auto of_rings = profile_before_wear(fem, fem::ring_compliance(surface, fem::axisymmetric));
  simulation.unworn = of_rings.unworn;
  const auto operators = fem::coupled_operators(surface, grid, fem.full.coupled);
  const auto of_indenter = fem::indenter_motion(fem.motion);
  const fem::WornProfile profile{of_rings.unworn.replicate(grid.n_kept(), 1),
                                 of_rings.worn.replicate(grid.n_kept(), 1)};
  auto contact = std::make_unique<fem::RubbingSurface>(operators, fem.relaxation, fem.motion, of_indenter,
                                                       fem.steps_per_cycle(), profile, fem.friction_coefficient);
  simulation.course = worn_to_its_end(std::move(contact), profile, fem, wear, checkpoints, after_jump);
  const auto& last = simulation.course.last;
  const Eigen::MatrixXd pressure = simulation.field(last.largest_pressure), path = simulation.field(last.path);
  const Eigen::MatrixXd stuck = (pressure.array() > 0 && path.array() == 0).cast<double>();
  simulation.sticks = fem::region_to_a_ring(surface.radii, grid, fem::rings_inside(stuck));
  simulation.seconds = watch.lap();
  return simulation;
}

}  // namespace fretval
