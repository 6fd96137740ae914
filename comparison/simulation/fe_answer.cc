#include "comparison/simulation/fe_answer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/simulation/fe_cycle.h"
#include "comparison/support/constants.h"
#include "comparison/support/statistics.h"
#include "fem/ring_contact/stick_zone/axis_pressure.h"
#include "fem/ring_contact/stick_zone/contact_radius.h"
#include "fem/ring_contact/stick_zone/largest_force.h"
#include "fem/ring_contact/stick_zone/largest_indentation.h"
#include "fem/ring_contact/stick_zone/limiting_amplitude.h"
#include "fem/ring_contact/stick_zone/stick_depths.h"
#include "fem/ring_contact/stick_zone/stick_zones.h"
#include "fem/ring_contact/stick_zone/touch_indentation.h"

namespace fretval {
namespace {

double largest_share_outside(const fem::NormalHistory& history, const Eigen::VectorXd& areas, Eigen::Index n_inside) {
  double share = 0;
  for (Eigen::Index k = 0; k < history.force.size(); ++k) {
    const Eigen::Index n_outside = areas.size() - n_inside;
    const double outside = history.pressure.col(k).tail(n_outside).dot(areas.tail(n_outside));
    if (history.force[k] > 0) share = std::max(share, outside / history.force[k]);
  }
  return share;
}

NoWearEvidence no_wear_evidence(const ContactProblems& problems, const FemCase& fem, const Eigen::VectorXd& profile,
                                const fem::NormalHistory& normal, const fem::FrictionHistory& friction,
                                Eigen::Index n_inside) {
  const auto& compliance = problems.normal.compliance;
  // The ring in which the unworn indenter begins does not count as worn.
  const auto& radii = compliance.radii;
  const auto outer = std::upper_bound(radii.begin(), radii.end(), fem.worn_edge->outer) - radii.begin() - 1;
  const auto n_worn = std::max<Eigen::Index>(outer - n_inside, 1);
  NoWearEvidence evidence{0, largest_share_outside(normal, compliance.areas, n_inside),
                          fem::touch_indentation(compliance, profile, n_inside, n_worn), std::nullopt};
  if (!problems.tangential) return evidence;
  evidence.slip_inside = friction.period_slip.head(n_inside).maxCoeff() / friction.amplitude;
  evidence.limiting_amplitude = fem::limiting_amplitude(problems.normal, *problems.tangential, fem.relaxation,
                                                        fem.friction_coefficient, fem.motion, normal, n_inside);
  return evidence;
}

/// Where all of the contact inside a worn flank sticks, the edge of the zone is known. Where no ring sticks, the fall
/// of the slip towards the centre tells whether that holds up to it.
void read_on_worn_profile(const fem::Compliance& compliance, Eigen::Index n_inside, Eigen::Index n_stuck,
                          const Eigen::VectorXd& slip, fem::EdgeRadius& zone) {
  if (n_stuck == n_inside) zone = {compliance.radii[n_stuck], 0};
  if (n_stuck == 0 && 2 * slip[0] > slip[1]) zone.uncertainty = 0;
}

/// Replaces the edge of a zone by the number of rings that stick, known to the next ring, where the two differ by more
/// than that: next to the worn edge the margins after shakedown are singular, but rings are fine.
void hold_to_count(const fem::Compliance& compliance, Eigen::Index n_stuck, fem::EdgeRadius& zone) {
  if (n_stuck == 0) return;
  const double counted = compliance.radii[n_stuck], next = compliance.radii[n_stuck + 1] - counted;
  if (std::abs(zone.radius - counted) > next) zone = {counted, next};
}

/// A stick zone narrower than a ring is none that the mesh can show.
std::optional<double> dimensional(const fem::EdgeRadius& edge, double length) {
  if (edge.radius <= 0) return std::nullopt;
  return edge.radius * length;
}

Eigen::Index largest_contact_rings(const fem::NormalHistory& history) {
  Eigen::Index n = 0;
  while (n < history.smallest_gap.size() && history.smallest_gap[n] <= 0) ++n;
  return n;
}

/// longest: up to which slip counts.
DiscAnswer stick_depths(const fem::PunchSeries& series, const FemCase& fem, const fem::FrictionHistory& friction,
                        const ZoneRings& rings, double longest) {
  const Eigen::Index n_contact = rings.contact;
  const auto depths = [&](const Eigen::VectorXd& reserve, const Eigen::VectorXd& slip, Eigen::Index n_stuck) {
    return fem::stick_depths({reserve.head(n_contact), series.displacements(slip).head(n_contact), n_stuck},
                             series.radii(), tangential_per_depth(fem), longest);
  };
  return {depths(friction.first_slip_reserve, friction.slip_path, rings.stuck.first_slip),
          depths(friction.shakedown_reserve, friction.period_slip / 4, rings.stuck.shakedown)};
}

/// Whether the innermost rings slip by too much for anything to stick, although they never lift.
bool sticks_nowhere(const fem::NormalHistory& normal, const fem::StickDepths& slips) {
  const auto n = std::min<Eigen::Index>(2, normal.pressure.rows());
  return normal.pressure.topRows(n).minCoeff() > 0 && fem::sticks_nowhere(slips);
}

/// Corrects the zones of a worn profile, and returns the evidence that nothing wears.
NoWearEvidence read_worn(const ContactProblems& problems, const FemCase& fem, const Eigen::VectorXd& profile,
                         const fem::NormalHistory& normal, const fem::FrictionHistory& friction,
                         const fem::StuckRings& stuck, fem::StickZones& zones) {
  const auto& compliance = problems.normal.compliance;
  auto& [first, shakedown] = zones;
  const Eigen::Index n_inside = fem::rings_within(compliance, fem.worn_edge->inner);
  hold_to_count(compliance, stuck.shakedown, shakedown);
  const double by_reserve = first.radius;
  read_on_worn_profile(compliance, n_inside, stuck.first_slip, friction.slip_path, first);
  // Rings that slip between two steps alone, or by as little as one that settles, are counted as stuck.
  first.uncertainty = std::max(first.uncertainty, first.radius - by_reserve);
  read_on_worn_profile(compliance, n_inside, stuck.shakedown, friction.period_slip, shakedown);
  return no_wear_evidence(problems, fem, profile, normal, friction, n_inside);
}

/// Whether a branch relaxes within a step. Slip that dies out takes place in one step, and its factor does not show
/// such a branch.
bool relaxes_in_a_step(const FemCase& fem) {
  const double step = 2 * pi / fem.steps_per_cycle();
  const auto& times = fem.relaxation.times;
  return std::any_of(times.begin(), times.end(), [step](double time) { return time < step; });
}

/// How slip dies out inside a shakedown radius.
void read_settling(const fem::Compliance& compliance, const FemCase& fem, const fem::FrictionHistory& friction,
                   double radius, FeAnswer& answer) {
  const auto n_stuck = answer.rings.stuck.shakedown;
  if (!relaxes_in_a_step(fem)) answer.slip_decay = fem::decay_factor(friction, n_stuck, fem.motion.cycles_of_ramp());
  if (!fem.relaxation.has_memory()) return;
  const auto cycles = [&](fem::SlipBeyond beyond) {
    return cycles_until(fem::mean_slip_of_periods(friction, compliance.areas, n_stuck, radius, beyond),
                        slip_that_counts_as_none);
  };
  answer.cycles_to_shakedown = cycles(fem::SlipBeyond::linear);
  const auto other = cycles(fem::SlipBeyond::constant);
  if (answer.cycles_to_shakedown && other)
    answer.cycles_to_shakedown_uncertainty = std::abs(*answer.cycles_to_shakedown - *other);
}

constexpr double bluntest = 8;  // exponent, which a flat face counts as

/// Exponent n of f ~ r^n between half of a radius and the radius.
double exponent_at(double radius, const FemCase& fem) {
  const double outside = fem.profile(radius), half_way = fem.profile(radius / 2);
  return half_way > 0 ? std::min(std::log2(outside / half_way), bluntest) : bluntest;
}

double exponent_at_edge(const FemCase& fem) {
  return exponent_at(1, fem);
}

/// Reads the largest pressure on the axis; empty: infinite, under a sharp tip and where a body with a dashpot is
/// touched anew. Unknown where a branch relaxes within the step in which the axis is touched anew: that branch bears
/// for as long as it lasts, which no step shows. Pressures beyond a worn edge are left out, as nothing is pressed there
/// in the limit.
void read_axis_pressure(const FemCase& fem, const fem::ContactProblem& problem, const fem::NormalHistory& normal,
                        FeAnswer& answer) {
  constexpr double near_axis = 1e-4, sharp = 1 + 1e-3, roundoff = 1e-6;
  const double exponent = exponent_at(near_axis, fem);
  const bool touches_anew = normal.force.minCoeff() <= 0;
  if (exponent < sharp || (touches_anew && fem.relaxation.viscosity > 0)) return;
  Eigen::MatrixXd pressure = normal.pressure;
  Eigen::VectorXd radius = normal.contact_radius;
  if (fem.worn_edge) {
    pressure.bottomRows(pressure.rows() - fem::rings_within(problem.compliance, fem.worn_edge->inner)).setZero();
    radius = radius.cwiseMin(fem.worn_edge->inner);
  }
  const auto largest_with = [&](double n) {
    return fem::axis_pressure_max(problem.series, pressure, radius, n, normal.pieces);
  };
  const auto largest = largest_with(exponent);
  if (!largest) return;
  answer.axis_pressure_max = *largest * fem.units.pressure();
  const double outermost = problem.series.radii()[fem::outermost_tip_ring],
               farther_out = std::max(exponent_at(outermost, fem), sharp);
  const bool face_ends = fem.profile(outermost / 2) <= 0 && fem.profile(outermost) > 0;
  if ((exponent == bluntest && (face_ends || farther_out < bluntest)) || (touches_anew && relaxes_in_a_step(fem)))
    answer.axis_pressure_uncertainty = std::numeric_limits<double>::infinity();
  else if (std::abs(farther_out - exponent) > roundoff)
    answer.axis_pressure_uncertainty =
        std::abs(*largest - largest_with(farther_out).value_or(0)) * fem.units.pressure();
}

}  // namespace

std::optional<ContactRadius> read_contact_radius(const fem::ContactProblem& problem, const FemCase& fem,
                                                 const Eigen::VectorXd& profile, const fem::NormalHistory& history) {
  if (fem.kind == ContactKind::worn || fem.kind == ContactKind::annuli) return std::nullopt;
  const auto events = fem::contact_events(problem.compliance, profile);
  if (fem.motion.normal_force) {
    // a ~ d^(1/n)
    const double radius = fem::largest_contact_radius(history.smallest_gap_at_balance, events).radius;
    const auto [depth, uncertainty] = fem::largest_indentation(problem, fem.relaxation, history);
    return ContactRadius{radius, radius * uncertainty / (depth * exponent_at_edge(fem)), events.calibration};
  }
  return ContactRadius{fem::largest_contact_radius(history.smallest_gap, events).radius, 0, events.calibration};
}

void read_normal_response(const ContactProblems& problems, const FemCase& fem,
                          const std::optional<ContactRadius>& contact_radius, const fem::NormalHistory& normal,
                          FeAnswer& answer) {
  const double length = fem.units.length;
  if (contact_radius && contact_radius->radius > 0) answer.contact_radius_max = contact_radius->radius * length;
  if (contact_radius) {
    answer.contact_radius_uncertainty = contact_radius->uncertainty * length;
    answer.contact_radius_calibration = contact_radius->calibration * length;
  }
  const auto force = fem::largest_force(normal, fem.motion.highest_normal_order(),
                                        fem.worn_edge ? fem::Flank::around_contact : fem::Flank::none);
  answer.normal_force_max = force.value * fem.units.force();
  read_axis_pressure(fem, problems.normal, normal, answer);
  answer.normal_force_uncertainty = force.uncertainty * fem.units.force();
  if (!fem.motion.normal_force) return;
  const auto [depth, uncertainty] = fem::largest_indentation(problems.normal, fem.relaxation, normal);
  answer.indentation_max = depth * fem.units.depth;
  answer.indentation_uncertainty = uncertainty * fem.units.depth;
}

FeAnswer read_answer(const ContactProblems& problems, const FemCase& fem, const Eigen::VectorXd& profile,
                     const std::optional<ContactRadius>& contact_radius, fem::NormalHistory normal,
                     fem::FrictionHistory&& friction) {
  const auto& problem = problems.tangential ? *problems.tangential : problems.normal;
  FeAnswer answer;
  const auto stuck = fem::stuck_rings(friction, fem.motion);
  answer.rings = {largest_contact_rings(normal), stuck};
  auto zones = fem::stick_zones(problem.compliance, friction, stuck);
  auto& [first, shakedown] = zones;
  if (fem.kind == ContactKind::worn) {
    answer.of_kind = read_worn(problems, fem, profile, normal, friction, stuck, zones);
  } else {
    answer.of_kind = stick_depths(problem.series, fem, friction, answer.rings, 2 * friction.amplitude);
    const auto [first_slips, shakedown_slips] =
        stick_depths(problem.series, fem, friction, answer.rings, std::numeric_limits<double>::infinity());
    const bool lifts = !is_pass(fem.motion_kind) && normal.indentation.minCoeff() <= 0;
    if (lifts || sticks_nowhere(normal, first_slips)) first.uncertainty = 0;
    if (lifts || sticks_nowhere(normal, shakedown_slips)) shakedown.uncertainty = 0;
  }

  read_normal_response(problems, fem, contact_radius, normal, answer);
  const double length = fem.units.length;
  answer.stick_radius_first_slip = dimensional(first, length);
  if (!is_pass(fem.motion_kind)) answer.stick_radius_shakedown = dimensional(shakedown, length);
  answer.first_slip_uncertainty = first.uncertainty * length;
  answer.shakedown_uncertainty = shakedown.uncertainty * length;
  if (fem.motion.tangential_force && fem.has_period())
    answer.tangential_amplitude = friction.amplitude * fem.units.depth;
  answer.cycle = cycle_of(fem, answer.normal_force_max / fem.units.force(), normal, friction);
  if (answer.cycle && !is_pass(fem.motion_kind) && !normal.n_cycles_of_search && !friction.jumped)
    read_settling(problem.compliance, fem, friction, shakedown.radius, answer);
  answer.n_cycles = friction.n_cycles + friction.n_cycles_of_search + normal.n_cycles_of_search;
  answer.n_steps = friction.n_steps;
  answer.normal = std::move(normal);
  answer.friction = std::move(friction);
  return answer;
}

}  // namespace fretval
