#include "comparison/simulation/wear_simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparison/simulation/wear_run.h"
#include "comparison/support/stopwatch.h"
#include "fem/ring_contact/stencil.h"
#include "fem/support/constants.h"
#include "fem/wear/ring_widths.h"
#include "fem/wear/rubbing_rings.h"

namespace fretval {
namespace {

/// The parabola through the worn depths of three neighbouring rings.
fem::Stencil parabola(const WearSimulation& wear, Eigen::Index inner) {
  return {wear.centre, wear.end.worn, inner, 3};
}

/// Where it meets zero first, going outward from the outermost of them; no further than `last`.
double end_of_parabola(const WearSimulation& wear, Eigen::Index inner, double last) {
  const Eigen::VectorXd& worn = wear.end.worn;
  const double start = wear.centre[inner + 2], first = wear.centre[inner + 1] - start,
               second = wear.centre[inner] - start, depth = worn[inner + 2];
  const double slope_first = (worn[inner + 1] - depth) / first, slope_second = (worn[inner] - depth) / second;
  const double bend = (slope_second - slope_first) / (second - first), slope = slope_first - bend * first;
  const double under_root = slope * slope - 4 * bend * depth;
  return slope < 0 && under_root >= 0 ? std::min(start + 2 * depth / (std::sqrt(under_root) - slope), last) : last;
}

/// The worn depth ends at an angle: the parabola through the three outermost rings but one, which may be worn in part,
/// is drawn on to zero. How far that is off, the parabola from one ring further in tells. A ring that wears in part
/// loses the mean of a depth that goes on below zero; its part of the volume is that under the parabola, and its depth
/// that of the parabola at its centre.
void read_outer_edge(const Eigen::VectorXd& areas, WearSimulation& wear) {
  constexpr double nothing = 1e-7;  // of the largest depth
  const Eigen::VectorXd& worn = wear.end.worn;
  const double least = nothing * worn.maxCoeff();
  wear.end_volume = areas.dot(worn);
  Eigen::Index outermost = worn.size() - 1;
  while (outermost >= 0 && worn[outermost] <= least) --outermost;
  if (outermost < 0) return;
  const auto ring = static_cast<std::size_t>(outermost);
  const double inner_edge = wear.radii[ring], last = wear.radii[std::min(ring + 2, wear.radii.size() - 1)];
  const bool is_wide = outermost >= 4;
  wear.worn_radius = is_wide ? end_of_parabola(wear, outermost - 3, last) : wear.radii[ring + 1];
  wear.worn_radius_uncertainty =
      is_wide ? std::abs(end_of_parabola(wear, outermost - 4, last) - wear.worn_radius) : last - inner_edge;
  if (!is_wide || !wear.end.is_shared) return;
  const auto depth = parabola(wear, outermost - 3);
  const auto circumference_times_depth = [&](double r) { return 2 * fem::pi * r * depth(r); };
  const double middle = (inner_edge + wear.worn_radius) / 2;  // Simpson's rule is exact for a cubic
  wear.end_volume += (wear.worn_radius - inner_edge) / 6 *
                         (circumference_times_depth(inner_edge) + 4 * circumference_times_depth(middle) +
                          circumference_times_depth(wear.worn_radius)) -
                     areas[outermost] * worn[outermost];
  wear.end.worn[outermost] = std::max(depth(wear.centre[outermost]), 0.0);
}

}  // namespace

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

WornEdge edge_of_wear(const FemCase& fem, const Case::WearKinetics& wear, double unworn_stick_radius, BodyStore& bodies,
                      const WearRun& run) {
  const auto coarse = with_steps(with_rings(resolution_for_wear(fem.resolution), 0.5), 0.5);
  return settled_edge(fem, unworn_stick_radius, [&](const WornEdge& edge) {
    const auto made = simulate_wear(fem, wear, edge, coarse, bodies, {run.checkpoints});
    const double stick_radius = made.course.curve.back().stick_radius;
    return WearPass{made.course.end, made.course.last.largest_indentation, stick_radius,
                    fem::rings_at(made.radii, stick_radius).outside};
  });
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
  const auto profile = profile_before_wear(fem, body->normal.compliance);
  auto rings = std::make_unique<fem::RubbingRings>(body->normal, *body->tangential, fem.relaxation, fem.motion,
                                                   fem.steps_per_cycle(), profile, fem.friction_coefficient);
  simulation.course = worn_to_its_end(std::move(rings), profile, fem, wear, run.checkpoints, [&](const auto& course) {
    if (run.progress) run.progress(simulation, course);
  });
  const fem::WornContact contact{body->normal, *body->tangential,     fem.relaxation,
                                 fem.motion,   fem.steps_per_cycle(), fem.friction_coefficient};
  simulation.end = fem::end_of_wear(contact, profile.unworn, simulation.course);
  read_outer_edge(body->normal.compliance.areas, simulation);
  simulation.seconds = watch.lap();
  return simulation;
}

}  // namespace fretval
