#include "fem/full_contact/coupled_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fem/contact/force_balance.h"
#include "fem/contact/require_room.h"
#include "fem/full_contact/anderson_mixing.h"
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
/// Natural residual to which friction and pressures are solved while the remainder of the pair is this large: not
/// smaller than the next alternation can make use of.
double share_of(double remainder) {
  constexpr double share = 1e-2;
  return std::clamp(share * remainder, enough_of_contact, 1e-4);
}
constexpr int most_alternations = 100;
constexpr std::size_t depth_of_mixing = 3;

/// Wear as a linear function of the pressure around a given one, softness times pressure plus offset: the tangent of
/// the law of wear or, with an exponent below 1, where tangents overshoot, its secant from 0.
struct LinearWear {
  MatrixXd softness, offset;
};

LinearWear linearised(const PressureWear& wear, const MatrixXd& pressure) {
  const auto coefficient = as_field(wear.coefficient, pressure.rows());
  const double m = wear.exponent;
  const MatrixXd per_pressure =
      m < 1 ? MatrixXd((pressure.array() > 0).select(pressure.array().pow(m - 1), 0)) : pressure.array().pow(m - 1);
  const MatrixXd secant = coefficient.cwiseProduct(per_pressure);
  const double slope = std::max(m, 1.0);
  return {slope * secant, (1 - slope) * secant.cwiseProduct(pressure)};
}

MatrixXd worn_field(const PressureWear& wear, const MatrixXd& pressure) {
  return as_field(worn_by(wear, as_vector(pressure)), pressure.rows());
}

}  // namespace

CoupledOperators coupled_operators(const SurfaceCompliance& surface, const AngularGrid& grid, bool coupling) {
  if (grid.mirrors == Mirrors::x_and_y)
    throw std::invalid_argument("a contact whose pressure and friction are coupled has no mirror across its motion");
  return {{surface, grid, Fields::tangential}, {surface, grid, Fields::normal}, {surface, grid, Fields::all, coupling}};
}

IndenterMotion indenter_motion(const Motion& motion) {
  return {[&motion](double t, double inside) { return normal_motion_inside(motion, t, inside); },
          lateral_motion(motion), motion.normal_force};
}

CoupledContact::CoupledContact(const CoupledOperators& operators, const RelaxationModel& relaxation,
                               double friction_coefficient, MatrixXd shape, const IndenterMotion& motion,
                               StepTimes times)
    : profile(std::move(shape)),
      friction(operators.tangential, relaxation, friction_coefficient, motion.lateral, std::move(times)),
      pressure(MatrixXd::Zero(profile.rows(), profile.cols())),
      operators_(operators),
      normal_inverse_(operators.normal, VectorXd::Zero(operators.normal.n_rings())),
      relaxation_(relaxation),
      motion_(motion),
      course_(friction.steps_per_cycle()),
      state_{{}, MatrixXd::Zero(profile.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))} {
  press_without_friction();
}

void CoupledContact::press_without_friction() {
  const auto& areas = operators_.normal.areas();
  const auto press = [&](double down) {
    const MatrixXd target = areas.asDiagonal() * (down - profile.array()).matrix();
    auto pressed = solve_pressure(operators_.normal, normal_inverse_, target, pressure);
    pressure = pressed.pressure;
    return pressed.residual;
  };
  const double start = motion_.depth(0, 0).value;
  depth = start;
  if (motion_.depth_is_force) {
    const auto force_at = [&](double down) {
      press(down);
      return normal_force();
    };
    const double force = start / relaxation_.relaxed, guess = profile.maxCoeff() / 2;
    depth = displacement_for_force(force_at, force, {guess, force_at(guess) / guess, force});
  }
  const MatrixXd residual = press(depth);
  pressure *= relaxation_.relaxed;
  gap = areas.cwiseInverse().asDiagonal() * residual;
  state_.displacement = as_vector(((depth - profile.array()) + gap.array()).matrix());
  friction.start_from(areas.cwiseInverse().asDiagonal() * moved_by_pressure() / relaxation_.relaxed);
  require_room(pressure.rowwise().maxCoeff());
}

/// Displacements along the surface by the pressures, times the areas (n_rings x 2 n_angles).
MatrixXd CoupledContact::moved_by_pressure() const {
  MatrixXd fields = MatrixXd::Zero(pressure.rows(), 3 * pressure.cols()), moved;
  fields.rightCols(pressure.cols()) = pressure;
  operators_.all.apply(fields, moved);
  return moved.leftCols(2 * pressure.cols());
}

/// Displacements into the body by tractions, times the areas (n_rings x n_angles).
MatrixXd CoupledContact::moved_by_traction(const MatrixXd& traction) const {
  MatrixXd fields = MatrixXd::Zero(pressure.rows(), 3 * pressure.cols()), moved;
  fields.leftCols(2 * pressure.cols()) = traction;
  operators_.all.apply(fields, moved);
  return moved.rightCols(pressure.cols());
}

void CoupledContact::alternate(const MatrixXd& target, const PressureWear& wear, const VectorXd& along) {
  const VectorXd stiff = operators_.normal.areas() * friction.next_step().relaxation.instantaneous();
  const bool wears = wear.coefficient.size() > 0;
  double enough = share_of(1);
  MatrixXd image, softness;
  const auto press = [&](const MatrixXd& pull) {
    if (!wears) return solve_pressure(operators_.normal, normal_inverse_, pull, pressure, enough).pressure;
    const auto line = linearised(wear, pressure);
    softness = stiff.asDiagonal() * line.softness;
    return solve_pressure(operators_.normal, softness, pull - stiff.asDiagonal() * line.offset, pressure, enough)
        .pressure;
  };
  AndersonMixing mixing(depth_of_mixing);
  MatrixXd moved = moved_by_traction(friction.expected_traction());
  pressure = press(target - moved);
  for (n_alternations = 1;; ++n_alternations) {
    const auto& rubbed = friction.attempt(pressure, moved_by_pressure(), enough, along);
    const MatrixXd moved_now = moved_by_traction(rubbed.traction);
    operators_.normal.apply(pressure, image);
    opened_ = image - target + moved_now;
    if (wears) opened_ += stiff.asDiagonal() * worn_field(wear, pressure);
    remainder = pressure_remainder(operators_.normal, softness, pressure, opened_);
    if (remainder <= enough_agreement && rubbed.remainder <= enough_agreement) return;
    if (n_alternations == most_alternations)
      throw SolverError(
          fmt::format("normal contact and friction do not come to terms: {:.1e} of the largest pressure is left after "
                      "{} alternations, {:.1e} is asked for; the friction coefficient may be too large for them to "
                      "have one solution",
                      remainder, n_alternations, enough_agreement));
    enough = share_of(remainder);
    moved = as_field(mixing.next(as_vector(moved), as_vector(moved_now)), moved.rows());
    pressure = press(target - moved);
  }
}

CoupledContact::Attempt CoupledContact::attempt(const MatrixXd& pressed, const PressureWear& wear, const Way& way) {
  const auto next = friction.next_step();
  const auto& relaxation = next.relaxation;
  const auto move = [&](double end) {
    if (motion_.depth_is_force) {
      const double share = (end - next.begin) / (next.end - next.begin);
      return steady_move(share * way.down, end - next.begin);
    }
    return move_in(motion_.depth, next.begin, end, next.inside());
  };
  Attempt made{move(next.end), (as_vector(pressed).array() > 0).cast<double>(), {}, {}};
  made.left_behind = (1 - made.driven.array()) * made.whole.increment;
  made.before = state_.displacement + as_vector(profile) - VectorXd::Constant(profile.size(), depth);
  const VectorXd target = relaxation.response_without_slip(state_, move(next.balance), made.driven) +
                          relaxation.instantaneous() * (made.left_behind - made.before);
  alternate(operators_.normal.areas().asDiagonal() * as_field(target, pressed.rows()), wear, way.along);
  return made;
}

CoupledContact::Way CoupledContact::way_of_forces(const MatrixXd& pressed, const PressureWear& wear) {
  const Index down = motion_.depth_is_force ? 1 : 0, along = friction.n_forces(), n = down + along;
  if (n == 0) return {};
  const auto way_of = [=](const VectorXd& by) { return Way{down > 0 ? by[0] : 0, by.tail(along)}; };
  const auto forces_at = [&](const VectorXd& by) {
    attempt(pressed, wear, way_of(by));
    VectorXd forces(n);
    forces.tail(along) = friction.attempted_forces();
    if (down > 0) forces[0] = normal_force();
    return forces;
  };
  if (balance_.displacements.size() == 0) balance_.displacements = VectorXd::Zero(n);
  forces_at(balance_.displacements);
  VectorXd values(n);
  values.tail(along) = friction.prescribed_forces();
  const auto next = friction.next_step();
  if (down > 0) values[0] = motion_.depth(next.balance, next.inside()).value;
  balance_ = displacements_for_forces(forces_at, values, balance_, probe_of_force, enough_of_force * normal_force());
  return way_of(balance_.displacements);
}

void CoupledContact::step(const PressureWear& wear) {
  const auto& areas = operators_.normal.areas();
  const MatrixXd pressed = pressure;
  if (expected_pressure_.size() > 0) pressure = expected_pressure_.cwiseMax(0);
  const auto [whole, driven, left_behind, before] = attempt(pressed, wear, way_of_forces(pressed, wear));
  const auto& relaxation = friction.next_step().relaxation;
  gap = (areas * relaxation.instantaneous()).cwiseInverse().asDiagonal() * opened_;
  gap = (pressure.array() > 0).select(0, gap.cwiseMax(0));
  VectorXd slip = before - as_vector(gap) - left_behind;
  if (wear.coefficient.size() > 0) {
    const MatrixXd worn = worn_field(wear, pressure);
    slip += as_vector(worn);
    profile += worn;
  }
  relaxation.advance(state_, whole, slip, driven);
  depth += whole.increment;
  friction.accept();
  expected_pressure_ = course_.next(pressure);
  require_room(pressure.rowwise().maxCoeff());
}

MatrixXd CoupledContact::pull() const {
  MatrixXd image;
  operators_.normal.apply(pressure, image);
  return image - opened_;
}

double CoupledContact::normal_force() const {
  return (operators_.normal.areas().transpose() * pressure).sum();
}

}  // namespace fretval::fem
