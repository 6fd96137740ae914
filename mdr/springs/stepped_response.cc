#include "mdr/springs/stepped_response.h"

#include <algorithm>
#include <cmath>

#include "mdr/springs/sampled_peak.h"
#include "mdr/springs/spring_history.h"

namespace fretval::mdr {
namespace {

constexpr Eigen::Index n_springs = 200;
constexpr int steps_per_oscillation = 180, n_ramp_periods = 8, most_periods = 2000;
constexpr double periodicity = 1e-9;

SpringHistory history_with(const std::function<double(double)>& g, double outer_radius, const PronyBody& body,
                           const HarmonicMotion& motion, double fineness) {
  const double period = common_period(motion);
  double fastest = 0;
  for (const auto& harmonic : motion.normal) fastest = std::max(fastest, harmonic.frequency);
  const auto count = [fineness](double n) { return static_cast<int>(std::lround(fineness * n)); };
  return spring_history(
      spring_bed(g, outer_radius, count(n_springs)), body, 1, {ramped_path(motion, n_ramp_periods * period), {}, {}},
      {period, count(steps_per_oscillation * fastest * period), n_ramp_periods, most_periods, periodicity});
}

}  // namespace

SteppedResponse stepped_normal_response(const std::function<double(double)>& g, double outer_radius,
                                        const PronyBody& body, const HarmonicMotion& motion) {
  const HarmonicMotion normal{motion.indentation, motion.normal, {}};
  const auto coarse = history_with(g, outer_radius, body, normal, 1),
             fine = history_with(g, outer_radius, body, normal, 2);
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
    const double pressure = extrapolated(&SpringHistory::axis_pressure, 1);
    response.axis_pressure = {pressure, 3 * std::abs(pressure - sampled_peak(fine.axis_pressure, 1))};
  }
  const auto path = ramped_path(normal, 1e-9 * common_period(normal));
  for (const double time : fine.time) {
    response.time.push_back(time - fine.time.front());
    response.indentation.push_back(path(time).indentation);
  }
  const double error = std::abs(response.normal_force_max - sampled_peak(fine.normal_force, 1));
  return {std::move(response), error};
}

}  // namespace fretval::mdr
