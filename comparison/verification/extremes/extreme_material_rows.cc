#include <fmt/format.h>

#include <cmath>

#include "comparison/reference/mdr_case.h"
#include "comparison/verification/extremes/extreme_rows.h"
#include "mdr/rheology/rheology.h"

namespace fretval {
namespace {

constexpr double pi = 3.14159265358979323846;
// A body that creeps for more than some 1e5 cycles is refused by name.
constexpr const char* creeps = "the body creeps for";
constexpr double relaxed_modulus = 1e6;  // Pa

Entries voigt(double omega_tau) {
  return with_section(extremes_base(), kelvin_voigt(relaxed_modulus, omega_tau * relaxed_modulus / (2 * pi)));
}

Entries standard_solid(double omega_tau, double modulus_ratio) {
  return with_section(extremes_base(),
                      branches("standard solid", relaxed_modulus, {modulus_ratio}, {omega_tau / (2 * pi)}));
}

/// Amplitudes so small that a stick zone of c/a = 0.6 is left, however stiff the body is at its frequency.
Entries with_small_amplitudes(const Entries& entries) {
  const auto mdr = mdr_case(case_of(entries, "case"));
  const double ratio = mdr::modulus_ratio(mdr.body, mdr::angular_frequency(mdr.motion.normal_frequency));
  return with_stick_ratio(with(entries, {{"Motion / Normal amplitude", entry_text(0.2 * usual_indentation / ratio)}}),
                          0.6);
}

void add_bodies(std::vector<ExtremeRow>& rows) {
  for (const double x : {1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6})
    rows.push_back({"relaxation time, standard solid", fmt::format("omega tau = {:g}", x),
                    with_small_amplitudes(standard_solid(x, 1))});
  for (const double x : {1e-6, 1e-3, 1.0, 1e3, 1e6})
    rows.push_back({"viscosity, Kelvin-Voigt", fmt::format("omega eta/G0 = {:g}", x), with_small_amplitudes(voigt(x))});
  for (const double x : {1e-1, 1e-2, 1e-4, 1e-6})
    rows.push_back({"softening, omega tau = 1", fmt::format("G0/Ginf = {:g}", x),
                    with_small_amplitudes(standard_solid(1, 1 / x - 1)), x < 1e-5 ? creeps : ""});
  for (const double x : {1e2, 1e4, 1e6})
    rows.push_back({"softening, omega tau = 1e6", fmt::format("G0/Ginf = {:g}", 1 / x),
                    with_small_amplitudes(standard_solid(1e6, x - 1)), creeps});
  for (const double x : {1e-1, 1e-3, 1e-6})
    rows.push_back({"softening, contact opens", fmt::format("G0/Ginf = {:g}", x), standard_solid(1, 1 / x - 1),
                    x < 1e-5 ? creeps : ""});
}

void add_friction(std::vector<ExtremeRow>& rows) {
  for (const bool scaled : {true, false})
    for (const double mu : {1e-4, 1e-2, 1.0, 1e2, 1e3}) {
      const auto entries = with(extremes_base(), {{"Friction / Coefficient", entry_text(mu)}});
      rows.push_back({scaled ? "friction, amplitude scaled" : "friction, amplitude kept", fmt::format("mu = {:g}", mu),
                      scaled ? with_stick_ratio(entries, 0.6) : entries});
    }
}

/// The base with all lengths in another unit.
Entries in_length_unit(double metre) {
  return with(extremes_base(), {{"Indenter / Radius", entry_text(1e-2 * metre)},
                                {"Motion / Indentation", entry_text(1e-4 * metre)},
                                {"Motion / Normal amplitude", entry_text(2e-5 * metre)},
                                {"Motion / Tangential amplitude", entry_text(1.5e-5 * metre)}});
}

void add_units(std::vector<ExtremeRow>& rows) {
  for (const auto& [name, metre] :
       {std::pair{"a = 1 nm", 1e-6}, {"a = 1 um", 1e-3}, {"a = 1 m", 1e3}, {"a = 1 km", 1e6}})
    rows.push_back({"length", name, in_length_unit(metre)});
  for (const double modulus : {1e-3, 1.0, 1e6, 1e12})
    rows.push_back({"modulus", fmt::format("G0 = {:g} Pa", modulus),
                    with(extremes_base(), {{"Elastomer / Relaxed shear modulus", entry_text(modulus)},
                                           {"Elastomer / Branch moduli", entry_text(modulus)}})});
  for (const double frequency : {1e-6, 1e6})
    rows.push_back({"frequency", fmt::format("f = {:g} Hz", frequency),
                    with(extremes_base(), {{"Motion / Normal frequency", entry_text(frequency)},
                                           {"Motion / Tangential frequency", entry_text(frequency)},
                                           {"Elastomer / Branch times", entry_text(0.1 / frequency)}})});
}

}  // namespace

std::vector<ExtremeRow> extreme_material_rows() {
  std::vector<ExtremeRow> rows;
  add_bodies(rows);
  add_friction(rows);
  add_units(rows);
  return rows;
}

}  // namespace fretval
