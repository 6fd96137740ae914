#include "fem/ring_contact/stick_zone/cycle_response.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/motion/peak_bounds.h"
#include "fem/motion/running_minimum.h"
#include "fem/motion/sampled_minimum.h"
#include "fem/ring_contact/stick_zone/largest_force.h"
#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

using Prescribed = ValueAndRate (*)(const Motion&, double);

/// Moves of a prescribed x around each of n instants of a period, begin, begin + dt, ...: y.dot(moves) is `oint y dx`.
Eigen::VectorXd moves(const Motion& motion, Prescribed prescribed, double begin, Eigen::Index n) {
  const double dt = 2 * pi * motion.cycles_per_period() / static_cast<double>(n);
  Eigen::VectorXd moves(n);
  for (Eigen::Index k = 0; k < n; ++k) moves[k] = prescribed(motion, begin + static_cast<double>(k) * dt).rate * dt;
  return moves;
}

/// Moves of a prescribed value in the steps of a path.
Eigen::VectorXd moves_along(const std::vector<double>& values, const SampledPath& path,
                            const std::vector<StepInPiece>& pieces) {
  Eigen::VectorXd moves(static_cast<Eigen::Index>(pieces.size()));
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto& step = pieces[k];
    const double inside = (step.begin + step.end) / 2;
    moves[static_cast<Eigen::Index>(k)] =
        along(path, values, step.end, inside).value - along(path, values, step.begin, inside).value;
  }
  return moves;
}

/// Values in the middle of the steps, from samples at the balance times. before: the sample before the first one.
Eigen::VectorXd in_the_middle(const Eigen::VectorXd& samples, double before, const std::vector<StepInPiece>& pieces) {
  Eigen::VectorXd middle(samples.size());
  for (Eigen::Index k = 0; k < samples.size(); ++k) {
    const double weight = 1.5 - pieces[static_cast<std::size_t>(k)].fraction;
    middle[k] = weight * samples[k] + (1 - weight) * (k == 0 ? before : samples[k - 1]);
  }
  return middle;
}

/// Where forces are prescribed they are known, and of what they make the indenter do this knows nothing.
CycleUncertainty uncertainty_of(const RelaxationModel& relaxation, const Motion& motion, const Eigen::VectorXd& along,
                                const Eigen::VectorXd& down, const NormalHistory& normal,
                                const FrictionHistory& friction) {
  CycleUncertainty uncertainty{};
  Eigen::Index largest = 0;
  friction.force.cwiseAbs().maxCoeff(&largest);
  if (!motion.tangential_force) {
    uncertainty.tangential_force_max = friction.force_uncertainty[largest];
    uncertainty.tangential_force_mean = friction.force_uncertainty.mean();
    uncertainty.cycle_work = uncertainty.tangential_work = friction.force_uncertainty.dot(along.cwiseAbs());
  }
  uncertainty.friction_work = relaxation.has_memory() ? friction.dissipated_uncertainty : uncertainty.cycle_work;
  const double unseen = motion.cycles_per_period() * friction.unseen_slip_energy;
  for (double* work : {&uncertainty.friction_work, &uncertainty.cycle_work, &uncertainty.tangential_work})
    *work += unseen;
  if (!motion.normal_force)
    uncertainty.cycle_work += (normal.force_uncertainty + normal.force_beyond_uncertainty).dot(down.cwiseAbs());
  return uncertainty;
}

/// What of the stiffness in a step stays when the step is over: not the dashpot's.
double lasting_share(const RelaxationModel& relaxation, double step) {
  const double springs = std::accumulate(relaxation.moduli.begin(), relaxation.moduli.end(), relaxation.relaxed);
  return springs / (springs + relaxation.viscosity / step);
}

/// What the dashpot bears of what is locked in fades at once. Prescribed forces are known: under them it is the
/// displacements that are off, by as much work.
CycleOffset off_by_steps(const RelaxationModel& relaxation, const Motion& motion, const FrictionHistory& friction) {
  const auto n = friction.force_off_by_steps.size();
  const double step = 2 * pi * motion.cycles_per_period() / static_cast<double>(n);
  const Eigen::VectorXd off = lasting_share(relaxation, step) * friction.force_off_by_steps;
  double work = 0;
  for (Eigen::Index k = motion.is_single_pass() ? 1 : 0; k < n; ++k)
    work += off[k] * (friction.indenter[k] - friction.indenter[(k + n - 1) % n]);
  if (motion.tangential_force) return {0, 0, work};
  Eigen::Index largest = 0;
  friction.force.cwiseAbs().maxCoeff(&largest);
  return {friction.force[largest] < 0 ? -off[largest] : off[largest], off.mean(), work};
}

/// Column of the normal history at sample k of a period of the friction, which goes on before and after it.
Eigen::Index normal_column(const NormalHistory& normal, const FrictionHistory& friction, Eigen::Index k) {
  const auto n = friction.force.size();
  return normal.column(friction.n_steps - n + (k % n + n) % n + 1);
}

/// The largest normal force in the steps next to sample k of a period, which may lie between two samples but for a
/// path, whose kinks are at its rows.
double largest_normal_force_beside(const NormalHistory& normal, const FrictionHistory& friction, Eigen::Index k) {
  const auto at = [&](Eigen::Index i) {
    const auto column = normal_column(normal, friction, i);
    return normal.force[column] + normal.force_beyond[column];
  };
  double largest = 0;
  for (Eigen::Index i = k - 1; i <= k + 1; ++i) {
    largest = std::max(largest, at(i));
    if (!normal.pieces.empty() || at(i) < std::max(at(i - 1), at(i + 1))) continue;
    const SampledMinimum of_negative(-at(i - 2), -at(i - 1), -at(i), -at(i + 1), -at(i + 2));
    largest = std::max(largest, -of_negative.vertex_of_parabola());
  }
  return largest;
}

/// Whether all rings in contact slip at sample k of a period, but for the innermost one.
bool slides(double friction_coefficient, const NormalHistory& normal, const FrictionHistory& friction, Eigen::Index k) {
  constexpr double roundoff = 1e-9;
  const auto n = friction.force.size(), n_rings = friction.traction.rows();
  if (n_rings < 2) return false;
  const auto pressure = normal.pressure_on_friction().col(normal_column(normal, friction, k));
  const auto traction = friction.traction.col((k % n + n) % n);
  for (Eigen::Index i = 1; i < n_rings; ++i)
    if (std::abs(traction[i]) < (1 - roundoff) * friction_coefficient * pressure[i]) return false;
  return true;
}

/// What |F_x| may be less at its largest sample k, if the contact slides there and sticks in the next sample: a step
/// slides or sticks as a whole, so it may have stuck since the sample before.
double open_where_sliding_ends(double friction_coefficient, const NormalHistory& normal,
                               const FrictionHistory& friction, Eigen::Index k) {
  if (!slides(friction_coefficient, normal, friction, k) || slides(friction_coefficient, normal, friction, k + 1))
    return 0;
  const auto n = friction.force.size();
  return std::abs(friction.force[k]) - std::abs(friction.force[(k + n - 1) % n]);
}

/// Largest |F_x| of the last period, with what reading it between the samples leaves open. It is not more than mu times
/// the largest of the normal forces next to the largest sample: where a sliding contact turns, what interpolates goes
/// beyond that.
LargestForce largest_tangential_force(double friction_coefficient, const Motion& motion, const NormalHistory& normal,
                                      const FrictionHistory& friction) {
  const double read = largest_magnitude_of_period(friction.force, normal.pieces);
  if (motion.tangential_force) return {read, 0};
  Eigen::Index largest = 0;
  const double sample = friction.force.cwiseAbs().maxCoeff(&largest);
  const double limit = std::max(sample, friction_coefficient * largest_normal_force_beside(normal, friction, largest));
  const double value = std::min(read, limit);
  if (motion.path) return {value, 0};  // whose kinks are at its rows
  const auto forward = peak_bounds(friction.force), backward = peak_bounds(-friction.force);
  const double least = std::max(forward.least, backward.least),
               most = std::min(limit, std::max(forward.most, backward.most));
  return {value, std::max({0.0, value - least, most - value,
                           open_where_sliding_ends(friction_coefficient, normal, friction, largest)})};
}

/// What a sum over equal steps leaves open, y . moves, where y jumps within one of them, as the force of a body with
/// memory that is touched again: nobody knows when, so half of the jump times the move. A jump J has a third difference
/// of 2 J across its step, and what is smooth one that vanishes with the third power of the step.
double open_where_it_jumps(const Eigen::VectorXd& y, const Eigen::VectorXd& moves) {
  const auto n = y.size();
  double open = 0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto before = (k + n - 1) % n, next = (k + 1) % n, after = (k + 2) % n;
    const double jump = std::abs(y[after] - 3 * y[next] + 3 * y[k] - y[before]) / 2;
    open = std::max(open, jump / 2 * std::max(std::abs(moves[k]), std::abs(moves[next])));
  }
  return open;
}

/// What jumps of both forces between the steps leave open. along, down: moves of what is prescribed.
CycleBetweenSteps open_between_steps(const Motion& motion, const Eigen::VectorXd& along, const Eigen::VectorXd& down,
                                     const NormalHistory& normal, const FrictionHistory& friction) {
  const auto n = friction.force.size();
  CycleBetweenSteps open;
  if (!motion.tangential_force)
    open.tangential_force_mean =
        open_where_it_jumps(friction.force, Eigen::VectorXd::Constant(n, 1 / static_cast<double>(n)));
  open.tangential_work = open_where_it_jumps(motion.tangential_force ? friction.indenter : friction.force, along);
  const Eigen::VectorXd pressing = normal.force + normal.force_beyond;
  open.cycle_work =
      open.tangential_work + open_where_it_jumps(motion.normal_force ? normal.indentation : pressing, down);
  return open;
}

double path_to_and_fro(const Motion& motion, double amplitude) {
  return tangential_path(motion) / motion.tangential_amplitude() * amplitude;
}

/// Length of the tangential path of the indenter along a prescribed path; from samples where a force is prescribed.
double way_along(const Motion& motion, const FrictionHistory& friction) {
  if (!motion.tangential_force) return tangential_path(motion);
  const auto& u = friction.indenter;
  double way = std::abs(u[0] - (motion.is_single_pass() ? 0 : u[u.size() - 1]));
  for (Eigen::Index k = 1; k < u.size(); ++k) way += std::abs(u[k] - u[k - 1]);
  return way;
}

double normal_work_along(const Motion& motion, const NormalHistory& normal) {
  const auto& pieces = normal.pieces;
  const auto down = moves_along(motion.path->normal, *motion.path, pieces);
  const auto last = normal.force.size() - 1;
  const auto middle_of = [&](const Eigen::VectorXd& samples) {
    return in_the_middle(samples, motion.is_single_pass() ? 0 : samples[last], pieces);
  };
  const Eigen::VectorXd pressing = normal.force + normal.force_beyond;
  return motion.normal_force ? -middle_of(normal.indentation).dot(down) : middle_of(pressing).dot(down);
}

/// The response along a path, whose forces have kinks at its rows: works are sums of second order over the steps, with
/// the exact moves of what is prescribed, under a force by `oint F du = -oint u dF`. A single pass begins without
/// tangential force; in it the energy stored in the body cannot be told from what is lost there.
CycleResponse response_along(const RelaxationModel& relaxation, double friction_coefficient, const Motion& motion,
                             double normal_force_max, const NormalHistory& normal, const FrictionHistory& friction) {
  const auto& pieces = normal.pieces;
  const auto& path = *motion.path;
  const auto along = moves_along(path.tangential, path, pieces), down = moves_along(path.normal, path, pieces);
  const bool once = motion.is_single_pass();
  const auto last = friction.force.size() - 1;
  const auto middle_of = [&](const Eigen::VectorXd& samples) {
    return in_the_middle(samples, once ? 0 : samples[last], pieces);
  };
  const Eigen::VectorXd pull = middle_of(friction.force);
  const double tangential = motion.tangential_force ? -middle_of(friction.indenter).dot(along) : pull.dot(along),
               pressed = normal_work_along(motion, normal);
  CycleResponse response{};
  const auto largest = largest_tangential_force(friction_coefficient, motion, normal, friction);
  response.tangential_force_max = largest.value;
  for (Eigen::Index k = 0; k <= last; ++k)
    response.tangential_force_mean += pull[k] * pieces[static_cast<std::size_t>(k)].duration() / (2 * pi);
  response.friction_work = once || relaxation.has_memory() ? friction.dissipated_energy : tangential;
  response.bulk_work = !once && relaxation.has_memory() ? tangential + pressed - response.friction_work : 0;
  response.tangential_work = once ? 0 : tangential;
  response.sliding_force = friction_coefficient * normal_force_max;
  response.sliding_work = response.sliding_force * way_along(motion, friction);
  response.uncertainty = uncertainty_of(relaxation, motion, along, down, normal, friction);
  response.between_steps.tangential_force_max = largest.uncertainty;
  if (once) response.uncertainty.friction_work = friction.dissipated_uncertainty;
  response.off_by_steps = off_by_steps(relaxation, motion, friction);
  return response;
}

}  // namespace

double normal_work(const Motion& motion, const NormalHistory& normal) {
  if (motion.path) return normal_work_along(motion, normal);
  const auto down = moves(motion, normal_motion, normal.time[0], normal.force.size());
  return motion.normal_force ? -normal.indentation.dot(down) : (normal.force + normal.force_beyond).dot(down);
}

CycleResponse cycle_response(const RelaxationModel& relaxation, double friction_coefficient, const Motion& motion,
                             double normal_force_max, const NormalHistory& normal, const FrictionHistory& friction) {
  if (motion.path) return response_along(relaxation, friction_coefficient, motion, normal_force_max, normal, friction);
  const auto n = friction.force.size();
  const double dt = 2 * pi / normal.steps_per_cycle,
               begin = normal.first_balance + static_cast<double>(friction.n_steps - n) * dt;
  const auto along = moves(motion, tangential_motion, begin, n),
             down = moves(motion, normal_motion, normal.time[0], normal.force.size());
  const double tangential = motion.tangential_force ? -friction.indenter.dot(along) : friction.force.dot(along),
               pressing = normal_work(motion, normal);
  CycleResponse response{};
  const auto largest = largest_tangential_force(friction_coefficient, motion, normal, friction);
  response.tangential_force_max = largest.value;
  response.tangential_force_mean = friction.force.mean();
  response.friction_work = relaxation.has_memory() ? friction.dissipated_energy : tangential;
  response.bulk_work = relaxation.has_memory() ? tangential + pressing - response.friction_work : 0;
  response.tangential_work = tangential;
  response.sliding_force = friction_coefficient * normal_force_max;
  response.sliding_work = response.sliding_force * path_to_and_fro(motion, friction.amplitude);
  response.uncertainty = uncertainty_of(relaxation, motion, along, down, normal, friction);
  if (relaxation.has_memory()) response.between_steps = open_between_steps(motion, along, down, normal, friction);
  response.between_steps.tangential_force_max = largest.uncertainty;
  response.off_by_steps = off_by_steps(relaxation, motion, friction);
  return response;
}

}  // namespace fretval::fem
