#include "mdr/springs/path_history.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mdr/support/checks.h"

namespace fretval::mdr {
namespace {

constexpr std::array parts{&PathForces::normal_force_max,
                           &PathForces::normal_force_min,
                           &PathForces::axis_pressure_max,
                           &PathForces::tangential_force_max,
                           &PathForces::tangential_force_mean,
                           &PathForces::friction_work,
                           &PathForces::bulk_work,
                           &PathForces::tangential_work,
                           &PathForces::largest_indentation,
                           &PathForces::tangential_amplitude,
                           &PathForces::tangential_way,
                           &PathForces::first_slip,
                           &PathForces::shakedown};

}  // namespace

PathForces forces_of(const SpringHistory& history) {
  const auto &time = history.time, &pull = history.tangential_force, &normal = history.normal_force;
  double largest = 0, mean = 0;
  for (std::size_t k = 0; k < pull.size(); ++k) {
    largest = std::max(largest, std::abs(pull[k]));
    if (k > 0) mean += (time[k] - time[k - 1]) * (pull[k - 1] + pull[k]) / 2;
  }
  const auto &depth = history.indentation, &shift = history.tangential_displacement;
  const auto [least, most] = std::minmax_element(shift.begin(), shift.end());
  double way = 0;
  for (std::size_t k = 1; k < shift.size(); ++k) way += std::abs(shift[k] - shift[k - 1]);
  return {*std::max_element(normal.begin(), normal.end()),
          *std::min_element(normal.begin(), normal.end()),
          *std::max_element(history.axis_pressure.begin(), history.axis_pressure.end()),
          largest,
          mean / (time.back() - time.front()),
          history.friction_work,
          history.bulk_work,
          history.tangential_work,
          *std::max_element(depth.begin(), depth.end()),
          (*most - *least) / 2,
          way,
          history.depths.first_slip,
          history.settling_depth};
}

void extrapolate(const PathForces& coarse, SteppedPathForces& stepped) {
  stepped.error = distance(stepped.forces, coarse);
  for (const auto part : parts) stepped.forces.*part += (stepped.forces.*part - coarse.*part) / 3;
}

PathForces distance(const PathForces& one, const PathForces& other) {
  PathForces distance{};
  for (const auto part : parts) distance.*part = std::abs(one.*part - other.*part);
  return distance;
}

void validate_along_path(const SampledPath& path, const PathFineness& fineness) {
  validate(path);
  require_within("steps along a path", fineness.steps_per_duration, 1, 1e6);
  require_within("ramp periods", fineness.n_ramp_periods, 1, 1e9);
}

}  // namespace fretval::mdr
