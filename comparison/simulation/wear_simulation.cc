#include "comparison/simulation/wear_simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comparison/simulation/bodies/operator_key.h"
#include "comparison/simulation/wear_checkpoint.h"
#include "comparison/support/stopwatch.h"
#include "fem/contact/require_room.h"
#include "fem/contact/static_contact.h"
#include "histories_hash.h"

namespace fretval {
namespace {

/// Under a height of the largest indentation the flank reaches the plane that no surface comes above.
double widest_wear(const FemCase& fem, double largest_indentation) {
  double inner = 1, outer = 1;
  while (fem.profile(outer) < largest_indentation) inner = std::exchange(outer, 1.25 * outer);
  constexpr double close = 1e-3;
  while (outer - inner > close) {
    const double middle = (inner + outer) / 2;
    (fem.profile(middle) < largest_indentation ? inner : outer) = middle;
  }
  return outer;
}

/// In the units of the case: depths have one of their own, and so have lengths of slip.
fem::WearLaw law_in(const Units& units, const Case::WearKinetics& wear, double friction_coefficient) {
  const double coefficient =
      wear.law == Case::WearLaw::energy ? friction_coefficient * wear.coefficient : wear.coefficient;
  return {coefficient * std::pow(units.pressure(), wear.exponent), wear.exponent};
}

/// Where the parabola through the worn depths of three neighbouring rings meets zero first, going outward from the
/// outermost of them; no further than `last`.
double end_of_parabola(const WearSimulation& wear, Eigen::Index inner, double last) {
  const Eigen::VectorXd& worn = wear.course.worn.back();
  const double start = wear.centre[inner + 2], first = wear.centre[inner + 1] - start,
               second = wear.centre[inner] - start, depth = worn[inner + 2];
  const double slope_first = (worn[inner + 1] - depth) / first, slope_second = (worn[inner] - depth) / second;
  const double bend = (slope_second - slope_first) / (second - first), slope = slope_first - bend * first;
  const double under_root = slope * slope - 4 * bend * depth;
  return slope < 0 && under_root >= 0 ? std::min(start + 2 * depth / (std::sqrt(under_root) - slope), last) : last;
}

/// The worn depth ends at an angle: the parabola through the three outermost rings but one, which may be worn in part,
/// is drawn on to zero. How far that is off, the parabola from one ring further in tells.
void read_worn_radius(WearSimulation& wear) {
  constexpr double nothing = 1e-7;
  const Eigen::VectorXd& worn = wear.course.worn.back();
  Eigen::Index outermost = worn.size() - 1;
  while (outermost >= 0 && worn[outermost] <= nothing) --outermost;
  if (outermost < 0) return;
  const auto ring = static_cast<std::size_t>(outermost);
  const double inner_edge = wear.radii[ring], last = wear.radii[std::min(ring + 2, wear.radii.size() - 1)];
  const bool is_wide = outermost >= 4;
  wear.worn_radius = is_wide ? end_of_parabola(wear, outermost - 3, last) : wear.radii[ring + 1];
  wear.worn_radius_uncertainty =
      is_wide ? std::abs(end_of_parabola(wear, outermost - 4, last) - wear.worn_radius) : last - inner_edge;
}

/// All that the course depends on, bit for bit.
std::string description(const FemCase& fem, const fem::WearLaw& law, const fem::WearControl& control,
                        const fem::WornProfile& profile) {
  auto text = "wear " FRETVAL_HISTORIES_HASH "\n" + operator_key(fem.body, fem::lateral);
  const auto add = [&text](const auto& values) {
    text += '\n';
    for (const double value : values) text += fmt::format(" {:a}", value);
  };
  const auto add_motion = [&add](const std::vector<fem::Oscillation>& oscillations) {
    for (const auto& [amplitude, order, phase, across] : oscillations) add(std::array{amplitude, 1.0 * order, phase});
  };
  add(profile.unworn);
  add(profile.worn);
  add(std::array{fem.relaxation.relaxed, fem.relaxation.viscosity, fem.friction_coefficient});
  add(fem.relaxation.moduli);
  add(fem.relaxation.times);
  const auto& motion = fem.motion;
  add(std::array{motion.indentation, 1.0 * motion.normal_force, 1.0 * motion.tangential_force, 1.0 * motion.locked,
                 1.0 * motion.n_ramp_cycles, 1.0 * motion.n_creep_cycles, 1.0 * fem.steps_per_cycle()});
  add_motion(motion.normal);
  add_motion(motion.tangential);
  if (const auto& path = motion.path) {
    for (const auto* rows : {&path->time, &path->normal, &path->tangential}) add(*rows);
    add(std::array{path->rest_normal, path->rest_tangential});
  }
  add(std::array{law.coefficient, law.exponent, control.most_cycles, control.rate_fallen_to, control.largest_jump,
                 control.accuracy});
  return text + '\n';
}

}  // namespace

RingWidths rings_at(const std::vector<double>& radii, double radius) {
  const auto outer = std::upper_bound(radii.begin(), radii.end(), radius), at = outer - 1;
  return {at == radii.begin() ? 0 : at[0] - at[-1], outer == radii.end() ? 0 : outer[0] - at[0]};
}

Resolution resolution_for_wear(const Resolution& of_the_case) {
  constexpr unsigned rings = 64, degree = 5;
  constexpr int steps = 144;
  constexpr double edge_ring = 1e-4;
  Resolution r = of_the_case;
  r.elements_per_radius = rings;
  r.degree = degree;
  r.steps_per_cycle = steps;
  r.worn_edge_ring = edge_ring;
  r.focus.reset();
  return r;
}

bool stick_radius_moves(const FemCase& fem) {
  return fem.motion.has_forces() || fem.solid;
}

WornEdge edge_of_wear(const FemCase& fem, const Case::WearKinetics& wear, double unworn_stick_radius, BodyStore& bodies,
                      const WearRun& run) {
  if (!stick_radius_moves(fem)) return {unworn_stick_radius, widest_wear(fem, 1)};
  const bool sinks = fem.motion.has_forces();
  constexpr int most_passes = 12;
  constexpr double reserve = 1.05, deeper = 1.5;
  auto resolution = with_steps(with_rings(resolution_for_wear(fem.resolution), 0.5), 0.5);
  double depth = sinks ? deeper : 1, stick_radius = unworn_stick_radius;
  for (int pass = 0; pass < most_passes; ++pass) {
    const WornEdge edge{stick_radius, widest_wear(fem, depth)};
    try {
      const auto pass_made = simulate_wear(fem, wear, edge, resolution, bodies, {run.checkpoints});
      const auto& course = pass_made.course;
      if (course.end == fem::WearEnd::progressive) return {0, edge.outer};
      if (sinks) depth = reserve * course.last.largest_indentation;
      const double before = std::exchange(stick_radius, course.curve.back().stick_radius);
      if (std::abs(stick_radius - before) <= rings_at(pass_made.radii, stick_radius).outside)
        return {stick_radius, widest_wear(fem, depth)};
    } catch (const fem::NoRoom&) {
      if (fem.given) throw;
      depth *= deeper;
    }
  }
  throw fem::SolverError(fmt::format("the stick radius under wear does not settle in {} runs", most_passes));
}

WearSimulation simulate_wear(const FemCase& fem_case, const Case::WearKinetics& wear, const WornEdge& edge,
                             const Resolution& resolution, BodyStore& bodies, const WearRun& run) {
  Stopwatch watch;
  FemCase fem = fem_case;
  fem.worn_edge = edge;
  fem = at_resolution(std::move(fem), resolution);
  const auto body = find_or_make_body(fem.body, bodies);
  WearSimulation simulation;
  simulation.body = body->summary;
  simulation.radii = body->summary->radii;
  const auto n_rings = body->normal.n_rings();
  simulation.unworn.resize(n_rings);
  simulation.centre.resize(n_rings);
  for (Eigen::Index i = 0; i < n_rings; ++i) {
    simulation.centre[i] = std::hypot(simulation.radii[i], simulation.radii[i + 1]) / std::sqrt(2);
    simulation.unworn[i] = fem.profile(simulation.centre[i]);
  }
  constexpr double nothing = 1e-6;
  const auto law = law_in(fem.units, wear, fem.friction_coefficient);
  const fem::WearControl control{wear.n_cycles.value_or(std::numeric_limits<double>::infinity()), wear.until,
                                 resolution.wear_jump, nothing};
  fem::WornProfile profile{fem::ring_means(body->normal.compliance, fem.profile), Eigen::VectorXd::Zero(n_rings)};
  if (const auto& before = fem.worn_before)
    profile.worn = fem::ring_means(body->normal.compliance, before->depth, before->kinks);
  const fem::WearState start{fem::WearingContact(body->normal, *body->tangential, fem.relaxation, fem.motion,
                                                 fem.steps_per_cycle(), profile, fem.friction_coefficient, law)};
  WearCheckpoint checkpoint(run.checkpoints, description(fem, law, control, profile));
  auto state = checkpoint.restored(start).value_or(start);
  fem::wear_on(state, control, [&](const fem::WearState& now) {
    checkpoint.keep(now);
    if (run.progress) run.progress(simulation, now.course);
  });
  simulation.course = std::move(state.course);
  read_worn_radius(simulation);
  simulation.seconds = watch.lap();
  return simulation;
}

}  // namespace fretval
