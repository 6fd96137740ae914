#include "fem/stick_zone/cycle_response.h"

#include <algorithm>

#include "fem/history/running_minimum.h"
#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

using Prescribed = ValueAndRate (*)(const Motion&, double);

/// What is prescribed moves by so much around each of n instants of a period, begin, begin + dt, ...: y.dot(moves) is
/// `oint y dx`.
Eigen::VectorXd moves(const Motion& motion, Prescribed prescribed, double begin, Eigen::Index n) {
  const double dt = 2 * pi * motion.cycles_per_period() / static_cast<double>(n);
  Eigen::VectorXd moves(n);
  for (Eigen::Index k = 0; k < n; ++k) moves[k] = prescribed(motion, begin + static_cast<double>(k) * dt).rate * dt;
  return moves;
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
    uncertainty.cycle_work = friction.force_uncertainty.dot(along.cwiseAbs());
  }
  uncertainty.friction_work = relaxation.has_memory() ? friction.dissipated_uncertainty : uncertainty.cycle_work;
  if (!motion.normal_force)
    uncertainty.cycle_work += (normal.force_uncertainty + normal.force_beyond_uncertainty).dot(down.cwiseAbs());
  return uncertainty;
}

/// Four times the amplitudes of all oscillations, as often as they come in a cycle.
double path_to_and_fro(const Motion& motion, double amplitude) {
  double path = 0;
  for (const auto& oscillation : motion.tangential) path += 4 * oscillation.amplitude * oscillation.order;
  return path / motion.tangential_amplitude() * amplitude;
}

}  // namespace

CycleResponse cycle_response(const RelaxationModel& relaxation, double friction_coefficient, const Motion& motion,
                             double normal_force_max, const NormalHistory& normal, const FrictionHistory& friction) {
  const auto n = friction.force.size();
  const double dt = 2 * pi / normal.steps_per_cycle,
               begin = normal.first_balance + static_cast<double>(friction.n_steps - n) * dt;
  const auto along = moves(motion, tangential_motion, begin, n),
             down = moves(motion, normal_motion, normal.time[0], normal.force.size());
  const double tangential = motion.tangential_force ? -friction.indenter.dot(along) : friction.force.dot(along),
               pressing =
                   motion.normal_force ? -normal.indentation.dot(down) : (normal.force + normal.force_beyond).dot(down);
  CycleResponse response{};
  response.tangential_force_max = std::max(largest_of_period(friction.force), largest_of_period(-friction.force));
  response.tangential_force_mean = friction.force.mean();
  response.friction_work = relaxation.has_memory() ? friction.dissipated_energy : tangential;
  response.bulk_work = relaxation.has_memory() ? tangential + pressing - response.friction_work : 0;
  response.sliding_force = friction_coefficient * normal_force_max;
  response.sliding_work = response.sliding_force * path_to_and_fro(motion, friction.amplitude);
  response.uncertainty = uncertainty_of(relaxation, motion, along, down, normal, friction);
  return response;
}

}  // namespace fretval::fem
