#include "comparison/simulation/fem_case/fem_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparison/data/path_table.h"
#include "comparison/scene/scene.h"
#include "comparison/simulation/fem_case/expected_contact.h"
#include "comparison/simulation/fem_case/near_cycle.h"
#include "comparison/simulation/fem_case/profile_in_units.h"
#include "fem/contact/half_space.h"
#include "fem/support/constants.h"
#include "meshes/grading.h"

namespace fretval {
namespace {

// The contact line reaches a little beyond the largest contact, so that the first ring that never touches is on it.
constexpr double contact_line_reserve = 1.12;

// Over the contact radius. Seven decades below the far cells a probe solve of the factor leaves 2e-10, ten decades
// 7e-8.
constexpr double finest_ring = 5e-8;

/// This reserve over a body whose contact radius is only expected (comparison/simulation/fem_case/expected_contact.h).
constexpr double reserve_on_solid = 1.25;

/// Rings of equal width beyond the contact. Fewer than three that do not touch do not tell where the contact ends.
constexpr double rings_beyond = 4;

/// How far the contact line of the coarsest rings reaches, over the contact radius.
constexpr double farthest_ring = 1.5;

/// Nodes of the rings along the contact line.
struct RingNodes {
  std::vector<double> nodes;
  double scale = 1;  ///< of the body
};

/// Rings of a width of which one ends at a radius, wider, so that the radius lies in one of them. A half-space has no
/// length: all places in a ring share a body.
RingNodes around_edge(std::vector<double> nodes, double radius, double ring, const Resolution& resolution) {
  const auto widened = [&](double rings_before_node) { return radius / (radius - rings_before_node * ring); };
  const double usual = widened(usual_edge_before_node);
  for (double& node : nodes) node *= usual;
  return {std::move(nodes), widened(resolution.edge_before_node) / usual};
}

RingNodes rings_of(const FemCase& fem) {
  const auto& resolution = fem.resolution;
  const double ring = 1.0 / resolution.elements_per_radius;
  // A worn profile ends its zone at a known radius, where stresses are singular. Rounded up to quarters of the contact
  // radius, so that profiles with the same c share their body.
  if (fem.worn_edge) {
    const double edge = fem.worn_edge->inner, end = std::ceil(4 * contact_line_reserve * fem.worn_edge->outer) / 4;
    if (edge == 0) return {meshes::uniform_nodes(end, static_cast<unsigned>(std::ceil(end / ring)))};
    return {meshes::graded_nodes({edge, edge, resolution.worn_edge_ring * edge}, end, ring, resolution.surface_growth)};
  }
  const double end = std::max(fem.solid ? reserve_on_solid : contact_line_reserve, 1 + rings_beyond * ring);
  if (resolution.focus) {
    const auto [inner, outer, wanted] = *resolution.focus;
    const double fine = std::max(wanted, finest_ring);
    const double width = std::min(fine, ring);
    return around_edge(meshes::graded_nodes({inner, outer, width}, std::max(end, outer + rings_beyond * fine), ring,
                                            resolution.surface_growth),
                       outer, width, resolution);
  }
  const auto n = static_cast<unsigned>(std::ceil(end * resolution.elements_per_radius / 2)) * 2;
  return around_edge(meshes::uniform_nodes(n * ring, n), 1, ring, resolution);
}

/// A layer goes on outwards; fields die out within some of its thicknesses, the slowest of them as exp(-0.74 r/H) on an
/// incompressible bonded one, there and back.
double far_radius_of(const FemCase& fem, double end_of_rings) {
  return fem.solid->radius ? *fem.solid->radius : end_of_rings + fem.resolution.far_radius * fem.solid->thickness;
}

/// Rings by which the smooth part of the body is found, which coarser rings than those of the case show: rings that its
/// error bars ask for as well, where halving leads to them. Empty: the layer is too thin for so few.
std::optional<RingNodes> coarse_rings_of(FemCase fem) {
  // With six to a thickness the force of discs was within 1e-6 of that on a body of the moved rings, with four 9e-6.
  constexpr double enough_per_thickness = 6;
  fem.resolution.focus.reset();
  fem.resolution.edge_before_node = usual_edge_before_node;
  auto rings = rings_of(fem);
  while (rings.nodes.size() > equal_rings_of_half_space + 1) {
    fem.resolution = with_rings(fem.resolution, 0.5);
    rings = rings_of(fem);
  }
  if (enough_per_thickness * rings.nodes[1] > fem.solid->thickness) return std::nullopt;
  return rings;
}

/// A body of finite thickness is as long as its unit, so that no scale is left to share: another place of the edge in
/// its ring moves the rings of the body at hand, but in the full contact, whose blocks of all orders have no half-space
/// beside them.
void take_solid(const FemCase& fem, RingNodes rings, BodyDescription& body) {
  body.thickness = fem.solid->thickness;
  body.slides_on_base = fem.solid->slides_on_base;
  body.moved = {};
  if (rings.scale != 1 && fem.kind == ContactKind::discs)
    if (const auto coarse = coarse_rings_of(fem))
      body.moved = {std::exchange(rings.scale, 1), coarse->nodes, far_radius_of(fem, coarse->nodes.back())};
  body.contact_nodes = std::move(rings.nodes);
  for (double& node : body.contact_nodes) node *= rings.scale;
  body.far_radius = far_radius_of(fem, body.contact_nodes.back());
}

/// The contact line, and what belongs to it, of the case's resolution.
void take_rings(FemCase& fem) {
  auto& body = fem.body;
  if (fem.given) {
    body.slides_on_base = fem.solid->slides_on_base;
    take_given(*fem.given, fem.solid->thickness, fem.resolution, body);
    return;
  }
  auto rings = rings_of(fem);
  if (fem.solid) return take_solid(fem, std::move(rings), body);
  body.contact_nodes = std::move(rings.nodes);
  body.scale = rings.scale;
}

constexpr double least_radius_of_cylinder = 1.6;  // with the rings beyond the contact

/// In the unit of length. Refuses what the rings do not fit on. Under a force the indentation is only known to be less
/// than over a half-space.
Solid solid_of(const Case& input, const Units& units) {
  const auto& body = input.body;
  const double length = units.length;
  if (!input.motion.normal_force && units.depth >= body.thickness)
    throw InputError(
        fmt::format("{}: Body / Thickness = {:g}: the indenter is pressed in by up to {:.3g} m; expected a "
                    "thicker body, or a smaller indentation",
                    input.file, body.thickness, units.depth));
  if (body.shape == Case::Body::Shape::cylinder && body.radius <= least_radius_of_cylinder * length)
    throw InputError(
        fmt::format("{}: Body / Radius = {:g}: the contact radius is some {:.3g} m; expected a cylinder of at "
                    "least {:.3g} m",
                    input.file, body.radius, length, least_radius_of_cylinder * length));
  Solid solid{body.thickness / length, {}, !body.is_bonded};
  if (body.shape == Case::Body::Shape::cylinder) solid.radius = body.radius / length;
  return solid;
}

/// Under a prescribed force the depth is that over a half-space, and so is the radius, which a layer hardly changes
/// then.
double expected_radius(const Case& input, const mdr::Profile& profile, double deepest) {
  return expected_contact_radius(profile, deepest, input.motion.normal_force ? Case::Body{} : input.body,
                                 input.elastomer.poisson_ratio);
}

/// Rings lie on the sphere, with those beyond the contact.
void require_room_on_sphere(const Case& input, const FemCase& fem) {
  const double a = fem.units.length,
               reach = (fem.given ? fem.given->scale : std::max(farthest_ring, fem.body.contact_nodes.back())) * a;
  if (input.indenter.shape != Case::Shape::sphere || reach <= input.indenter.radius) return;
  throw InputError(fmt::format(
      "{}: Indenter / Radius = {:g}: at the largest indentation, {:.3g} m, the contact radius is {:.3g} m, and rings "
      "that finite elements need beyond it would reach the radius of the sphere; expected a smaller indentation, or a "
      "radius of at least {:.3g} m; `fretval mdr` answers this case",
      input.file, input.indenter.radius, fem.units.depth, a, reach));
}

ContactKind kind_of(const Case& input, const mdr::Profile& unworn, bool is_worn) {
  if (input.contact.is_full()) return ContactKind::plane;
  if (is_worn) return ContactKind::worn;
  return mdr::falls_of_image(unworn).empty() ? ContactKind::discs : ContactKind::annuli;
}

/// Of a prescribed indentation.
double deepest_of(const Case::Motion& input, const mdr::HarmonicMotion& motion) {
  if (const auto& path = input.path) return *std::max_element(path->normal.begin(), path->normal.end());
  return mdr::maximum_indentation(motion);
}

/// The harmonics that move.
std::vector<fem::Oscillation> oscillations(const std::vector<mdr::Harmonic>& harmonics, const std::vector<int>& orders,
                                           double unit) {
  std::vector<fem::Oscillation> moving;
  for (std::size_t i = 0; i < harmonics.size(); ++i)
    if (orders[i] > 0)
      moving.push_back({harmonics[i].amplitude / unit, orders[i], harmonics[i].phase, harmonics[i].across});
  return moving;
}

double unit_of(bool force, const Units& units) {
  return force ? units.force() : units.depth;
}

/// Makes time dimensionless with a cycle, and what is prescribed too; of a relaxation that is still in s.
void take_cycle(const mdr::HarmonicMotion& motion, const mdr::CommonCycle& cycle, FemCase& fem) {
  const double frequency = mdr::angular_frequency(cycle.frequency),
               scale = frequency / std::exchange(fem.units.angular_frequency, frequency);
  fem.relaxation.viscosity *= scale;
  for (double& time : fem.relaxation.times) time *= scale;
  const double normal = unit_of(fem.motion.normal_force, fem.units),
               tangential = unit_of(fem.motion.tangential_force, fem.units);
  fem.motion.indentation = motion.indentation / normal;
  fem.motion.normal = oscillations(motion.normal, cycle.normal_orders, normal);
  fem.motion.tangential = oscillations(motion.tangential, cycle.tangential_orders, tangential);
  const bool moves_both_ways = !fem.motion.normal.empty() && !fem.motion.tangential.empty();
  fem.motion.locked = motion.phase_locked || !moves_both_ways;
}

Stiffening stiffening_of(const FemCase& fem) {
  return [relaxation = fem.relaxation, unit = fem.units.angular_frequency](double frequency) {
    return std::abs(fem::stiffening_at(relaxation, mdr::angular_frequency(frequency) / unit));
  };
}

/// Of a displacement, per_depth of which an element takes for each of its own, or of a force F in its place, which is
/// G(0) times stiffness times the radius that carries it times the displacement, whatever |G| is. Over the largest
/// indentation.
Demand demand_of(const FemCase& fem, bool force, double stiffness, double per_depth) {
  const double unit = force ? stiffness * fem.carrying_radius * fem.units.force() : fem.units.depth;
  return [=, stiffening = stiffening_of(fem)](double amplitude, double frequency) {
    return amplitude / unit / per_depth * (force ? 1 : stiffening(frequency));
  };
}

NearCycle near_cycle_of(const FemCase& fem, int n_creep_cycles) {
  return near_cycle(*fem.without_short_cycle, stiffening_of(fem),
                    {demand_of(fem, fem.motion.normal_force, fem::normal_punch(fem.body.poisson_ratio), 1),
                     demand_of(fem, fem.motion.tangential_force, fem::tangential_punch(fem.body.poisson_ratio),
                               tangential_per_depth(fem)),
                     fem.scales_tangential},
                    n_creep_cycles);
}

/// Scales tangential displacements of a near cycle, so that they lead to the forces of the motion that it stands for:
/// of its amplitudes, and of its phases within the direction.
void take_forces_of(const mdr::HarmonicMotion& motion, FemCase& fem) {
  auto oscillation = fem.motion.tangential.begin();
  for (const auto& harmonic : motion.tangential) {
    if (harmonic.amplitude == 0) continue;
    const double frequency = mdr::angular_frequency(harmonic.frequency) / fem.units.angular_frequency;
    const auto change =
        fem::stiffening_at(fem.relaxation, frequency) / fem::stiffening_at(fem.relaxation, oscillation->order);
    oscillation->amplitude *= std::abs(change);
    oscillation->phase += std::arg(change);
    ++oscillation;
  }
}

/// A path in the place of the cosines, dimensionless with its duration as the cycle; a force in that of a displacement.
void take_path(const Case::Path& path, FemCase& fem) {
  const double frequency = mdr::angular_frequency(1 / path.duration());
  fem.units.angular_frequency = frequency;
  fem.first_row = path.time.front();
  fem.relaxation.viscosity *= frequency;
  for (double& time : fem.relaxation.times) time *= frequency;
  const auto over = [](std::vector<double> values, double unit) {
    for (double& value : values) value /= unit;
    return values;
  };
  auto time = path.time;
  for (double& t : time) t = (t - path.time.front()) * frequency;
  time.back() = mdr::angular_frequency(1);
  const auto rest = rest_of(path);
  const double normal = unit_of(path.normal_force, fem.units), tangential = unit_of(path.tangential_force, fem.units);
  fem.motion.indentation = rest.normal / normal;
  fem.motion.path = fem::SampledPath{std::move(time),
                                     over(path.normal, normal),
                                     over(path.tangential, tangential),
                                     rest.normal / normal,
                                     rest.tangential / tangential,
                                     path.repeats,
                                     over(path.transverse, tangential),
                                     rest.transverse / tangential};
}

/// A step at least for each row, and eight at a usual tolerance.
void require_few_rows(const Case& input) {
  if (input.motion.path && input.motion.path->time.size() > most_rows_of_path)
    throw InputError(
        fmt::format("{}: Motion / Path = {}: has {} rows; finite elements step through {} at most, of which fewer "
                    "describe a motion "
                    "as well if they lie closer where it turns; `fretval mdr` answers this case",
                    input.file, input.motion.path->file, input.motion.path->time.size(), most_rows_of_path));
}

/// What the tolerance of a case asks for, unless the case or its mesh says otherwise.
Resolution first_resolution(const Case& input, const FemCase& fem) {
  auto resolution = resolution_for(input.tolerance, fem.relaxation.has_memory());
  // A quarter of them still show annuli of a tenth of the contact.
  constexpr double enough_rings_of_any_profile = 128;
  if (input.rings_per_radius)
    resolution.elements_per_radius = *input.rings_per_radius;
  else if (fem.kind == ContactKind::annuli && resolution.elements_per_radius < enough_rings_of_any_profile)
    resolution = with_rings(resolution, enough_rings_of_any_profile / resolution.elements_per_radius);
  if (fem.given) {
    resolution.elements_per_radius = fem.given->rings_per_radius;
    resolution.mesh_refinements = 0;
  }
  if (input.steps_per_cycle) resolution.steps_per_cycle = *input.steps_per_cycle;
  constexpr double far_on_a_sheet = 600;  // thicknesses; on 12 radii are 1e-3 off, and elements grow with the distance
  if (is_sliding_layer(fem)) resolution.far_radius = far_on_a_sheet;
  return resolution;
}

/// Where the first step of a case begins, as an angle of its cycle.
double first_step_of(const FemCase& fem) {
  return fem.resolution.first_step == 0 ? 0 : fem.resolution.first_step * 2 * fem::pi / fem.steps_per_cycle();
}

void begin_later(double angle, fem::Motion& motion) {
  for (auto* oscillations : {&motion.normal, &motion.tangential})
    for (auto& oscillation : *oscillations) oscillation.phase += oscillation.order * angle;
}

}  // namespace

double tangential_per_depth(const FemCase& fem) {
  return fem::normal_over_tangential_punch(fem.body.poisson_ratio) * fem.friction_coefficient;
}

FemCase fem_case(const Case& input, const ExpectedContact& expected, const std::optional<LimitingIndenter>& limiting) {
  const auto motion = motion_of_case(input.motion, limiting);
  const double deepest = input.motion.normal_force ? expected.largest_indentation : deepest_of(input.motion, motion);
  const auto unworn = any_profile_of(input.indenter);
  const auto kind = kind_of(input, unworn, limiting.has_value());
  const double length =
      kind == ContactKind::annuli ? farthest_depth(input, unworn, deepest) : expected_radius(input, unworn, deepest);
  const Units units{length, deepest, input.elastomer.relaxed_modulus, 1};
  FemCase fem{};
  fem.units = units;
  fem.friction_coefficient = input.friction_coefficient;
  fem.profile = limiting ? profile_in(units, *limiting) : profile_in(units, input.indenter, unworn);
  fem.kind = kind;
  fem.body.poisson_ratio = input.elastomer.poisson_ratio;
  if (!input.body.is_half_space()) fem.solid = solid_of(input, units);
  if (input.body.shape == Case::Body::Shape::mesh) fem.given = given_body(input, units.length);
  fem.full.coupled = input.contact.coupled;
  if (expected.carrying_radius) fem.carrying_radius = *expected.carrying_radius / units.length;
  if (limiting) fem.worn_edge = {limiting->stick_radius / units.length, limiting->outer_radius / units.length};
  if (input.wear_kinetics && !input.wear_kinetics->profile.empty())
    fem.worn_before = worn_by_heights(input.wear_kinetics->profile, units, fem.profile, input.tolerance);
  else if (input.wear_kinetics && !input.wear_kinetics->rings.empty())
    fem.worn_before = worn_by_rings(input.wear_kinetics->rings, units);
  const auto body = body_in_time(input);
  fem.relaxation.viscosity = body.viscosity / units.modulus;
  for (const double modulus : body.branch_moduli) fem.relaxation.moduli.push_back(modulus / units.modulus);
  fem.relaxation.times = body.branch_times;
  fem.motion.normal_force = input.motion.normal_force.has_value();
  fem.motion.tangential_force = input.motion.tangential_force.has_value();
  fem.scales_tangential = !fem.motion.tangential_force && !input.wear_kinetics;
  const auto cycle = mdr::common_cycle(motion);
  require_few_rows(input);
  fem.motion_kind = motion_kind_of(input.motion);
  if (input.motion.path)
    take_path(*input.motion.path, fem);
  else if (cycle && (fem.motion.has_forces() || cycle->highest_order() <= longest_cycle))
    take_cycle(motion, *cycle, fem);
  else
    fem.without_short_cycle = motion;
  const auto resolution = first_resolution(input, fem);
  fem = at_resolution(std::move(fem), resolution);
  require_room_on_sphere(input, fem);
  return fem;
}

bool is_sliding_layer(const FemCase& fem) {
  return fem.solid && fem.solid->slides_on_base && !fem.solid->radius && !fem.given;
}

FemCase at_resolution(FemCase fem, const Resolution& resolution) {
  begin_later(-first_step_of(fem), fem.motion);
  fem.resolution = resolution;
  if (fem.without_short_cycle) {
    const auto near = near_cycle_of(fem, resolution.n_creep_cycles);
    take_cycle(*fem.without_short_cycle, near.cycle, fem);
    if (fem.scales_tangential) take_forces_of(*fem.without_short_cycle, fem);
    fem.error_of_demand = near.error_of_demand;
    fem.error_of_normal = near.error_of_normal;
    fem.motion.locked = !near.creeps;
    if (near.creeps && fem.motion.tangential.size() == 1) fem.motion.tangential.front().phase = 0;
  }
  begin_later(first_step_of(fem), fem.motion);
  fem.body.growth = resolution.growth;
  fem.body.far_radius = resolution.far_radius;
  fem.body.degree = resolution.degree;
  fem.body.tangential = fem.motion.tangential_amplitude() > 0 || fem.kind == ContactKind::plane;
  take_rings(fem);
  fem.motion.n_ramp_cycles = resolution.n_ramp_cycles;
  fem.motion.n_creep_cycles = resolution.n_creep_cycles;
  return fem;
}

std::vector<std::string> left_out(const FemCase& fem) {
  std::vector<std::string> words;
  if (!fem.body.tangential) words.emplace_back("no tangential motion: no tangential harmonic, no friction history");
  if (fem.motion.is_single_pass())
    words.emplace_back("a single pass: no ramp, no periodic state");
  else if (!fem.relaxation.has_memory())
    words.emplace_back("elastic body: no memory, one cycle of ramp");
  return words;
}

}  // namespace fretval
