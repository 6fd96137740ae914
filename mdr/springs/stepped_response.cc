#include "mdr/springs/stepped_response.h"

#include <algorithm>
#include <cmath>

#include "mdr/springs/sampled_peak.h"
#include "mdr/springs/spring_history.h"

namespace fretval::mdr {
namespace {

constexpr Eigen::Index n_springs = 200;
constexpr int steps_per_oscillation = 180, n_ramp_periods = 8, most_periods = 2000, n_oscillations = 96;
constexpr double periodicity = 1e-9;

SpringHistory history_with(const std::function<double(double)>& g, double outer_radius, const PronyBody& body,
                           const RepeatingMotion& repeating, int fineness) {
  const double period = repeating.period();
  const int n_steps = repeating.steps_with(steps_per_oscillation), n_ramp = repeating.periods_with(n_ramp_periods);
  return spring_history(spring_bed(g, outer_radius, fineness * n_springs), body, 1,
                        {ramped_path(repeating, n_ramp * period), {}, {}},
                        {period, fineness * n_steps, n_ramp, most_periods, periodicity});
}

}  // namespace

NormalResponse stepped_normal_response(const std::function<double(double)>& g, double outer_radius,
                                       const PronyBody& body, const HarmonicMotion& motion) {
  const auto repeating_with = [&motion](int n) { return repeating_motion({motion.indentation, motion.normal, {}}, n); };
  const auto repeating = repeating_with(2 * n_oscillations);
  const auto coarse = history_with(g, outer_radius, body, repeating_with(n_oscillations), 1),
             fine = history_with(g, outer_radius, body, repeating, 2);
  const auto extrapolated = [&](std::vector<double> SpringHistory::*part, double sign) {
    const double peak = sampled_peak(fine.*part, sign);
    return peak + (peak - sampled_peak(coarse.*part, sign)) / 3;
  };
  NormalResponse response{extrapolated(&SpringHistory::normal_force, 1),
                          std::max(extrapolated(&SpringHistory::normal_force, -1), 0.0),
                          outer_radius,
                          {},
                          {},
                          {},
                          fine.normal_force};
  if (has_bounded_axis_pressure(g, outer_radius, body, response.normal_force_min == 0)) {
    const double read = sampled_peak(fine.axis_pressure, 1);
    const double step = (read - sampled_peak(coarse.axis_pressure, 1)) / axis_pressure_gain(g, outer_radius);
    response.axis_pressure = {read + step, 3 * std::abs(step)};
  }
  const auto path = ramped_path(repeating, 1e-9 * repeating.period());
  for (const double time : fine.time) {
    response.time.push_back(time - fine.time.front());
    response.indentation.push_back(path(time).indentation);
  }
  response.normal_force_error = std::abs(response.normal_force_max - sampled_peak(fine.normal_force, 1));
  return response;
}

}  // namespace fretval::mdr
