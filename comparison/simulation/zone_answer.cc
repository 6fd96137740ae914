#include "comparison/simulation/zone_answer.h"

#include <algorithm>

#include "comparison/simulation/fe_cycle.h"
#include "fem/motion/running_minimum.h"
#include "fem/ring_contact/static_contact.h"

namespace fretval {
namespace {

using Rings = std::vector<bool>;
using Annuli = std::vector<fem::Annulus>;

template <class Condition>
Rings rings_that(Eigen::Index n, const Condition& condition) {
  Rings rings(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) rings[static_cast<std::size_t>(i)] = condition(i);
  return rings;
}

Annuli in_metres(Annuli annuli, double length) {
  for (auto& [inner, outer] : annuli) {
    inner *= length;
    outer *= length;
  }
  return annuli;
}

double widest_ring(const std::vector<double>& radii) {
  double widest = 0;
  for (std::size_t i = 1; i < radii.size(); ++i) widest = std::max(widest, radii[i] - radii[i - 1]);
  return widest;
}

void add_contact(const fem::ContactProblem& problem, const FemCase& fem, const Eigen::VectorXd& profile,
                 const fem::NormalHistory& normal, ZoneAnswer& zones) {
  const auto& compliance = problem.compliance;
  const auto at_rest = fem::static_contact(problem, profile, normal.largest_indentation);
  const auto n = profile.size();
  const auto touch = rings_that(n, [&](auto i) { return normal.smallest_gap[i] <= 0; }),
             touch_at_rest = rings_that(n, [&](auto i) { return at_rest.pressure[i] > 0; });
  const double length = fem.units.length;
  const auto annuli = fem::contact_annuli(problem, at_rest.pressure, at_rest.gap);
  zones.contact = in_metres(touch == touch_at_rest ? annuli : fem::annuli_of(touch, compliance.radii), length);
  if (touch != touch_at_rest) zones.contact_uncertainty = widest_ring(compliance.radii) * length;
  zones.force_at_rest = fem.relaxation.relaxed * compliance.areas.dot(at_rest.pressure) * fem.units.force();
  if (!annuli.empty()) zones.radius_at_rest = annuli.back().outer * length;
  zones.pressure_max = normal.pressure.maxCoeff() * fem.units.pressure();
}

void add_stick(const fem::ContactProblem& problem, const FemCase& fem, const fem::FrictionHistory& friction,
               ZoneAnswer& zones) {
  constexpr double never_slipped = 1e-9;
  const double allowed = fem::slip_of_stuck_ring(fem.motion, friction.amplitude);
  const auto n = friction.slip_path.size();
  const auto never = rings_that(n, [&](auto i) {
    return friction.slip_path[i] <= never_slipped * friction.amplitude && friction.first_slip_margin[i] > 0;
  });
  const auto no_more =
      rings_that(n, [&](auto i) { return friction.period_slip[i] <= allowed && friction.shakedown_margin[i] > 0; });
  zones.first_slip = in_metres(fem::stick_annuli(problem, friction.first_slip_margin, never), fem.units.length);
  if (!is_pass(fem.motion_kind))
    zones.shakedown = in_metres(fem::stick_annuli(problem, friction.shakedown_margin, no_more), fem.units.length);
}

std::optional<double> radius_of_disc(const Annuli& zone) {
  return zone.size() == 1 && zone.front().inner == 0 ? std::optional(zone.front().outer) : std::nullopt;
}

}  // namespace

FeAnswer read_zones(const ContactProblems& problems, const FemCase& fem, const Eigen::VectorXd& profile,
                    fem::NormalHistory normal, fem::FrictionHistory&& friction) {
  FeAnswer answer;
  ZoneAnswer zones;
  add_contact(problems.normal, fem, profile, normal, zones);
  add_stick(problems.tangential ? *problems.tangential : problems.normal, fem, friction, zones);
  const double largest_force = fem::largest_of_period(normal.force, normal.pieces);
  answer.normal_force_max = largest_force * fem.units.force();
  if (!zones.contact.empty()) answer.contact_radius_max = zones.contact.back().outer;
  answer.contact_radius_uncertainty = zones.contact_uncertainty;
  answer.stick_radius_first_slip = radius_of_disc(zones.first_slip);
  answer.stick_radius_shakedown = radius_of_disc(zones.shakedown);
  answer.rings.contact = (normal.smallest_gap.array() <= 0).count();
  answer.rings.stuck = fem::stuck_rings(friction, fem.motion);
  answer.cycle = cycle_of(fem, largest_force, normal, friction);
  answer.n_cycles = friction.n_cycles + friction.n_cycles_of_search + normal.n_cycles_of_search;
  answer.n_steps = friction.n_steps;
  answer.of_kind = std::move(zones);
  answer.normal = std::move(normal);
  answer.friction = std::move(friction);
  return answer;
}

}  // namespace fretval
