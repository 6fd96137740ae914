#include "mdr/plane/plane_springs.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

/// Of the branches in a step.
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

/// Sums over a cycle, over 8/3 G0.
struct Sums {
  double friction = 0, along = 0, down = 0, mean_x = 0, largest_x = 0, largest_y = 0;
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
        now_(motion.rest) {}

  /// ramp: whether amplitudes rise from rest. Forces at the end of each step, a row each.
  Sums cycle(bool ramp, ArrayXXd& forces) {
    Sums sums;
    const auto n = motion_.n_steps();
    const double duration = motion_.time.back();
    forces.resize(static_cast<Index>(n), 2);
    for (std::size_t k = 1; k <= n; ++k) {
      const double share = motion_.time[k] / duration;
      const double e = ramp ? share * share * (3 - 2 * share) : 1;
      step(towards(motion_.positions[k], e), motion_.time[k] - motion_.time[k - 1], sums);
      forces(static_cast<Index>(k) - 1, 0) = force_[0];
      forces(static_cast<Index>(k) - 1, 1) = force_[1];
      sums.mean_x += force_[0] * (motion_.time[k] - motion_.time[k - 1]) / duration;
    }
    return sums;
  }

 private:
  static double largest_radius(const Profile& profile, const PlaneMotion& motion) {
    double deepest = 0;
    for (const auto& position : motion.positions) deepest = std::max(deepest, position.depth);
    return inverse_transform(profile, deepest);
  }

  /// From rest, by a share of the departure from it.
  [[nodiscard]] PlanePosition towards(const PlanePosition& position, double share) const {
    const auto& rest = motion_.rest;
    return {rest.depth + share * (position.depth - rest.depth), rest.x + share * (position.x - rest.x),
            rest.y + share * (position.y - rest.y)};
  }

  void step(const PlanePosition& to, double dt, Sums& sums) {
    if (!(std::abs(dt - dt_) <= 1e-12 * dt)) {
      dt_ = dt;
      branches_.emplace(body_, dt);
      normal_step_.emplace(body_, mu_, dt);
    }
    const auto& branches = *branches_;
    const double normal_before = 2 * (bed_.width * normal_.normal_load).sum();
    normal_step_->advance(normal_, bed_, {to.depth, (to.depth - now_.depth) / dt, 0, 0});
    const double normal_after = 2 * (bed_.width * normal_.normal_load).sum();
    const double moved[] = {to.x - now_.x, to.y - now_.y};
    Direction* directions[] = {&x_, &y_};
    ArrayXd before[2];
    for (int i = 0; i < 2; ++i) {
      auto& direction = *directions[i];
      before[i] = direction.load;
      direction.trial = load_at_rest(direction, branches) + branches.stiffness * moved[i];
    }
    const ArrayXd most = limit_ * normal_.normal_load, size = (x_.trial.square() + y_.trial.square()).sqrt();
    const ArrayXd kept = (size > most).select(most / size.max(1e-300), 1);
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
    }
    sums.down += (normal_before + normal_after) / 2 * (to.depth - now_.depth);
    sums.largest_x = std::max(sums.largest_x, std::abs(force_[0]));
    sums.largest_y = std::max(sums.largest_y, std::abs(force_[1]));
    now_ = to;
  }

  const PronyBody& body_;
  double limit_, mu_;
  const PlaneMotion& motion_;
  SpringBed bed_;
  SpringState normal_;
  Direction x_, y_;
  PlanePosition now_;
  double dt_ = 0;
  double force_[2] = {0, 0};
  std::optional<Branches> branches_;  // of the step that is made
  std::optional<SpringStep> normal_step_;
};

}  // namespace

PlaneResponse plane_response(const Profile& profile, const PronyBody& body, double mu, const PlaneMotion& motion,
                             Index n_springs, double periodicity) {
  validate(body);
  require_positive("coefficient of friction", mu);
  PlaneSprings springs(profile, body, mu, motion, n_springs);
  ArrayXXd forces, before;
  auto sums = springs.cycle(motion.repeats, forces);
  constexpr int most_cycles = 100;
  for (int cycle = 1; motion.repeats && cycle < most_cycles; ++cycle) {
    before.swap(forces);
    sums = springs.cycle(false, forces);
    if ((forces - before).abs().maxCoeff() <= periodicity * forces.abs().maxCoeff()) break;
  }
  const double stiffness = 8.0 / 3 * body.relaxed_modulus, normal = 4 * body.relaxed_modulus;
  return {stiffness * sums.largest_x, stiffness * sums.largest_y, stiffness * sums.mean_x,
          stiffness * sums.friction,  stiffness * sums.along,     normal * sums.down};
}

}  // namespace fretval::mdr
