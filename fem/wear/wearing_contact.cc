#include "fem/wear/wearing_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "fem/history/friction_history.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

WearingContact::WearingContact(const ContactProblem& normal, const ContactProblem& tangential,
                               const RelaxationModel& relaxation, const Motion& motion, int steps_per_cycle,
                               const WornProfile& profile, double friction_coefficient, const WearLaw& law)
    : normal_(normal, relaxation, profile.unworn + profile.worn, motion, steps_per_cycle, ForceReading::sum_of_rings),
      friction_(tangential, relaxation, friction_coefficient, motion, steps_per_cycle),
      law_(law),
      unworn_(profile.unworn) {}

void WearingContact::start() {
  for (int cycle = 0; cycle < normal_.motion().cycles_of_ramp(); ++cycle)
    for (int k = 0; k < normal_.steps_per_cycle(); ++k) {
      normal_.step();
      friction_.step(normal_.pressure);
    }
  run_period(0);
}

char WearingContact::Period::zone(Eigen::Index ring, Eigen::Index step) const {
  if (pressure(ring, step) == 0) return 'o';
  const double way = slip(ring, step);
  return way == 0 ? 's' : way > 0 ? 'f' : 'b';
}

void WearingContact::run_period(double n_cycles) {
  const Eigen::Index n = normal_.profile.size(), n_steps = period_steps();
  const double per_cycle = 1.0 / normal_.motion().cycles_per_period();
  Period now;
  now.slip.resize(n, n_steps);
  now.pressure.resize(n, n_steps);
  now.rate = Eigen::VectorXd::Zero(n);
  double least = friction_.displacement, most = least;
  for (Eigen::Index k = 0; k < n_steps; ++k) {
    if (n_cycles > 0)
      normal_.step({(n_cycles * per_cycle * law_.coefficient) * period_.slip.col(k).cwiseAbs(), law_.exponent});
    else
      normal_.step();
    friction_.step(normal_.pressure);
    now.largest_indentation = std::max(now.largest_indentation, normal_.indentation);
    least = std::min(least, friction_.displacement);
    most = std::max(most, friction_.displacement);
    now.slip.col(k) = friction_.slip;
    now.pressure.col(k) = normal_.pressure;
    now.rate += per_cycle * worn_by({law_.coefficient * friction_.slip.cwiseAbs(), law_.exponent}, normal_.pressure);
    now.friction_work +=
        per_cycle * friction_.traction.cwiseProduct(friction_.slip).dot(normal_.problem().compliance.areas);
  }
  now.tangential_amplitude = (most - least) / 2;
  now.largest_pressure = now.pressure.rowwise().maxCoeff();
  now.path = now.slip.cwiseAbs().rowwise().sum();
  period_ = std::move(now);
}

bool WearingContact::slip_repeats(const Eigen::VectorXd& path_before) const {
  constexpr double repeats = 1e-2;  // of the ring's own slip
  const double stuck = slip_of_stuck_ring(normal_.motion(), period_.tangential_amplitude);
  for (Eigen::Index i = 0; i < path_before.size(); ++i)
    if (period_.path[i] > stuck && std::abs(period_.path[i] - path_before[i]) > repeats * period_.path[i]) return false;
  return true;
}

void WearingContact::settle() {
  constexpr int most_periods = 400;
  for (int n = 0; n < most_periods; ++n) {
    const Eigen::VectorXd before = period_.path;
    run_period(0);
    if (!slip_repeats(before)) continue;
    return take_dying_slip_for_stick(before);
  }
  throw SolverError(fmt::format("slip still changes after {} periods on the same profile", most_periods));
}

void WearingContact::take_dying_slip_for_stick(const Eigen::VectorXd& path_before) {
  constexpr double roundoff = 1e-9, dying = 1e-3;  // of the longest path; of the ring's own, in a period
  const double creep = slip_of_stuck_ring(normal_.motion(), period_.tangential_amplitude),
               nothing = roundoff * period_.path.maxCoeff();
  for (Eigen::Index i = 0; i < period_.path.size(); ++i) {
    const double path = period_.path[i];
    if (path > nothing && (path > creep || path > (1 - dying) * path_before[i])) continue;
    period_.slip.row(i).setZero();
    period_.path[i] = period_.rate[i] = 0;
  }
}

void WearingContact::wear_off(double n_cycles) {
  run_period(n_cycles);
}

}  // namespace fretval::fem
