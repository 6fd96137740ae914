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
mdr::StickDepths stepped_depths(const Case& scene, const mdr::Profile& profile, const mdr::HarmonicMotion& motion,
                                double contact_radius, Eigen::Index n_springs, int steps_per_cycle) {
  const double period = mdr::common_period(motion);
  const double fastest = std::max(scene.motion.normal_frequency, scene.motion.tangential_frequency);
  const int steps = steps_per_cycle * static_cast<int>(std::lround(fastest * period));
  const auto bed = mdr::spring_bed(profile, contact_radius, n_springs);
  return mdr::spring_history(bed, body_in_time(scene), scene.friction_coefficient,
                             {mdr::ramped_path(motion, n_ramp_periods * period), {}, {}},
                             {period, steps, n_ramp_periods, 400, 1e-7})
      .depths;
}

}  // namespace

std::map<std::string, ExtremeError> spring_errors(const Case& scene) {
  const auto profile = profile_of(scene.indenter);
  const auto motion = harmonic_motion_of(scene.motion);
  const double a = mdr::inverse_transform(profile, mdr::maximum_indentation(motion));
  const auto mdr = over_contact_radius(
      profile, a, mdr::stick_depths(rheology_of(scene.elastomer), scene.friction_coefficient, motion));
  const auto coarse = over_contact_radius(profile, a, stepped_depths(scene, profile, motion, a, 50, 24));
  const auto fine = over_contact_radius(profile, a, stepped_depths(scene, profile, motion, a, 100, 48));
  const auto error = [&](double exact, double stepped, double coarser) {
    return ExtremeError{exact, stepped, stepped - exact, scene.tolerance, 3 * std::abs(stepped - coarser)};
  };
  return {{"stick_radius_first_slip", error(mdr.first_slip, fine.first_slip, coarse.first_slip)},
          {"stick_radius_shakedown", error(mdr.shakedown, fine.shakedown, coarse.shakedown)}};
}

}  // namespace fretval
