#include "comparison/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/support/stopwatch.h"
#include "fem/history/running_minimum.h"
#include "fem/stick_zone/contact_radius.h"
#include "fem/stick_zone/edge_near_largest_contact.h"
#include "fem/stick_zone/largest_force.h"
#include "fem/stick_zone/stick_depths.h"
#include "fem/stick_zone/stick_zones.h"
#include "fem/stick_zone/touch_indentation.h"

namespace fretval {
namespace {

constexpr double pi = 3.14159265358979323846;

Eigen::Index rings_within(const fem::Compliance& compliance, double radius) {
  Eigen::Index n = 0;
  // Half a ring of slack: the node at the edge is there to roundoff.
  while (n < compliance.areas.size() && (compliance.radii[n] + compliance.radii[n + 1]) / 2 < radius) ++n;
  return n;
}

double largest_share_outside(const fem::NormalHistory& history, const Eigen::VectorXd& areas, Eigen::Index n_inside) {
  double share = 0;
  for (Eigen::Index k = history.force.size() - history.steps_per_cycle; k < history.force.size(); ++k) {
    const Eigen::Index n_outside = areas.size() - n_inside;
    const double outside = history.pressure.col(k).tail(n_outside).dot(areas.tail(n_outside));
    if (history.force[k] > 0) share = std::max(share, outside / history.force[k]);
  }
  return share;
}

NoWearEvidence no_wear_evidence(const fem::Compliance& compliance, const FemCase& scene, const NormalSimulation& normal,
                                const fem::FrictionHistory& friction) {
  const Eigen::Index n_inside = rings_within(compliance, scene.worn_edge->inner);
  const Eigen::Index n_worn = rings_within(compliance, scene.worn_edge->outer) - n_inside;
  return {friction.period_slip.head(n_inside).maxCoeff() / scene.motion.tangential_amplitude,
          largest_share_outside(normal.history, compliance.areas, n_inside),
          fem::touch_indentation(compliance, normal.profile, n_inside, n_worn)};
}

fem::HistoryControl control_of(const FemCase& scene) {
  constexpr int most_after_ramp = 400;
  return {scene.resolution.steps_per_cycle, scene.resolution.n_ramp_cycles + most_after_ramp,
          scene.resolution.periodicity};
}

/// A stick zone narrower than a ring is none that the mesh can show.
std::optional<double> dimensional(const fem::EdgeRadius& edge, double length) {
  if (edge.radius <= 0) return std::nullopt;
  return edge.radius * length;
}

/// Where the indenter does not move tangentially, nothing slips: a margin is the friction limit itself.
fem::FrictionHistory history_at_rest(const fem::ContactProblem& problem, double friction_coefficient,
                                     const fem::NormalHistory& normal) {
  const Eigen::Index n = problem.n_rings(), n_instants = normal.pressure.cols(), n_steps = normal.steps_per_cycle;
  const Eigen::MatrixXd limit = friction_coefficient * normal.pressure;
  const Eigen::MatrixXd reserve = problem.series.depths(limit);
  constexpr double none = -std::numeric_limits<double>::infinity();
  const auto smallest = [](const Eigen::MatrixXd& samples) {
    fem::RunningMinimum minimum(samples.rows(), none);
    for (Eigen::Index k = 0; k < samples.cols(); ++k) minimum.add(samples.col(k));
    return minimum.value();
  };
  fem::FrictionHistory history{};
  history.n_cycles = normal.n_cycles;
  history.first_slip_margin = limit.rowwise().minCoeff();
  history.shakedown_margin = limit.rightCols(n_steps).rowwise().minCoeff();
  history.first_slip_reserve = smallest(reserve);
  history.shakedown_reserve = smallest(reserve.rightCols(n_steps));
  history.slip_path = history.period_slip = history.friction_work = history.displacement = Eigen::VectorXd::Zero(n);
  history.force = Eigen::VectorXd::Zero(n_instants);
  history.traction = Eigen::MatrixXd::Zero(n, n_steps);
  return history;
}

Eigen::Index largest_contact_rings(const fem::NormalHistory& history) {
  Eigen::Index n = 0;
  while (n < history.smallest_gap.size() && history.smallest_gap[n] <= 0) ++n;
  return n;
}

void add_stick_depths(const fem::PunchSeries& series, const FemCase& scene, FeAnswer& answer) {
  const auto& friction = answer.friction;
  const Eigen::Index n_contact = answer.rings.contact;
  const double amplitude = scene.motion.tangential_amplitude;
  const auto depths = [&](const Eigen::VectorXd& reserve, const Eigen::VectorXd& slip, Eigen::Index n_stuck) {
    return fem::stick_depths({reserve.head(n_contact), series.displacements(slip).head(n_contact), n_stuck},
                             series.radii(), 1.5 * scene.friction_coefficient, amplitude);
  };
  answer.first_slip_depths = depths(friction.first_slip_reserve, friction.slip_path, answer.rings.stuck.first_slip);
  answer.shakedown_depths = depths(friction.shakedown_reserve, friction.period_slip / 4, answer.rings.stuck.shakedown);
}

/// Whether a branch or, after a release, the dashpot relaxes within two steps.
bool relaxes_within_a_step(const FemCase& scene) {
  const double step = 2 * pi / scene.resolution.steps_per_cycle;
  const auto is_short = [step](double time) { return time < 2 * step; };
  const auto& [relaxed, moduli, times, viscosity] = scene.relaxation;
  return (viscosity > 0 && is_short(viscosity / relaxed)) || std::any_of(times.begin(), times.end(), is_short);
}

void read_contact_radius(const fem::ContactProblem& problem, const FemCase& scene, NormalSimulation& simulation) {
  const auto events = fem::contact_events(problem.compliance, simulation.profile);
  simulation.contact_radius = fem::largest_contact_radius(simulation.history.smallest_gap, events);
  fem::read_edges_near_largest_contact(problem.series, simulation.contact_radius->radius, simulation.history);
  if (!relaxes_within_a_step(scene)) return;
  const auto other = fem::largest_contact_radius(simulation.history.smallest_gap_at_balance, events);
  simulation.contact_radius_uncertainty = 2 * std::abs(other.radius - simulation.contact_radius->radius);
}

/// n of f ~ r^n in the outer half of the contact; at most that of the bluntest indenters. A flat face counts as such.
double exponent_at_edge(const FemCase& scene) {
  constexpr double bluntest = 8;
  const double edge = scene.profile(1), half_way = scene.profile(0.5);
  return half_way > 0 ? std::min(std::log2(edge / half_way), bluntest) : bluntest;
}

/// Next to a sharp edge of the indenter the pressure is singular, and rings that are not graded there miss the stick
/// radius by half a ring (within four rings, at 32 and 128 rings).
void widen_next_to_sharp_edge(const FemCase& scene, const fem::Compliance& compliance, fem::EdgeRadius& zone) {
  if (!scene.sharp_edge || zone.radius <= 0) return;
  const auto& radii = compliance.radii;
  const auto next = std::upper_bound(radii.begin(), radii.end() - 1, zone.radius);
  const double ring = *next - *(next - 1);
  if (std::abs(zone.radius - *scene.sharp_edge) < 4 * ring) zone.uncertainty += ring;
}

}  // namespace

NormalSimulation simulate_normal(const fem::ContactProblem& problem, const FemCase& scene) {
  Stopwatch watch;
  NormalSimulation simulation{};
  simulation.profile = fem::ring_means(problem.compliance, scene.profile);
  simulation.history =
      fem::normal_history(problem, scene.relaxation, simulation.profile, scene.motion, control_of(scene));
  if (!scene.worn_edge) read_contact_radius(problem, scene, simulation);
  simulation.seconds = watch.lap();
  return simulation;
}

FeAnswer simulate(const ContactProblems& problems, const FemCase& scene, const NormalSimulation& normal) {
  Stopwatch watch;
  const auto& problem = problems.tangential ? *problems.tangential : problems.normal;
  FeAnswer answer{};
  answer.friction = problems.tangential ? fem::friction_history(problem, scene.relaxation, scene.friction_coefficient,
                                                                scene.motion, normal.history, control_of(scene))
                                        : history_at_rest(problem, scene.friction_coefficient, normal.history);
  const auto& friction = answer.friction;
  const auto stuck = fem::stuck_rings(friction, scene.motion);
  answer.rings = {largest_contact_rings(normal.history), stuck};
  auto [first, shakedown] =
      fem::stick_zones(problem.compliance, normal.history, friction, stuck, exponent_at_edge(scene));
  if (scene.worn_edge) {
    // The margin is singular at the worn edge, where the rings are fine and one of them ends: counting them is exact.
    shakedown = {problem.compliance.radii[static_cast<std::size_t>(stuck.shakedown)], first.uncertainty};
    answer.no_wear = no_wear_evidence(problems.normal.compliance, scene, normal, friction);
  }

  for (auto* zone : {&first, &shakedown}) widen_next_to_sharp_edge(scene, problem.compliance, *zone);
  if (!scene.worn_edge) add_stick_depths(problem.series, scene, answer);

  const double length = scene.units.length;
  if (normal.contact_radius) answer.contact_radius_max = dimensional(*normal.contact_radius, length);
  answer.contact_radius_uncertainty = normal.contact_radius_uncertainty * length;
  answer.stick_radius_first_slip = dimensional(first, length);
  answer.stick_radius_shakedown = dimensional(shakedown, length);
  answer.first_slip_uncertainty = first.uncertainty * length;
  answer.shakedown_uncertainty = shakedown.uncertainty * length;
  const auto force = fem::largest_force(
      problems.normal, {scene.relaxation, scene.sharp_edge, scene.worn_edge.has_value()}, normal.history);
  answer.normal_force_max = force.value * scene.units.force();
  answer.normal_force_uncertainty = force.uncertainty * scene.units.force();
  answer.n_cycles = friction.n_cycles;
  answer.n_steps = friction.force.size() - 1;
  answer.seconds = watch.lap();
  return answer;
}

}  // namespace fretval
