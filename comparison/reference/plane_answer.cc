#include "comparison/reference/plane_answer.h"

#include <algorithm>
#include <cmath>

#include "comparison/reference/cycle_of_springs.h"
#include "mdr/motion/force_control.h"
#include "mdr/plane/plane_springs.h"
#include "mdr/plane/plane_stick.h"
#include "mdr/rheology/rheology.h"
#include "mdr/springs/path_history.h"
#include "mdr/springs/spring_step.h"

namespace fretval {
namespace {

/// Indentation in the course of the period or pass, read from the normal response; it may follow from a prescribed
/// force.
class Indentation {
 public:
  explicit Indentation(const mdr::NormalResponse& normal) : normal_(normal) {}
  /// Indentation in m at t in s from the start of the period or pass, linear between the instants of the response.
  double operator()(double t) const {
    const auto& time = normal_.time;
    const auto after = std::lower_bound(time.begin(), time.end(), t);
    if (after == time.begin()) return normal_.indentation.front();
    if (after == time.end()) return normal_.indentation.back();
    const auto k = static_cast<std::size_t>(after - time.begin());
    const double share = (t - time[k - 1]) / (time[k] - time[k - 1]);
    return normal_.indentation[k - 1] + share * (normal_.indentation[k] - normal_.indentation[k - 1]);
  }

 private:
  const mdr::NormalResponse& normal_;
};

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

/// A path in about `steps` steps, with the same number of equal steps in each piece.
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

/// The steps of a motion. Under a normal force the indentation is that of the normal response, and the rest that of the
/// relaxed body under the mean force.
mdr::PlaneMotion steps_of(const MdrCase& mdr, const mdr::NormalResponse& normal, int steps) {
  auto motion = mdr.path ? in_steps(*mdr.path, steps) : in_steps(mdr.motion, steps);
  motion.by_force = mdr.tangential_force;
  if (!mdr.normal_force) return motion;
  const Indentation depth(normal);
  motion.rest.depth = mdr.is_single_pass()
                          ? depth(0)
                          : mdr::indentation_for_force(mdr.profile, mdr.body.relaxed_modulus, motion.rest.depth);
  for (std::size_t k = 0; k < motion.positions.size(); ++k) motion.positions[k].depth = depth(motion.time[k]);
  return motion;
}

mdr::StickDepths depths_of(const MdrCase& mdr) {
  if (!mdr.path) return mdr::plane_stick_depths(mdr::Rheology(mdr.body), mdr.friction_coefficient, mdr.motion);
  const bool memory = !mdr.body.branch_moduli.empty();
  const int per_piece =
      memory ? std::max(8, mdr::instants_per_oscillation / static_cast<int>(mdr.path->n_pieces())) : 1;
  return mdr::plane_stick_depths(mdr::stuck_element(mdr.body, mdr.friction_coefficient, *mdr.path, per_piece));
}

}  // namespace

bool moves_in_plane(const MdrCase& mdr) {
  return mdr.path ? !mdr.path->transverse.empty() : mdr::moves_across(mdr.motion);
}

MdrAnswer plane_answer(const MdrCase& mdr, const mdr::NormalResponse& normal, int times) {
  const int n_springs = 100 * times / mdr.coarser_springs, n_steps = 360 * times / mdr.coarser_springs;
  auto answer = with_normal_response(normal);
  const auto motion = steps_of(mdr, normal, 2 * n_steps), coarse = steps_of(mdr, normal, n_steps);
  const auto response = [&](const mdr::PlaneMotion& steps, int finer) {
    return mdr::plane_response(mdr.profile, mdr.body, mdr.friction_coefficient, steps, finer * n_springs);
  };
  try {
    const auto fine = response(motion, 2), rough = response(coarse, 1);
    const auto forces = mdr::forces_of(fine, mdr.body, motion),
               error = mdr::distance(forces, mdr::forces_of(rough, mdr.body, motion));
    answer.cycle = cycle_along(mdr, forces, error, normal.normal_force_max);
    answer.transverse_force_max = fine.force_y_max;
    answer.transverse_force_error = std::abs(fine.force_y_max - rough.force_y_max);
    if (mdr.has_forces()) {
      take_depths(mdr, fine.depths, {error.first_slip, error.shakedown}, forces, error, answer);
      if (!mdr.is_single_pass()) take_tangential_amplitude(mdr, forces, error, answer);
      return answer;
    }
    const auto radii = mdr::stick_radii(mdr.profile, depths_of(mdr));
    answer.stick_radius_first_slip = radii.first_slip;
    answer.stick_radius_shakedown = radii.shakedown;
  } catch (const mdr::GrossSlip& slip) {
    GrossSlipShare share{slip.amplitude};
    if (mdr.is_single_pass()) share.time = mdr.path->time.front() + slip.time;
    answer.of_kind = share;
  }
  return answer;
}

}  // namespace fretval
