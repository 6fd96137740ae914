#include "comparison/simulation/full_case.h"

#include <algorithm>

#include "comparison/simulation/bodies/surface_store.h"
#include "comparison/simulation/fe_cycle.h"
#include "comparison/simulation/normal_part.h"
#include "comparison/support/stopwatch.h"
#include "fem/motion/running_minimum.h"
#include "fem/ring_contact/static_contact.h"
#include "fem/ring_contact/stick_zone/cycle_response.h"
#include "fem/support/constants.h"

namespace fretval {
namespace {

/// Motion along x leaves the contact its mirrors; coupled, front and back differ.
fem::Mirrors mirrors_of(const FemCase& fem) {
  if (fem.motion.moves_across()) return fem::Mirrors::none;
  return fem.full.coupled ? fem::Mirrors::x : fem::Mirrors::x_and_y;
}

/// Micro-slip between the stick radii dies out by its own time, not by that of the body, long after the zones, the
/// forces and the energies are what they are in the end.
fem::SurfaceControl control_of_surface(const FemCase& fem) {
  const bool second = fem.full.second_algorithm;
  if (fem.motion.is_single_pass()) return {1, 1, 0, second};
  constexpr int at_least = 2, at_most = 40;
  constexpr double of_body = 30;
  const int ramp = fem.motion.cycles_of_ramp();
  return {ramp + at_least, ramp + at_most, of_body * fem.resolution.periodicity, second};
}

PlaneZone disc(double radius, double uncertainty, Eigen::Index n_angles) {
  return {fem::pi * radius * radius,
          radius,
          radius,
          radius,
          uncertainty,
          uncertainty,
          std::vector<double>(n_angles, radius)};
}

/// A zone with its edge moved outwards.
PlaneZone moved_out(PlaneZone zone, double by) {
  zone.radius += by;
  zone.along += by;
  zone.across += by;
  zone.area = fem::pi * zone.radius * zone.radius;
  for (double& edge : zone.edges) edge += by;
  return zone;
}

/// Pressures of the ring contact in a step, counted from 0: on the way to its periodic state, and in that. Its solver
/// holds them positive to its slack.
Eigen::VectorXd pressure_in(const NormalRecord& record, long step) {
  const auto next = static_cast<std::size_t>(step) + 1;
  if (next < record.pressures.size()) return record.pressures[next].cwiseMax(0);
  return record.history.pressure_on_friction().col(record.history.column(step + 1)).cwiseMax(0);
}

fem::SurfaceHistory history_beside(const NormalRecord& record, const fem::SurfaceCompliance& surface,
                                   const fem::AngularGrid& grid, const fem::RingProblems& rings, const FemCase& fem) {
  const fem::SurfaceOperator op(surface, grid, fem::SurfaceField::tangential);
  const auto motion = fem::lateral_motion(fem.motion);
  return vector_friction_history(
      fem::VectorFriction(op, fem.relaxation, fem.friction_coefficient, motion,
                          fem::StepTimes(fem.motion, fem.steps_per_cycle())),
      [&](long step) { return pressure_in(record, step); }, rings, control_of_surface(fem));
}

fem::SurfaceHistory coupled_history(const Eigen::VectorXd& profile, const fem::SurfaceCompliance& surface,
                                    const fem::AngularGrid& grid, const fem::RingProblems& rings, const FemCase& fem) {
  const auto operators = fem::coupled_operators(surface, grid);
  const auto motion = fem::indenter_motion(fem.motion);
  return coupled_contact_history(
      fem::CoupledContact(operators, fem.relaxation, fem.friction_coefficient, profile.replicate(1, grid.n_kept()),
                          motion, fem::StepTimes(fem.motion, fem.steps_per_cycle())),
      rings, control_of_surface(fem));
}

/// Adds the changes by coupling, against the ring contact, to the largest normal force, the edge of the contact and the
/// largest indentation.
void add_coupling(const fem::NormalHistory& normal, const fem::RingProblems& rings, const FemCase& fem,
                  FeAnswer& answer) {
  auto& surface = std::get<SurfaceAnswer>(answer.of_kind);
  const auto& history = surface.history;
  const Eigen::VectorXd of_rings = normal.pressure.transpose() * rings.normal.compliance.areas;
  const double coupled = fem::largest_of_period(history.normal_force, history.pieces),
               alone = fem::largest_of_period(of_rings, normal.pieces);
  if (!fem.motion.normal_force) answer.normal_force_max += (coupled - alone) * fem.units.force();
  const double length = fem.units.length;
  const auto region_of_rings = fem::region_of(rings.normal, fem::angular_grid(1), normal.pressure.rowwise().maxCoeff());
  surface.contact = moved_out(zone_of(history.contact, length),
                              answer.contact_radius_max.value_or(0) - region_of_rings.radius * length);
  answer.contact_radius_max = surface.contact.radius;
  answer.axis_pressure_max.reset();  // of the ring contact
  if (!answer.indentation_max) return;
  const double deep = fem::largest_of_period(history.depth, history.pieces),
               deep_alone = fem::largest_of_period(normal.indentation, normal.pieces);
  *answer.indentation_max += (deep - deep_alone) * fem.units.depth;
}

/// Half of the range of u_x, for prescribed forces.
double amplitude_of(const fem::SurfaceHistory& history) {
  const Eigen::VectorXd along = history.displacement.row(0);
  return (fem::largest_of_period(along, history.pieces) + fem::largest_of_period(-along, history.pieces)) / 2;
}

std::optional<double> radius_of(const PlaneZone& zone) {
  return zone.radius > 0 ? std::optional(zone.radius) : std::nullopt;
}

/// A zone whose edge is moved by the error of reading it on these rings, as far as the ring contact knows that edge
/// better.
PlaneZone corrected(const PlaneZone& zone, const fem::ContactRegion& of_rings, const std::optional<double>& better,
                    double better_uncertainty, double length) {
  if (zone.radius == 0 || of_rings.radius == 0 || !better) return zone;
  auto moved = moved_out(zone, *better - of_rings.radius * length);
  moved.uncertainty = moved.edge_uncertainty = better_uncertainty;
  return moved;
}

/// Length of the path of the indenter along the surface, in the cycle or in the pass.
double way_of(const fem::SurfaceHistory& history, bool is_pass) {
  const auto& at = history.displacement;
  const Eigen::Index n = at.cols();
  double way = is_pass ? at.col(0).norm() : (at.col(0) - at.col(n - 1)).norm();
  for (Eigen::Index k = 1; k < n; ++k) way += (at.col(k) - at.col(k - 1)).norm();
  return way;
}

/// Reads all values from the history, before corrections.
void read_surface(const fem::NormalHistory& normal, const FemCase& fem, FeAnswer& answer) {
  auto& surface = std::get<SurfaceAnswer>(answer.of_kind);
  const auto& history = surface.history;
  const double length = fem.units.length;
  surface.never_slipped = zone_of(history.never_slipped, length);
  surface.sticks_in_a_cycle = zone_of(history.sticks_in_a_cycle, length);
  surface.sticks_at_the_end = zone_of(history.sticks_at_the_end, length);
  surface.transverse_force_max =
      fem::largest_magnitude_of_period(history.forces.row(1), history.pieces) * fem.units.force();
  surface.torque_max = history.forces.row(2).cwiseAbs().maxCoeff() * fem.units.force() * length;
  const double pressing = fem.full.coupled ? history.normal_work : fem::normal_work(fem.motion, normal);
  answer.cycle = cycle_of(fem, history, pressing);
  if (fem.motion.tangential_force && fem.has_period())
    answer.tangential_amplitude = amplitude_of(history) * fem.units.depth;
}

/// Corrects the answer for a motion along x by that of the ring contact. of_rings: history with the same traction at
/// all angles.
void correct_by_rings(const FeAnswer& ring, const fem::SurfaceHistory& of_rings, const FemCase& fem, FeAnswer& answer) {
  auto& surface = std::get<SurfaceAnswer>(answer.of_kind);
  const double length = fem.units.length;
  surface.never_slipped = corrected(surface.never_slipped, of_rings.never_slipped, ring.stick_radius_first_slip,
                                    ring.first_slip_uncertainty, length);
  surface.sticks_in_a_cycle = corrected(surface.sticks_in_a_cycle, of_rings.sticks_in_a_cycle,
                                        ring.stick_radius_shakedown, ring.shakedown_uncertainty, length);
  if (ring.tangential_amplitude)
    answer.tangential_amplitude =
        *ring.tangential_amplitude + (amplitude_of(surface.history) - amplitude_of(of_rings)) * fem.units.depth;
  if (!ring.cycle) return;
  auto cycle = *ring.cycle;
  const double pressing = fem::normal_work(fem.motion, ring.normal);
  add_change(cycle_of(fem, of_rings, pressing), *answer.cycle, cycle);
  answer.cycle = cycle;
}

/// What friction would take if the indenter slid all the time.
void add_sliding(const FemCase& fem, const std::optional<FeAnswer>& ring, FeAnswer& answer) {
  auto& cycle = *answer.cycle;
  cycle.sliding_force = fem.friction_coefficient * answer.normal_force_max;
  if (fem.motion.tangential_force && ring && ring->cycle) {
    cycle.sliding_work = ring->cycle->sliding_work;
    return;
  }
  const auto& history = std::get<SurfaceAnswer>(answer.of_kind).history;
  const double way =
      fem.motion.tangential_force ? way_of(history, fem.motion.is_single_pass()) : fem::tangential_path(fem.motion);
  cycle.sliding_work = cycle.sliding_force * way * fem.units.depth;
}

void read_stick_radii(FeAnswer& answer) {
  const auto& surface = std::get<SurfaceAnswer>(answer.of_kind);
  answer.stick_radius_first_slip = radius_of(surface.never_slipped);
  answer.first_slip_uncertainty = surface.never_slipped.uncertainty;
  answer.stick_radius_shakedown = radius_of(surface.sticks_in_a_cycle);
  answer.shakedown_uncertainty = surface.sticks_in_a_cycle.uncertainty;
}

void go_halfway(double other, double& value) {
  value = (value + other) / 2;
}

void go_halfway(const std::optional<double>& other, std::optional<double>& value) {
  if (other && value) go_halfway(*other, *value);
}

/// Moves the edge of a zone halfway to that of another one, where there are both.
void go_halfway(const PlaneZone& other, PlaneZone& zone) {
  if (zone.radius == 0 || other.radius == 0) return;
  for (const auto part : {&PlaneZone::radius, &PlaneZone::along, &PlaneZone::across})
    go_halfway(other.*part, zone.*part);
  for (std::size_t j = 0; j < zone.edges.size(); ++j) go_halfway(other.edges[j], zone.edges[j]);
  zone.area = fem::pi * zone.radius * zone.radius;
  zone.uncertainty = std::max(zone.uncertainty, other.uncertainty);
  zone.edge_uncertainty = std::max(zone.edge_uncertainty, other.edge_uncertainty);
}

}  // namespace

PlaneZone zone_of(const fem::ContactRegion& region, double length) {
  PlaneZone zone{region.area * length * length,
                 region.radius * length,
                 region.along * length,
                 region.across * length,
                 region.uncertainty * length,
                 region.edge_uncertainty * length,
                 {}};
  for (const double edge : region.edges) zone.edges.push_back(edge * length);
  return zone;
}

std::optional<Resolution> half_a_ring_away(const FemCase& fem, const FeAnswer& answer) {
  const auto& never = answer.stick_radius_first_slip;
  const double edge = answer.stick_radius_shakedown.value_or(never.value_or(0)), other = never.value_or(edge);
  if (!fem.has_zones_of_points() || fem.resolution.mesh_refinements || edge == 0) return std::nullopt;
  auto elsewhere = fem.resolution;
  elsewhere.edge_before_node += 0.5 * answer.contact_radius_max.value_or(edge) / ((edge + other) / 2);
  return elsewhere;
}

void average(const FeAnswer& other, FeAnswer& answer) {
  const auto* elsewhere = other.as<SurfaceAnswer>();
  auto* surface = std::get_if<SurfaceAnswer>(&answer.of_kind);
  if (!elsewhere || !surface) return;
  for (const auto zone : {&SurfaceAnswer::never_slipped, &SurfaceAnswer::sticks_in_a_cycle, &SurfaceAnswer::contact})
    go_halfway(elsewhere->*zone, surface->*zone);
  go_halfway(elsewhere->transverse_force_max, surface->transverse_force_max);
  go_halfway(elsewhere->torque_max, surface->torque_max);
  go_halfway(other.normal_force_max, answer.normal_force_max);
  go_halfway(other.indentation_max, answer.indentation_max);
  go_halfway(other.tangential_amplitude, answer.tangential_amplitude);
  if (other.cycle && answer.cycle) go_halfway(*other.cycle, *answer.cycle);
  if (answer.contact_radius_max) answer.contact_radius_max = surface->contact.radius;
  read_stick_radii(answer);
  answer.n_cycles += other.n_cycles;
  answer.n_steps += other.n_steps;
  answer.seconds.normal += other.seconds.normal;
  answer.seconds.friction += other.seconds.friction;
}

FeAnswer compute_full_contact(const ContactProblems& problems, const FemCase& fem, const std::optional<FeAnswer>& ring,
                              BodyStore& bodies) {
  const auto normal = normal_part(problems, fem, bodies.normals);
  const auto& record = *normal.record;
  Stopwatch watch;
  const auto grid = fem::angular_grid(fem.resolution.n_angles, mirrors_of(fem));
  const auto compliance = find_or_make_surface(fem.body, grid.highest_order(), bodies);
  const fem::RingProblems rings{problems.normal, *problems.tangential};
  FeAnswer answer;
  read_normal_response(problems, fem, normal.contact_radius, record.history, answer);
  auto& surface = answer.of_kind.emplace<SurfaceAnswer>();
  surface.grid = grid;
  surface.history = fem.full.coupled ? coupled_history(normal.profile, compliance, grid, rings, fem)
                                     : history_beside(record, compliance, grid, rings, fem);
  read_surface(record.history, fem, answer);
  if (ring) correct_by_rings(*ring, history_beside(record, compliance, fem::angular_grid(1), rings, fem), fem, answer);
  if (fem.full.coupled)
    add_coupling(record.history, rings, fem, answer);
  else
    surface.contact = disc(answer.contact_radius_max.value_or(0), answer.contact_radius_uncertainty, grid.n_kept());
  add_sliding(fem, ring, answer);
  read_stick_radii(answer);
  answer.n_cycles = surface.history.n_cycles + record.history.n_cycles;
  answer.n_steps = static_cast<long>(surface.history.n_cycles) * fem.steps_per_cycle();
  answer.normal = record.history;
  answer.seconds = {record.seconds, watch.lap()};
  return answer;
}

}  // namespace fretval
