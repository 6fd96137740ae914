#include "comparison/reference/plane_answer.h"

#include <algorithm>
#include <cmath>

#include "mdr/plane/plane_springs.h"
#include "mdr/plane/plane_stick.h"
#include "mdr/rheology/rheology.h"
#include "mdr/support/constants.h"

namespace fretval {
namespace {

mdr::PlanePosition position_at(const mdr::HarmonicMotion& motion, double t) {
  mdr::PlanePosition position{motion.indentation, 0, 0};
  const auto value = [t](const mdr::Harmonic& h) {
    return h.amplitude * std::cos(mdr::angular_frequency(h.frequency) * t + h.phase);
  };
  for (const auto& harmonic : motion.normal) position.depth += value(harmonic);
  for (const auto& harmonic : motion.tangential) (harmonic.across ? position.y : position.x) += value(harmonic);
  return position;
}

mdr::PlaneMotion in_steps(const mdr::HarmonicMotion& motion, int steps_per_oscillation) {
  const auto cycle = mdr::common_cycle(motion).value();
  const int n = steps_per_oscillation * cycle.highest_order();
  mdr::PlaneMotion steps{{motion.indentation, 0, 0}, {}, {}, true};
  for (int k = 0; k <= n; ++k) {
    steps.time.push_back(k / (n * cycle.frequency));
    steps.positions.push_back(position_at(motion, steps.time.back()));
  }
  return steps;
}

/// As many steps to each piece.
mdr::PlaneMotion in_steps(const mdr::SampledPath& path, int steps) {
  const auto rest = mdr::rest_of(path);
  const auto at = [&](std::size_t row) {
    return mdr::PlanePosition{path.normal[row], path.tangential[row], path.transverse[row]};
  };
  mdr::PlaneMotion motion{{rest.normal, rest.tangential, rest.transverse}, {0}, {at(0)}, path.repeats};
  const int n = std::max(1, steps / static_cast<int>(path.n_pieces()));
  for (std::size_t row = 0; row < path.n_pieces(); ++row) {
    const auto from = at(row), to = at(row + 1);
    for (int j = 1; j <= n; ++j) {
      const double share = static_cast<double>(j) / n;
      motion.time.push_back(path.time[row] - path.time.front() + share * (path.time[row + 1] - path.time[row]));
      motion.positions.push_back({from.depth + share * (to.depth - from.depth), from.x + share * (to.x - from.x),
                                  from.y + share * (to.y - from.y)});
    }
  }
  return motion;
}

double way_of(const mdr::PlaneMotion& motion) {
  double way = 0;
  for (std::size_t k = 1; k < motion.positions.size(); ++k)
    way += std::hypot(motion.positions[k].x - motion.positions[k - 1].x,
                      motion.positions[k].y - motion.positions[k - 1].y);
  return way;
}

mdr::StickDepths depths_of(const MdrCase& mdr) {
  constexpr int instants_per_oscillation = 4096;
  const double mu = mdr.friction_coefficient;
  if (!mdr.path)
    return mdr::plane_stick_depths(
        mdr::stuck_element(mdr::Rheology(mdr.body), mu, mdr.motion,
                           instants_per_oscillation * mdr::common_cycle(mdr.motion).value().highest_order()));
  const bool memory = !mdr.body.branch_moduli.empty();
  const int per_piece = memory ? std::max(8, instants_per_oscillation / static_cast<int>(mdr.path->n_pieces())) : 1;
  return mdr::plane_stick_depths(mdr::stuck_element(mdr.body, mu, *mdr.path, per_piece));
}

void add_cycle(const MdrCase& mdr, int times, MdrAnswer& answer) {
  constexpr int n_springs = 100, n_steps = 360;
  const auto response_with = [&](int finer, double& way) {
    const auto motion = mdr.path ? in_steps(*mdr.path, finer * n_steps) : in_steps(mdr.motion, finer * n_steps);
    way = way_of(motion);
    return mdr::plane_response(mdr.profile, mdr.body, mdr.friction_coefficient, motion, finer * n_springs);
  };
  double way = 0;
  const auto coarse = response_with(times, way), fine = response_with(2 * times, way);
  const bool once = mdr.is_single_pass();
  const auto bulk = [&](const mdr::PlaneResponse& r) {
    return once || (mdr.body.branch_moduli.empty() && mdr.body.viscosity == 0)
               ? 0
               : std::max(0.0, r.tangential_work + r.normal_work - r.friction_work);
  };
  const double sliding_force = mdr.friction_coefficient * answer.normal_force_max.value();
  MdrCycle cycle{};
  cycle.tangential_force_max = fine.force_x_max;
  cycle.tangential_force_mean = fine.force_x_mean;
  cycle.friction_work = fine.friction_work;
  cycle.bulk_work = bulk(fine);
  cycle.tangential_work = once ? 0 : fine.tangential_work;
  cycle.sliding_force = sliding_force;
  cycle.sliding_work = sliding_force * way;
  cycle.force_error =
      std::max(std::abs(fine.force_x_max - coarse.force_x_max), std::abs(fine.force_x_mean - coarse.force_x_mean));
  cycle.work_error = std::abs(fine.friction_work - coarse.friction_work) + std::abs(bulk(fine) - bulk(coarse));
  cycle.loop_error = once ? 0 : std::abs(fine.tangential_work - coarse.tangential_work);
  answer.cycle = cycle;
  answer.transverse_force_max = fine.force_y_max;
  answer.transverse_force_error = std::abs(fine.force_y_max - coarse.force_y_max);
}

}  // namespace

bool moves_in_plane(const MdrCase& mdr) {
  return mdr.path ? !mdr.path->transverse.empty() : mdr::moves_across(mdr.motion);
}

MdrAnswer plane_answer(const MdrCase& mdr, const mdr::NormalResponse& normal, int times) {
  auto answer = with_normal_response(normal);
  const auto radii = mdr::stick_radii(mdr.profile, depths_of(mdr));
  answer.stick_radius_first_slip = radii.first_slip;
  answer.stick_radius_shakedown = radii.shakedown;
  add_cycle(mdr, times, answer);
  return answer;
}

}  // namespace fretval
