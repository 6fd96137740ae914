#include "fem/full_contact/coupled_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
constexpr double rough_agreement = 1e-4;    // where an alternation begins, and from where the size of forces is known
/// Natural residual to which friction and pressures are solved while the remainder of the pair is this large: not
/// smaller than the next alternation can make use of.
double share_of(double remainder) {
  constexpr double share = 1e-2;
  return std::clamp(share * remainder, enough_of_contact, rough_agreement);
}
constexpr int most_alternations = 100, most_to_balance = 30;
constexpr std::size_t depth_of_mixing = 3, depth_to_balance = 5;

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
  return {{surface, grid, SurfaceField::tangential},
          {surface, grid, SurfaceField::normal},
          coupling ? CouplingOperator(surface, grid) : CouplingOperator()};
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
      state_{{}, MatrixXd::Zero(profile.size(), static_cast<Eigen::Index>(relaxation.moduli.size()))},
      expected_way_(friction.steps_per_cycle()) {
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
  friction.start_from(areas.cwiseInverse().asDiagonal() * operators_.coupling.along_surface(pressure) /
                      relaxation_.relaxed);
  require_room(pressure.rowwise().maxCoeff());
}

/// The numbers of a field and of displacements of the indenter behind each other, the latter as heavy as those of all
/// points.
class CoupledContact::Together {
 public:
  Together(const MatrixXd& field, Index n_displacements, const VectorXd& areas)
      : n_rows_(field.rows()),
        n_field_(field.size()),
        n_(n_displacements),
        weight_(areas.norm() * std::sqrt(static_cast<double>(field.cols()))) {}
  [[nodiscard]] VectorXd joined(const MatrixXd& field, const VectorXd& displacements) const {
    VectorXd both(n_field_ + n_);
    both << as_vector(field), weight_ * displacements;
    return both;
  }
  [[nodiscard]] MatrixXd field(const VectorXd& both) const { return as_field(both.head(n_field_), n_rows_); }
  [[nodiscard]] VectorXd displacements(const VectorXd& both) const { return both.tail(n_) / weight_; }

 private:
  Index n_rows_, n_field_, n_;
  double weight_;
};

CoupledContact::Attempt CoupledContact::attempt(const Start& start, const VectorXd& way) {
  const auto next = friction.next_step();
  const auto& relaxation = next.relaxation;
  const auto move = [&](double end) {
    if (motion_.depth_is_force) {
      const double share = (end - next.begin) / (next.end - next.begin);
      return steady_move(share * way[0], end - next.begin);
    }
    return move_in(motion_.depth, next.begin, end, next.inside());
  };
  Attempt made{move(next.end), (as_vector(start.pressed).array() > 0).cast<double>(), {}, {}, {}};
  made.left_behind = (1 - made.driven.array()) * made.whole.increment;
  made.before = state_.displacement + as_vector(profile) - VectorXd::Constant(profile.size(), depth);
  const VectorXd target = relaxation.response_without_slip(state_, move(next.balance), made.driven) +
                          relaxation.instantaneous() * (made.left_behind - made.before);
  made.target = operators_.normal.areas().asDiagonal() * as_field(target, profile.rows());
  return made;
}

/// Areas times the instantaneous stiffness in the next step.
VectorXd CoupledContact::stiffness_of_rings() {
  return operators_.normal.areas() * friction.next_step().relaxation.instantaneous();
}

/// Finds the pressures, from the last ones on, under a right-hand side.
void CoupledContact::press(const MatrixXd& pull, const PressureWear& wear, double enough) {
  if (wear.coefficient.size() == 0) {
    softness_.resize(0, 0);
    pressure = solve_pressure(operators_.normal, normal_inverse_, pull, pressure, enough).pressure;
    return;
  }
  const VectorXd stiff = stiffness_of_rings();
  const auto line = linearised(wear, pressure);
  softness_ = stiff.asDiagonal() * line.softness;
  pressure =
      solve_pressure(operators_.normal, softness_, pull - stiff.asDiagonal() * line.offset, pressure, enough).pressure;
}

/// Finds the tractions under the last pressures. Returns the larger natural residual of the two.
double CoupledContact::rub(const Attempt& made, const PressureWear& wear, const VectorXd& way, double enough) {
  ++n_alternations;
  const auto& rubbed =
      friction.attempt(pressure, operators_.coupling.along_surface(pressure), enough, way.tail(friction.n_forces()));
  moved_ = operators_.coupling.into_body(rubbed.traction);
  MatrixXd image;
  operators_.normal.apply(pressure, image);
  opened_ = image - made.target + moved_;
  if (wear.coefficient.size() > 0) opened_ += stiffness_of_rings().asDiagonal() * worn_field(wear, pressure);
  remainder = pressure_remainder(operators_.normal, softness_, pressure, opened_);
  return std::max(remainder, rubbed.remainder);
}

CoupledContact::Attempt CoupledContact::alternate(const Start& start, const VectorXd& way, double agreement) {
  double enough = share_of(1);
  AndersonMixing mixing(depth_of_mixing);
  auto made = attempt(start, way);
  MatrixXd moved = operators_.coupling.into_body(friction.expected_traction());
  for (int n = 0; n < most_alternations; ++n) {
    press(made.target - moved, start.wear, enough);
    const double left = rub(made, start.wear, way, enough);
    if (left <= agreement) return made;
    enough = share_of(left);
    moved = as_field(mixing.next(as_vector(moved), as_vector(moved_)), moved.rows());
  }
  throw SolverError(
      fmt::format("normal contact and friction do not come to terms: {:.1e} of the largest pressure is left after "
                  "{} alternations, {:.1e} is asked for; the friction coefficient may be too large for them to "
                  "have one solution",
                  remainder, most_alternations, agreement));
}

/// Alternates while the indenter moves towards the balance of its forces. Empty if that does not come to an end.
std::optional<CoupledContact::Attempt> CoupledContact::alternate_to_balance(const Start& start) {
  if (balance_.stiffness.size() == 0) return {};
  const VectorXd values = prescribed_forces();
  const auto stiffness = balance_.stiffness.partialPivLu();
  VectorXd way = balance_.displacements;
  MatrixXd moved = operators_.coupling.into_body(friction.expected_traction());
  const Together together(moved, way.size(), operators_.normal.areas());
  double enough = share_of(1);
  AndersonMixing mixing(depth_to_balance);
  for (int n = 0; n < most_to_balance; ++n) {
    const auto made = attempt(start, way);
    press(made.target - moved, start.wear, enough);
    const double left = rub(made, start.wear, way, enough);
    const VectorXd excess = attempted_forces() - values;
    const double unbalanced = excess.lpNorm<Eigen::Infinity>() / normal_force();
    if (left <= enough_agreement && unbalanced <= enough_of_force) {
      balance_.displacements = way;
      return made;
    }
    enough = share_of(std::max(left, unbalanced));
    const VectorXd next =
        mixing.next(together.joined(moved, way), together.joined(moved_, way - stiffness.solve(excess)));
    if (!next.allFinite()) break;
    moved = together.field(next);
    way = together.displacements(next);
  }
  return {};
}

CoupledContact::Attempt CoupledContact::balance_around(const Start& start) {
  const auto attempt_at = [&](const VectorXd& way, double agreement) {
    alternate(start, way, std::max(enough_agreement, agreement));
    return attempted_forces();
  };
  if (balance_.displacements.size() == 0) balance_.displacements = VectorXd::Zero(n_forces());
  attempt_at(balance_.displacements, rough_agreement);
  friction.require_grip();
  const VectorXd values = prescribed_forces();
  const double size = motion_.depth_is_force ? values[0] : normal_force();
  const auto forces_at = [&](const VectorXd& way, double within) { return attempt_at(way, within / size); };
  balance_ = displacements_for_forces(forces_at, values, balance_, probe_of_force, enough_of_force * size);
  return alternate(start, balance_.displacements, enough_agreement);
}

VectorXd CoupledContact::prescribed_forces() {
  VectorXd forces(n_forces());
  forces.tail(friction.n_forces()) = friction.prescribed_forces();
  const auto next = friction.next_step();
  if (motion_.depth_is_force) forces[0] = motion_.depth(next.balance, next.inside()).value;
  return forces;
}

VectorXd CoupledContact::attempted_forces() const {
  VectorXd forces(n_forces());
  forces.tail(friction.n_forces()) = friction.attempted_forces();
  if (motion_.depth_is_force) forces[0] = normal_force();
  return forces;
}

void CoupledContact::step(const PressureWear& wear) {
  const Start start{pressure, wear};
  n_alternations = 0;
  if (expected_pressure_.size() > 0) pressure = expected_pressure_.cwiseMax(0);
  auto made = n_forces() > 0 ? alternate_to_balance(start) : alternate(start, {}, enough_agreement);
  if (!made) made = balance_around(start);
  if (n_forces() > 0) balance_.displacements = expected_way_.next(balance_.displacements);
  const auto& [whole, driven, left_behind, before, target] = *made;
  const auto& relaxation = friction.next_step().relaxation;
  gap = stiffness_of_rings().cwiseInverse().asDiagonal() * opened_;
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
