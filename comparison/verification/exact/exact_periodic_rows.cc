#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "comparison/verification/exact/exact_rows.h"
#include "fem/stick_zone/stick_zones.h"

namespace fretval {
namespace {

constexpr double pi = boost::math::constants::pi<double>();

/// Largest errors of first slip and shakedown over the phases, over the largest contact radius, which is 1.
std::vector<double> zone_errors(const ConvergenceMesh& mesh, const PeriodicCase& periodic,
                                const ExactStickRadii& exact) {
  const fem::HistoryControl control{120, 400, 1e-7};
  fem::Motion motion{1 - periodic.normal_amplitude, periodic.normal_amplitude, 0, 0.0};
  motion.n_ramp_cycles = 40;  // after ten, first slip is still 2e-6 of a radius short of that of a slow rise
  const auto model = fem_model(periodic.body);
  const auto profile = means_of(mdr::parabola(1), mesh.normal);
  double first_slip = 0, shakedown = 0;
  for (const auto& [amplitude, degrees] : periodic.tangential) {
    const double phase = degrees * pi / 180;
    motion.tangential_amplitude = amplitude;
    motion.phase = phase;
    const auto [normal, friction] =
        fem::contact_history({mesh.normal, model, profile, motion, control.steps_per_cycle},
                             {mesh.tangential, model, friction_coefficient, motion, control.steps_per_cycle}, control);
    const auto zones =
        fem::stick_zones(mesh.tangential.compliance, normal, friction, fem::stuck_rings(friction, motion));
    const auto expected = exact(periodic.body, {motion.indentation, motion.normal_amplitude,
                                                motion.tangential_amplitude, 1 / (2 * pi), 1 / (2 * pi), phase});
    take_worst(first_slip, zones.first_slip.radius - expected.first_slip.value_or(std::nan("")));
    take_worst(shakedown, zones.shakedown.radius - expected.shakedown.value_or(std::nan("")));
  }
  return {first_slip, shakedown};
}

}  // namespace

ExactStickRadii exact_stick_radii() {
  return [](const mdr::PronyBody& body, const mdr::Motion& motion) {
    return mdr::stick_radii(mdr::parabola(1), body, friction_coefficient, motion);
  };
}

std::vector<ConvergenceRow> periodic_rows(const std::vector<ConvergenceMesh>& meshes, const PeriodicCase& periodic,
                                          const ExactStickRadii& exact) {
  return mesh_rows({{periodic.name, "first-slip radius", "paper, equations (19) to (27)", periodic.first_slip},
                    {periodic.name, "shakedown radius", periodic.source, periodic.shakedown}},
                   meshes, [&](const ConvergenceMesh& mesh) { return zone_errors(mesh, periodic, exact); });
}

}  // namespace fretval
