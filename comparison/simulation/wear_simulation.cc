#include "comparison/simulation/wear_simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/support/stopwatch.h"
#include "fem/history/require_room.h"
#include "fem/history/static_contact.h"

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

/// Where a line through two neighbouring rings meets zero; no further than the first ring that is not worn.
double end_of_line(const WearSimulation& wear, Eigen::Index inner, double last) {
  const Eigen::VectorXd& worn = wear.course.worn.back();
  const double fall = (worn[inner] - worn[inner + 1]) / (wear.centre[inner + 1] - wear.centre[inner]);
  return fall > 0 ? std::min(wear.centre[inner + 1] + worn[inner + 1] / fall, last) : last;
}

/// Wear ends like a straight line: drawn through the two outermost rings but one, which may be worn in part. How far
/// that is off, the line through the two before tells.
void read_worn_radius(WearSimulation& wear) {
  constexpr double nothing = 1e-7;
  const Eigen::VectorXd& worn = wear.course.worn.back();
  Eigen::Index outermost = worn.size() - 1;
  while (outermost >= 0 && worn[outermost] <= nothing) --outermost;
  if (outermost < 0) return;
  const auto ring = static_cast<std::size_t>(outermost);
  const double inner_edge = wear.radii[ring], last = wear.radii[std::min(ring + 2, wear.radii.size() - 1)];
  wear.worn_radius = outermost < 3 ? wear.radii[ring + 1] : end_of_line(wear, outermost - 2, last);
  wear.worn_radius_uncertainty =
      outermost < 3 ? last - inner_edge : std::abs(end_of_line(wear, outermost - 3, last) - wear.worn_radius);
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

WornEdge edge_of_wear(const FemCase& fem, const Case::WearKinetics& wear, double unworn_stick_radius,
                      BodyStore& bodies) {
  if (!fem.motion.normal_force && !fem.motion.tangential_force) return {unworn_stick_radius, widest_wear(fem, 1)};
  constexpr int most_passes = 12;
  constexpr double reserve = 1.05, deeper = 1.5;
  auto resolution = with_steps(with_rings(resolution_for_wear(fem.resolution), 0.5), 0.5);
  double depth = deeper, stick_radius = unworn_stick_radius;
  for (int pass = 0; pass < most_passes; ++pass) {
    const WornEdge edge{stick_radius, widest_wear(fem, depth)};
    try {
      const auto pass_made = simulate_wear(fem, wear, edge, resolution, bodies);
      const auto& course = pass_made.course;
      depth = reserve * course.last.largest_indentation;
      const double before = std::exchange(stick_radius, course.curve.back().stick_radius);
      if (std::abs(stick_radius - before) <= rings_at(pass_made.radii, stick_radius).outside)
        return {stick_radius, widest_wear(fem, depth)};
    } catch (const fem::NoRoom&) {
      depth *= deeper;
    }
  }
  throw fem::SolverError(fmt::format("the stick radius under wear does not settle in {} runs", most_passes));
}

WearSimulation simulate_wear(const FemCase& fem_case, const Case::WearKinetics& wear, const WornEdge& edge,
                             const Resolution& resolution, BodyStore& bodies, const fem::WearProgress& progress) {
  Stopwatch watch;
  FemCase fem = fem_case;
  fem.worn_edge = edge;
  fem = at_resolution(std::move(fem), resolution);
  const auto body = find_or_make_body(fem.body, bodies);
  WearSimulation simulation;
  simulation.body = body->summary;
  simulation.radii = body->summary->radii;
  simulation.unworn = fem::ring_means(body->normal.compliance, fem.profile);
  simulation.centre.resize(simulation.unworn.size());
  for (Eigen::Index i = 0; i < simulation.centre.size(); ++i)
    simulation.centre[i] = std::hypot(simulation.radii[i], simulation.radii[i + 1]) / std::sqrt(2);
  constexpr double nothing = 1e-6;
  simulation.course = fem::wear_course(
      fem::WearingContact(body->normal, *body->tangential, fem.relaxation, fem.motion, fem.steps_per_cycle(),
                          simulation.unworn, fem.friction_coefficient,
                          law_in(fem.units, wear, fem.friction_coefficient)),
      {wear.n_cycles.value_or(std::numeric_limits<double>::infinity()), wear.until, resolution.wear_jump, nothing},
      progress);
  read_worn_radius(simulation);
  simulation.seconds = watch.lap();
  return simulation;
}

}  // namespace fretval
