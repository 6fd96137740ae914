#include "mdr/plane/plane_springs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mdr/plane/plane_balance.h"
#include "mdr/springs/spring_step.h"
#include "mdr/support/checks.h"

namespace fretval::mdr {
namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::Index;

/// One tangential direction of all springs: forces over 8/3 G0 per length, m.
struct Direction {
  ArrayXd load, trial, slip, position;  // slip in a step; position of the tips
  ArrayXXd memory;                      // of the branches

  Direction(Index n_springs, Index n_branches)
      : load(ArrayXd::Zero(n_springs)),
        trial(load),
        slip(load),
        position(load),
        memory(ArrayXXd::Zero(n_springs, n_branches)) {}
};

/// What the branches do in a step.
struct Branches {
  Eigen::VectorXd decay, gain;
  double stiffness;  // of all in a step, the relaxed spring and the dashpot among them
  double viscous;    // of the dashpot alone

  Branches(const PronyBody& body, double dt)
      : decay(static_cast<Index>(body.branch_times.size())), gain(decay.size()), stiffness(0), viscous(0) {
    for (Index i = 0; i < decay.size(); ++i) {
      const auto branch = static_cast<std::size_t>(i);
      decay[i] = std::exp(-dt / body.branch_times[branch]);
      gain[i] = branch_gain(body, branch, dt);
    }
    viscous = body.viscosity / body.relaxed_modulus / dt;
    stiffness = 1 + gain.sum() + viscous;
  }
};

/// Load of a spring whose tip stays where it is.
ArrayXd load_at_rest(const Direction& direction, const Branches& branches) {
  return direction.position + (direction.memory.matrix() * branches.decay).array();
}

void move_tips(const ArrayXd& by, const Branches& branches, Direction& direction) {
  direction.position += by;
  for (Index i = 0; i < branches.decay.size(); ++i)
    direction.memory.col(i) = branches.decay[i] * direction.memory.col(i) + branches.gain[i] * by;
}

/// An element of depth 0 that neither slips nor lifts.
class Stuck {
 public:
  Stuck(double depth, double mu, Index n_branches)
      : scale_(2 / (3 * mu)), x_(1, n_branches), y_(1, n_branches), down_(1, n_branches) {
    down_.position = depth;
  }
  void move(double down, const Eigen::Vector2d& along, const Branches& branches) {
    const auto bear = [&](double by, Direction& direction) {
      direction.load = load_at_rest(direction, branches) + branches.stiffness * by;
      move_tips(ArrayXd::Constant(1, by), branches, direction);
    };
    bear(down, down_);
    bear(along[0], x_);
    bear(along[1], y_);
  }
  /// Forces of the element in the units of StuckElement, m.
  [[nodiscard]] double x() const { return scale_ * x_.load[0]; }
  [[nodiscard]] double y() const { return scale_ * y_.load[0]; }
  [[nodiscard]] double normal() const { return down_.load[0]; }

 private:
  double scale_;
  Direction x_, y_, down_;
};

/// Values at the ends of the steps of a cycle: force along the surface over 8/3 G0 and displacement (steps x 2), and
/// the forces of an element of depth 0 that sticks.
struct Course {
  ArrayXXd force, displacement;
  StuckElement stuck;

  explicit Course(Index n) : force(n, 2), displacement(n, 2), stuck{ArrayXd(n), ArrayXd(n), ArrayXd(n)} {}
};

/// Works (of friction, along the surface, into it), mean force and path of a cycle, with forces over the stiffness of
/// the springs per length.
struct Sums {
  double friction = 0, along = 0, down = 0, mean_x = 0, way = 0;
};

class PlaneSprings {
 public:
  PlaneSprings(const Profile& profile, const PronyBody& body, double mu, const PlaneMotion& motion, Index n_springs)
      : body_(body),
        limit_(1.5 * mu),
        mu_(mu),
        motion_(motion),
        bed_(spring_bed(profile, largest_radius(profile, motion), n_springs)),
        normal_(relaxed_state(bed_, body, motion.rest.depth)),
        x_(n_springs, static_cast<Index>(body.branch_moduli.size())),
        y_(x_),
        stuck_(motion.rest.depth, mu, static_cast<Index>(body.branch_moduli.size())),
        first_slip_(motion.rest.depth),
        depth_(motion.rest.depth),
        position_{motion.by_force ? 0 : motion.rest.x, motion.by_force ? 0 : motion.rest.y} {}

  /// ramp: whether amplitudes rise from rest.
  Sums cycle(bool ramp, Course& course) {
    Sums sums;
    const double duration = motion_.time.back();
    for (std::size_t k = 1; k <= motion_.n_steps(); ++k) {
      const double share = motion_.time[k] / duration, dt = motion_.time[k] - motion_.time[k - 1];
      amplitude_ = ramp ? share * share * (3 - 2 * share) : 1;
      time_ = motion_.time[k];
      step(towards(motion_.positions[k], amplitude_), dt, sums);
      const auto row = static_cast<Index>(k) - 1;
      course.force.row(row) << force_[0], force_[1];
      course.displacement.row(row) << position_[0], position_[1];
      course.stuck.x[row] = stuck_.x();
      course.stuck.y[row] = stuck_.y();
      course.stuck.normal[row] = stuck_.normal();
      sums.mean_x += force_[0] * dt / duration;
    }
    return sums;
  }

  /// Depth up to which no element has slipped since rest.
  [[nodiscard]] double first_slip() const { return first_slip_; }

 private:
  static double largest_radius(const Profile& profile, const PlaneMotion& motion) {
    double deepest = 0;
    for (const auto& position : motion.positions) deepest = std::max(deepest, position.depth);
    return inverse_transform(profile, deepest);
  }

  /// The position that departs from rest by a share of the prescribed departure.
  [[nodiscard]] PlanePosition towards(const PlanePosition& position, double share) const {
    const auto& rest = motion_.rest;
    return {rest.depth + share * (position.depth - rest.depth), rest.x + share * (position.x - rest.x),
            rest.y + share * (position.y - rest.y)};
  }

  /// How far the indenter goes along the surface.
  [[nodiscard]] Eigen::Vector2d way_to(const PlanePosition& to, const ArrayXd& most) const {
    if (!motion_.by_force) return {to.x - position_[0], to.y - position_[1]};
    const Eigen::Vector2d sum = Eigen::Vector2d(to.x, to.y) / (2 * 8.0 / 3 * body_.relaxed_modulus);
    const double borne = (bed_.width * most).sum();
    if (!(sum.norm() < borne)) {
      GrossSlip slip("the whole contact slides under the prescribed tangential force");
      slip.time = time_;
      slip.amplitude = amplitude_;
      slip.excess = sum.norm() - borne;
      throw slip;
    }
    return way_for_forces(
        sum, {bed_.width, load_at_rest(x_, *branches_), load_at_rest(y_, *branches_), most, branches_->stiffness});
  }

  void step(const PlanePosition& to, double dt, Sums& sums) {
    if (!(std::abs(dt - dt_) <= 1e-12 * dt)) {
      dt_ = dt;
      branches_.emplace(body_, dt);
      normal_step_.emplace(body_, mu_, dt);
    }
    const auto& branches = *branches_;
    const double normal_before = 2 * (bed_.width * normal_.normal_load).sum(), down = to.depth - depth_;
    normal_step_->advance(normal_, bed_, {to.depth, down / dt, 0, 0});
    const double normal_after = 2 * (bed_.width * normal_.normal_load).sum();
    const ArrayXd most = limit_ * normal_.normal_load;
    const auto moved = way_to(to, most);
    Direction* directions[] = {&x_, &y_};
    ArrayXd before[2];
    for (int i = 0; i < 2; ++i) {
      auto& direction = *directions[i];
      before[i] = direction.load;
      direction.trial = load_at_rest(direction, branches) + branches.stiffness * moved[i];
    }
    const ArrayXd kept = shares_within(most, x_.trial, y_.trial);
    for (int i = 0; i < 2; ++i) {
      auto& direction = *directions[i];
      direction.slip = (1 - kept) * direction.trial / branches.stiffness;
      direction.load = kept * direction.trial;
      move_tips(moved[i] - direction.slip, branches, direction);
      const ArrayXd middle = (before[i] + direction.load) / 2;
      sums.friction += 2 * (bed_.width * middle * direction.slip).sum();
      const double force = 2 * (bed_.width * direction.load).sum();
      sums.along += (force_[i] + force) / 2 * moved[i];
      force_[i] = force;
      position_[i] += moved[i];
    }
    stuck_.move(down, moved, branches);
    first_slip_ = std::min(first_slip_, stuck_.normal() - std::hypot(stuck_.x(), stuck_.y()));
    sums.down += (normal_before + normal_after) / 2 * down;
    sums.way += moved.norm();
    depth_ = to.depth;
  }

  const PronyBody& body_;
  double limit_, mu_;
  const PlaneMotion& motion_;
  SpringBed bed_;
  SpringState normal_;
  Direction x_, y_;
  Stuck stuck_;
  double first_slip_;
  double depth_, position_[2];  // of the indenter
  double amplitude_ = 1, time_ = 0, dt_ = 0;
  double force_[2] = {0, 0};
  std::optional<Branches> branches_;  // of the step that is made
  std::optional<SpringStep> normal_step_;
};

double half_range(const ArrayXd& values) {
  return (values.maxCoeff() - values.minCoeff()) / 2;
}

}  // namespace

PlaneResponse plane_response(const Profile& profile, const PronyBody& body, double mu, const PlaneMotion& motion,
                             Index n_springs, double periodicity) {
  validate(body);
  require_positive("coefficient of friction", mu);
  PlaneSprings springs(profile, body, mu, motion, n_springs);
  Course course(static_cast<Index>(motion.n_steps()));
  auto sums = springs.cycle(motion.repeats, course);
  const auto& followed = motion.by_force ? course.displacement : course.force;
  constexpr int most_cycles = 100;
  for (int cycle = 1; motion.repeats && cycle < most_cycles; ++cycle) {
    const Course before = course;
    sums = springs.cycle(false, course);
    const auto& last = motion.by_force ? before.displacement : before.force;
    if ((followed - last).abs().maxCoeff() <= periodicity * followed.abs().maxCoeff()) break;
  }
  const double stiffness = 8.0 / 3 * body.relaxed_modulus, normal = 4 * body.relaxed_modulus;
  return {stiffness * course.force.col(0).abs().maxCoeff(),
          stiffness * course.force.col(1).abs().maxCoeff(),
          stiffness * sums.mean_x,
          stiffness * sums.friction,
          stiffness * sums.along,
          normal * sums.down,
          sums.way,
          half_range(course.displacement.col(0)),
          {springs.first_slip(), std::max(springs.first_slip(), plane_stick_depths(course.stuck).shakedown)}};
}

PathForces forces_of(const PlaneResponse& response, const PronyBody& body, const PlaneMotion& motion) {
  PathForces forces{};
  for (const auto& position : motion.positions)
    forces.largest_indentation = std::max(forces.largest_indentation, position.depth);
  forces.tangential_force_max = response.force_x_max;
  forces.tangential_force_mean = response.force_x_mean;
  forces.friction_work = response.friction_work;
  forces.tangential_amplitude = response.x_amplitude;
  forces.tangential_way = response.way;
  forces.first_slip = response.depths.first_slip;
  forces.shakedown = response.depths.shakedown;
  if (!motion.repeats) return forces;
  forces.tangential_work = response.tangential_work;
  if (!body.branch_moduli.empty() || body.viscosity != 0)
    forces.bulk_work = std::max(0.0, response.tangential_work + response.normal_work - response.friction_work);
  return forces;
}

}  // namespace fretval::mdr
