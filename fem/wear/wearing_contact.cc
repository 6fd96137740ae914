#include "fem/wear/wearing_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "fem/history/friction_history.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

WearingContact::WearingContact(std::unique_ptr<RubbingContact> contact, const WearLaw& law)
    : contact_(std::move(contact)), law_(law) {}

WearingContact::WearingContact(const WearingContact& other)
    : contact_(other.contact_->clone()), law_(other.law_), period_(other.period_) {}

WearingContact& WearingContact::operator=(WearingContact other) {
  std::swap(contact_, other.contact_);
  std::swap(law_, other.law_);
  std::swap(period_, other.period_);
  return *this;
}

void WearingContact::start() {
  for (int cycle = 0; cycle < contact_->motion().cycles_of_ramp(); ++cycle)
    for (int k = 0; k < contact_->steps_per_cycle(); ++k) contact_->step({});
  run_period(0);
}

char WearingContact::Period::zone(Eigen::Index point, Eigen::Index step) const {
  if (pressure(point, step) == 0) return 'o';
  const double way = slip(point, step);
  return way == 0 ? 's' : way > 0 ? 'f' : 'b';
}

/// Length of slip that belongs to the pressure of each step: slips are made in whole steps, whose middle lies between
/// two balance times.
Eigen::MatrixXd WearingContact::slip_at_balances() const {
  const double later = contact_->fraction() - 0.5;
  const auto n_steps = period_.slip.cols();
  Eigen::MatrixXd slip = period_.slip.cwiseAbs();
  const Eigen::VectorXd first = slip.col(0);
  for (Eigen::Index k = 0; k < n_steps; ++k)
    slip.col(k) = (1 - later) * slip.col(k) + later * (k + 1 < n_steps ? slip.col(k + 1) : first);
  return slip;
}

void WearingContact::run_period(double n_cycles) {
  const Eigen::Index n = contact_->areas().size(), n_steps = period_steps();
  const double per_cycle = 1.0 / contact_->motion().cycles_per_period();
  const Eigen::MatrixXd wearing = n_cycles > 0 ? slip_at_balances() : Eigen::MatrixXd();
  Period now;
  now.slip.resize(n, n_steps);
  now.pressure.resize(n, n_steps);
  now.traction.resize(n, n_steps);
  Eigen::Vector2d least = contact_->displacement(), most = least;
  for (Eigen::Index k = 0; k < n_steps; ++k) {
    now.slip.col(k) = contact_->step(
        n_cycles > 0 ? PressureWear{(n_cycles * per_cycle * law_.coefficient) * wearing.col(k), law_.exponent}
                     : PressureWear{});
    now.largest_indentation = std::max(now.largest_indentation, contact_->indentation());
    least = least.cwiseMin(contact_->displacement());
    most = most.cwiseMax(contact_->displacement());
    now.pressure.col(k) = contact_->pressure();
    now.traction.col(k) = contact_->traction();
    now.friction_work += per_cycle * contact_->friction_work();
  }
  now.tangential_amplitude = (most - least).maxCoeff() / 2;
  now.largest_pressure = now.pressure.rowwise().maxCoeff();
  now.path = now.slip.cwiseAbs().rowwise().sum();
  period_ = std::move(now);
  const Eigen::MatrixXd slip = slip_at_balances();
  period_.rate = Eigen::VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < n_steps; ++k)
    period_.rate += per_cycle * worn_by({law_.coefficient * slip.col(k), law_.exponent}, period_.pressure.col(k));
}

bool WearingContact::slip_repeats(const Eigen::VectorXd& path_before) const {
  constexpr double repeats = 1e-2;  // of the point's own slip
  const double stuck = slip_of_stuck_ring(contact_->motion(), period_.tangential_amplitude);
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
  constexpr double roundoff = 1e-9, dying = 1e-3;  // of the longest path; of the point's own, in a period
  const double creep = slip_of_stuck_ring(contact_->motion(), period_.tangential_amplitude),
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
