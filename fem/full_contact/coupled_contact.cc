#include "fem/full_contact/coupled_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fem/contact/require_room.h"
#include "fem/full_contact/fields.h"
#include "fem/full_contact/normal_solver.h"
#include "fem/support/constants.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double enough_agreement = 1e-10;  // of the alternation
/// To which either side is solved while so much is left of both: no more than the next alternation can make use of.
double share_of(double remainder) {
  constexpr double share = 1e-2;
  return std::clamp(share * remainder, enough_of_contact, 1e-4);
}
constexpr int most_alternations = 100;

/// Largest |p - max(0, p - rho opened)| over the largest pressure.
double remainder_of(const SurfaceOperator& op, const MatrixXd& pressure, const MatrixXd& opened) {
  const MatrixXd led = pressure - op.diagonal().cwiseInverse().asDiagonal() * opened;
  const double left = (led.cwiseMax(0) - pressure).lpNorm<Eigen::Infinity>();
  return left == 0 ? 0 : left / std::max(left, pressure.maxCoeff());
}

}  // namespace

CoupledOperators coupled_operators(const SurfaceCompliance& surface, const AngularGrid& grid, bool coupling) {
  if (grid.mirrors == Mirrors::x_and_y)
    throw std::invalid_argument("a contact whose pressure and friction are coupled has no mirror across its motion");
  return {{surface, grid, Fields::tangential}, {surface, grid, Fields::normal}, {surface, grid, Fields::all, coupling}};
}

IndenterMotion indenter_motion(const Motion& motion) {
  return {[&motion](double t, double inside) { return normal_motion_inside(motion, t, inside); },
          lateral_motion(motion)};
}

CoupledContact::CoupledContact(const CoupledOperators& operators, const RelaxationModel& relaxation,
                               double friction_coefficient, MatrixXd profile, const IndenterMotion& motion,
                               StepTimes times)
    : friction(operators.tangential, relaxation, friction_coefficient, motion.lateral, std::move(times)),
      pressure(MatrixXd::Zero(profile.rows(), profile.cols())),
      operators_(operators),
      normal_inverse_(operators.normal, VectorXd::Zero(operators.normal.n_rings())),
      relaxation_(relaxation),
      profile_(std::move(profile)),
      motion_(motion),
      state_{{}, MatrixXd::Zero(profile_.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))} {
  press_without_friction();
}

void CoupledContact::press_without_friction() {
  const auto& areas = operators_.normal.areas();
  depth = motion_.depth(0, 0).value;
  const MatrixXd target = areas.asDiagonal() * (depth - profile_.array()).matrix();
  const auto pressed = solve_pressure(operators_.normal, normal_inverse_, target, pressure);
  pressure = relaxation_.relaxed * pressed.pressure;
  gap = areas.cwiseInverse().asDiagonal() * pressed.residual;
  state_.displacement = as_vector(((depth - profile_.array()) + gap.array()).matrix());
  friction.start_from(areas.cwiseInverse().asDiagonal() * moved_by_pressure() / relaxation_.relaxed);
  require_room(pressure.rowwise().maxCoeff());
}

/// Along the surface, times the areas.
MatrixXd CoupledContact::moved_by_pressure() const {
  MatrixXd fields = MatrixXd::Zero(pressure.rows(), 3 * pressure.cols()), moved;
  fields.rightCols(pressure.cols()) = pressure;
  operators_.all.apply(fields, moved);
  return moved.leftCols(2 * pressure.cols());
}

/// Into the body, times the areas.
MatrixXd CoupledContact::moved_by_traction(const MatrixXd& traction) const {
  MatrixXd fields = MatrixXd::Zero(pressure.rows(), 3 * pressure.cols()), moved;
  fields.leftCols(2 * pressure.cols()) = traction;
  operators_.all.apply(fields, moved);
  return moved.rightCols(pressure.cols());
}

void CoupledContact::alternate(const MatrixXd& target) {
  MatrixXd image;
  double enough = share_of(1);
  auto solution = solve_pressure(operators_.normal, normal_inverse_, target - moved_by_traction(friction.traction),
                                 pressure, enough);
  for (n_alternations = 1;; ++n_alternations) {
    pressure = solution.pressure;
    const auto& rubbed = friction.attempt(pressure, moved_by_pressure(), enough);
    const MatrixXd pull = target - moved_by_traction(rubbed.traction);
    operators_.normal.apply(pressure, image);
    opened_ = image - pull;
    remainder = remainder_of(operators_.normal, pressure, opened_);
    if (remainder <= enough_agreement && rubbed.remainder <= enough_agreement) return;
    if (n_alternations == most_alternations)
      throw SolverError(
          fmt::format("normal contact and friction do not come to terms: {:.1e} of the largest pressure is left after "
                      "{} alternations, {:.1e} is asked for; the friction coefficient may be too large for them to "
                      "have one solution",
                      remainder, n_alternations, enough_agreement));
    enough = share_of(remainder);
    solution = solve_pressure(operators_.normal, normal_inverse_, pull, pressure, enough);
  }
}

void CoupledContact::step() {
  const auto& areas = operators_.normal.areas();
  const auto next = friction.next_step();
  const auto& relaxation = next.relaxation;
  const auto whole = move_in(motion_.depth, next.begin, next.end, next.inside()),
             to_balance = move_in(motion_.depth, next.begin, next.balance, next.inside());
  const VectorXd driven = (as_vector(pressure).array() > 0).cast<double>(),
                 left_behind = (1 - driven.array()) * whole.increment;
  const VectorXd before = state_.displacement + as_vector(profile_) - VectorXd::Constant(profile_.size(), depth);
  const VectorXd target = relaxation.response_without_slip(state_, to_balance, driven) +
                          relaxation.instantaneous() * (left_behind - before);
  alternate(areas.asDiagonal() * as_field(target, pressure.rows()));
  gap = (areas * relaxation.instantaneous()).cwiseInverse().asDiagonal() * opened_;
  gap = (pressure.array() > 0).select(0, gap.cwiseMax(0));
  relaxation.advance(state_, whole, before - as_vector(gap) - left_behind, driven);
  depth += whole.increment;
  friction.accept();
  require_room(pressure.rowwise().maxCoeff());
}

double CoupledContact::normal_force() const {
  return (operators_.normal.areas().transpose() * pressure).sum();
}

}  // namespace fretval::fem
