#include "mdr/springs/slip_of_periods.h"

#include <cmath>
#include <stdexcept>

#include "mdr/motion/repeating_motion.h"
#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

std::vector<double> slip_of_periods(const Profile& profile, const PronyBody& body, double mu,
                                    const Prescribed& prescribed, double stick_radius, int n_ramp, double least,
                                    const SpringFineness& fineness) {
  constexpr int most_periods = 2000;
  if (!prescribed.motion.phase_locked || !common_cycle(prescribed.motion))
    throw std::invalid_argument("a motion without a period has no slip of periods");
  require_positive("stick radius", stick_radius);
  const auto repeating = repeating_motion(prescribed.motion, fineness.n_oscillations);
  const double period = repeating.period(), ramp = n_ramp / lowest_frequency(repeating.motion);
  const auto bed = spring_bed(profile, largest_radius(profile, body, prescribed), fineness.n_springs);
  const double c = stick_radius;
  const Eigen::ArrayXd weights = 4 / (pi * c * c) * bed.width * (c * c - bed.position.square()).max(0).sqrt();
  const auto mean_of = [&weights](const Eigen::ArrayXd& slip) { return (weights * slip).sum(); };
  const auto history = spring_history(
      bed, body, mu, loading_of(prescribed, repeating, ramp),
      {period, repeating.steps_with(fineness.steps_per_oscillation), static_cast<int>(std::ceil(ramp / period)),
       most_periods, fineness.periodicity, [&](const Eigen::ArrayXd& slip) { return mean_of(slip) <= least; }, false});
  std::vector<double> means;
  for (const auto& slip : history.slip_of_periods) means.push_back(mean_of(slip));
  return means;
}

}  // namespace fretval::mdr
