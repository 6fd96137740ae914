#include "comparison/verification/extremes/extreme_springs.h"

#include <algorithm>
#include <cmath>

#include "comparison/reference/mdr_case.h"
#include "mdr/springs/spring_history.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {
namespace {

constexpr int n_ramp_periods = 4;

struct Radii {
  double first_slip, shakedown;  // over the contact radius
};

Radii over_contact_radius(const mdr::Profile& profile, double contact_radius, const mdr::StickDepths& depths) {
  const auto radius = [&](double depth) {
    return depth > 0 ? mdr::inverse_transform(profile, depth) / contact_radius : 0;
  };
  return {radius(depths.first_slip), radius(depths.shakedown)};
}

/// steps_per_cycle: of the faster motion.
mdr::StickDepths stepped_depths(const Case& input, const mdr::Profile& profile, const mdr::HarmonicMotion& motion,
                                double contact_radius, Eigen::Index n_springs, int steps_per_cycle) {
  const double period = mdr::common_period(motion);
  const double fastest = std::max(input.motion.normal_frequency, input.motion.tangential_frequency);
  const int steps = steps_per_cycle * static_cast<int>(std::lround(fastest * period));
  const auto bed = mdr::spring_bed(profile, contact_radius, n_springs);
  return mdr::spring_history(bed, body_in_time(input), input.friction_coefficient,
                             {mdr::ramped_path(motion, n_ramp_periods * period), {}, {}},
                             {period, steps, n_ramp_periods, 400, 1e-7})
      .depths;
}

}  // namespace

ComparedQuantities compared_with_springs(const Case& input) {
  const auto profile = profile_of(input.indenter);
  const auto motion = harmonic_motion_of(input.motion);
  const double a = mdr::inverse_transform(profile, mdr::maximum_indentation(motion));
  const auto mdr = over_contact_radius(
      profile, a, mdr::stick_depths(rheology_of(input.elastomer), input.friction_coefficient, motion));
  const auto coarse = over_contact_radius(profile, a, stepped_depths(input, profile, motion, a, 50, 24));
  const auto fine = over_contact_radius(profile, a, stepped_depths(input, profile, motion, a, 100, 48));
  const auto compared = [&](double exact, double stepped, double coarser) {
    return ComparedQuantity{exact, stepped, input.tolerance, 3 * std::abs(stepped - coarser)};
  };
  return {{Quantity::stick_radius_first_slip, compared(mdr.first_slip, fine.first_slip, coarse.first_slip)},
          {Quantity::stick_radius_shakedown, compared(mdr.shakedown, fine.shakedown, coarse.shakedown)}};
}

}  // namespace fretval
