#include <cmath>

#include "comparison/support/constants.h"
#include "comparison/verification/exact/exact_rows.h"
#include "fem/history/friction_history.h"
#include "fem/ring_contact/stick_zone/stick_zones.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {
namespace {

struct TangentialOscillation {
  double amplitude, degrees;  ///< degrees: phase
};

/// Combined oscillation at omega = 1 about the indentation `1 - normal_amplitude`, under a parabola.
struct PeriodicCase {
  std::string name;
  mdr::PronyBody body;
  double normal_amplitude;
  std::vector<TangentialOscillation> tangential;
  ConvergenceDemand first_slip, shakedown;
};

/// Largest errors of first slip and shakedown over the phases, 120 steps a cycle, over the largest contact radius,
/// which is 1.
std::vector<double> zone_errors(const ConvergenceMesh& mesh, const PeriodicCase& periodic, const ExactScene& exact) {
  const fem::HistoryControl control{120, 400, 1e-7};
  fem::Motion motion = fem::one_frequency(1 - periodic.normal_amplitude, periodic.normal_amplitude, 0, 0.0);
  motion.n_ramp_cycles = 40;  // after ten, first slip is still 2e-6 of a radius short of that of a slow rise
  const auto model = fem_model(periodic.body);
  const auto profile = means_of(mdr::parabola(1), mesh.normal);
  double first_slip = 0, shakedown = 0;
  for (const auto& [amplitude, degrees] : periodic.tangential) {
    const double phase = degrees * pi / 180;
    motion.tangential = {{amplitude, 1, phase}};
    const auto [normal, friction] =
        fem::contact_history({mesh.normal, model, profile, motion, control.steps_per_cycle},
                             {mesh.tangential, model, friction_coefficient, motion, control.steps_per_cycle}, control);
    const auto zones = fem::stick_zones(mesh.tangential.compliance, friction, fem::stuck_rings(friction, motion));
    const auto expected =
        mdr::stick_radii(mdr::parabola(1 / exact.steepness), periodic.body, exact.friction_coefficient,
                         {motion.indentation, periodic.normal_amplitude, amplitude, 1 / (2 * pi), 1 / (2 * pi), phase});
    take_worst(first_slip, zones.first_slip.radius - expected.first_slip.value_or(std::nan("")));
    take_worst(shakedown, zones.shakedown.radius - expected.shakedown.value_or(std::nan("")));
  }
  return {first_slip, shakedown};
}

/// All phases, each with three amplitudes: other positions of the edges within their ring.
std::vector<TangentialOscillation> all_phases(double amplitude) {
  std::vector<TangentialOscillation> oscillations;
  for (const double share : {0.86, 0.93, 1.0})
    for (int k = 0; k < 12; ++k) oscillations.push_back({share * amplitude, 15.0 * k});
  return oscillations;
}

/// Oscillations with a phase of 90 degrees, under which the two stick radii are equal, for these radii.
std::vector<TangentialOscillation> with_stick_radii(const std::vector<double>& radii, double modulus_ratio,
                                                    double normal_amplitude) {
  std::vector<TangentialOscillation> oscillations;
  for (const double c : radii) {
    const double relief = (1 - normal_amplitude - c * c) / modulus_ratio;
    oscillations.push_back(
        {1.5 * friction_coefficient * std::sqrt(relief * relief - normal_amplitude * normal_amplitude), 90});
  }
  return oscillations;
}

/// Stick radii within two rings of the smallest contact, at 64 rings to the largest one.
std::vector<double> within_two_rings(double normal_amplitude) {
  std::vector<double> radii;
  for (const double rings : {0.2, 0.4, 0.7, 1.0, 1.4, 2.0})
    radii.push_back(std::sqrt(1 - 2 * normal_amplitude) - rings / 64);
  return radii;
}

}  // namespace

Rows periodic_rows(const Meshes& meshes, const ExactScene& exact) {
  const auto elastic = mdr::elastic(1);
  const auto solid = mdr::standard_solid(1, std::sqrt(3.5) - 1, 1);  // |G(omega = 1)| = 1.5
  const char* floor = "floor: far field, 120 steps a cycle";
  const ConvergenceDemand demand{1e-6, 3, 2 * far_field, floor}, small{2e-6, 3, far_field, floor};
  const ConvergenceDemand together{
      8e-6, 0.5, far_field, "the stick zone ends where the smallest contact does: hardly falls from 32 rings on"};
  const ConvergenceDemand narrow{2e-5, 1, far_field, "slip in two rings: of lower order than that of more"};
  Rows rows;
  // Elsewhere the normal amplitudes let the stick zone end some rings inside the smallest contact.
  for (const auto& one : {PeriodicCase{"periodic, elastic", elastic, 0.2, all_phases(0.27), demand, demand},
                          PeriodicCase{"periodic, standard solid", solid, 0.1, all_phases(0.25), demand, demand},
                          PeriodicCase{"periodic, c/a = 0.1 to 0.13", solid, 0.2,
                                       with_stick_radii({0.1, 0.11, 0.12, 0.13}, 1.5, 0.2), small, small},
                          PeriodicCase{"periodic, slip within two rings", elastic, 0.2,
                                       with_stick_radii(within_two_rings(0.2), 1, 0.2), narrow, narrow},
                          PeriodicCase{"periodic, k = 1 in phase", solid, 0.2, {{0.12, 0}}, demand, together}})
    append(rows,
           mesh_rows(Rows{{one.name, "first-slip radius", "paper, equations (19) to (27)", one.first_slip},
                          {one.name, "shakedown radius", "two tangents, Barber, Davies & Hills 2011", one.shakedown}},
                     meshes, [&](const ConvergenceMesh& mesh) { return zone_errors(mesh, one, exact); }));
  return rows;
}

}  // namespace fretval
