#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/support/constants.h"
#include "comparison/support/folders.h"
#include "comparison/verification/suites.h"
#include "mdr/rheology/rheology.h"

namespace fretval {
namespace {

constexpr const char* creeps = "the body creeps for";
constexpr double relaxed_modulus = 1e6, indentation = 1e-4, radius = 1e-3;  // Pa, m, about that of the contact in m

using Cases = std::vector<SuiteCase>;
using Values = std::vector<double>;

/// The base with numbers in place of some of its own.
Entries base_with(const std::map<std::string, double>& numbers) {
  return with_numbers(extremes_base(), numbers);
}

/// Adds a family, or a part of it. name: format of a value; refusal: words of the message that has to come.
template <class EntriesOf>
void vary(Cases& cases, const char* family, const char* name, const Values& values, const EntriesOf& entries_of,
          const std::string& refusal = "") {
  for (const double x : values)
    cases.push_back({family, fmt::format(fmt::runtime(name), x), case_text(entries_of(x)), refusal});
}

void add(Cases& cases, const char* family, const std::string& name, const Entries& entries,
         const std::string& refusal = "") {
  cases.push_back({family, name, case_text(entries), refusal});
}

/// Amplitudes so small that a stick zone of c/a = 0.6 is left, however stiff the body is at its frequency.
Entries with_small_amplitudes(const Entries& entries) {
  const auto mdr = mdr_case(case_of(entries, "case"));
  const double ratio = mdr::modulus_ratio(mdr.body, mdr::angular_frequency(mdr.motion.normal.front().frequency));
  return with_stick_ratio(with_numbers(entries, {{"Motion / Normal amplitude", 0.2 * indentation / ratio}}), 0.6);
}

Entries standard_solid(double omega_tau, double modulus_ratio) {
  return with_section(extremes_base(), branches("standard solid", relaxed_modulus, {modulus_ratio * relaxed_modulus},
                                                {omega_tau / (2 * pi)}));
}

void add_bodies(Cases& cases) {
  const auto softening = [](double x) { return with_small_amplitudes(standard_solid(1, 1 / x - 1)); };
  const auto opening = [](double x) { return standard_solid(1, 1 / x - 1); };
  vary(cases, "relaxation time, standard solid", "omega tau = {:g}", {1e-6, 1e-4, 1e-2, 1, 1e2, 1e4, 1e6},
       [](double x) { return with_small_amplitudes(standard_solid(x, 1)); });
  vary(cases, "viscosity, Kelvin-Voigt", "omega eta/G0 = {:g}", {1e-6, 1e-3, 1, 1e3, 1e6}, [](double x) {
    return with_small_amplitudes(
        with_section(extremes_base(), kelvin_voigt(relaxed_modulus, x * relaxed_modulus / (2 * pi))));
  });
  vary(cases, "softening, omega tau = 1", "G0/Ginf = {:g}", {1e-1, 1e-2, 1e-4, 1e-6}, softening);
  // At 1e-4 a body creeps for 1e9 cycles, and the roundoff of the processor decides whether it is refused.
  const auto slow = [](double x) { return with_small_amplitudes(standard_solid(1e6, 1 / x - 1)); };
  vary(cases, "softening, omega tau = 1e6", "G0/Ginf = {:g}", {1e-2, 1e-3}, slow);
  vary(cases, "softening, omega tau = 1e6", "G0/Ginf = {:g}", {1e-6}, slow, creeps);
  vary(cases, "softening, contact opens", "G0/Ginf = {:g}", {1e-1, 1e-3}, opening);
  vary(cases, "softening, contact opens", "G0/Ginf = {:g}", {1e-6}, opening, "a body that creeps for long");
}

void add_friction_and_units(Cases& cases) {
  const auto friction = [](double x) { return base_with({{"Friction / Coefficient", x}}); };
  vary(cases, "friction, amplitude scaled", "mu = {:g}", {1e-4, 1e-2, 1, 1e2, 1e3},
       [&](double x) { return with_stick_ratio(friction(x), 0.6); });
  vary(cases, "friction, amplitude kept", "mu = {:g}", {1e-4, 1e-2, 1, 1e2, 1e3}, friction);
  for (const auto& [name, metre] :
       {std::pair{"a = 1 nm", 1e-6}, {"a = 1 um", 1e-3}, {"a = 1 m", 1e3}, {"a = 1 km", 1e6}})
    add(cases, "length", name,
        base_with({{"Indenter / Radius", 1e-2 * metre},
                   {"Motion / Indentation", 1e-4 * metre},
                   {"Motion / Normal amplitude", 2e-5 * metre},
                   {"Motion / Tangential amplitude", 1.5e-5 * metre}}));
  vary(cases, "modulus", "G0 = {:g} Pa", {1e-3, 1, 1e6, 1e12}, [](double x) {
    return base_with({{"Elastomer / Relaxed shear modulus", x}, {"Elastomer / Branch moduli", x}});
  });
  vary(cases, "frequency", "f = {:g} Hz", {1e-6, 1e6}, [](double x) {
    return base_with({{"Motion / Normal frequency", x},
                      {"Motion / Tangential frequency", x},
                      {"Elastomer / Branch times", 0.1 / x}});
  });
}

void add_amplitudes(Cases& cases) {
  vary(cases, "tangential amplitude over sliding", "{:g}",
       {1e-8, 1e-4, 1e-2, 0.1, 0.5, 0.9, 0.99, 0.9999, 1, 1.01, 2, 100}, [](double x) {
         return with_stick_ratio(base_with({{"Motion / Normal amplitude", 1e-5}}), 0, x);
       });
  vary(cases, "normal amplitude, elastic", "Dd/d0 = {:g}",
       {1e-8, 1e-4, 1e-2, 0.1, 0.5, 0.9, 0.99, 0.999, 1, 1.1, 2, 10}, [](double x) {
         return with_numbers(elastic_base(), {{"Motion / Normal amplitude", x * indentation},
                                              {"Motion / Tangential amplitude", 7.5e-8},
                                              {"Motion / Phase", 90}});
       });
  vary(cases, "normal amplitude, standard solid", "Dd/d0 = {:g}", {1e-8, 1e-2, 0.5, 0.9, 1, 2}, [](double x) {
    return base_with({{"Motion / Normal amplitude", x * indentation}, {"Motion / Tangential amplitude", 7.5e-7}});
  });
}

Entries steady_normal(const Entries& entries) {
  return with_numbers(entries, {{"Motion / Normal amplitude", 0}, {"Motion / Phase", 0}});
}

void add_stick_zones(Cases& cases) {
  const char *border = "border of no stick", *all_stick = "all stick";
  vary(cases, "small stick zone", "c/a = {:g}", {0.1, 0.01, 1e-3, 1e-4},
       [](double x) { return with_stick_ratio(extremes_base(), x); });
  vary(cases, "narrow slip ring", "1 - c/a = {:g}", {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6},
       [](double x) { return with_stick_ratio(steady_normal(extremes_base()), 1 - x); });
  add(cases, border, "elastic", with_stick_ratio(elastic_base(), 0));
  add(cases, border, "elastic, 1e-9 below", with_stick_ratio(elastic_base(), 0, 1 - 1e-9));
  add(cases, border, "elastic, 1e-9 above", with_stick_ratio(elastic_base(), 0, 1 + 1e-9));
  add(cases, border, "steady normal force", with_stick_ratio(steady_normal(elastic_base()), 0));
  add(cases, border, "standard solid", with_stick_ratio(extremes_base(), 0));
  const auto at_rest = base_with({{"Motion / Tangential amplitude", 0}});
  add(cases, all_stick, "u_x0 = 0", at_rest);
  add(cases, all_stick, "u_x0 = 0, Dd = 0", steady_normal(at_rest));
}

/// Delta d = 0.2 d0.
Entries in_phase(const Entries& entries, double phase, double k) {
  return with_numbers(entries,
                      {{"Motion / Phase", phase}, {"Motion / Tangential amplitude", 0.75 * 0.2 * indentation / k}});
}

void add_phases_and_frequencies(Cases& cases) {
  vary(cases, "in phase, elastic", "phi0 = 0, k = {:.10g}", {0.5, 1 - 1e-9, 1, 1 + 1e-9, 2},
       [](double k) { return in_phase(elastic_base(), 0, k); });
  vary(cases, "in phase, standard solid", "phi0 = 0, k = {:g}", {0.5, 1, 2},
       [](double k) { return in_phase(extremes_base(), 0, k); });
  vary(cases, "phase at k = 1", "phi0 = {:g} deg", {1e-6, 180, 360, -90, 1e6},
       [](double phase) { return in_phase(elastic_base(), phase, 1); });
  add(cases, "phase at k = 1", "unlocked", with(in_phase(elastic_base(), 0, 1), {{"Motion / Phase", "free"}}));
  const std::string frequency = "Motion / Tangential frequency";
  const auto ratio = [&](double x) { return with_numbers(in_phase(elastic_base(), 60, 1), {{frequency, x}}); };
  vary(cases, "frequency ratio", "f_x/f_z = {:g}", {1e-3, 1e-2, 0.5, 2, 1e2, 1e3}, ratio);
  vary(cases, "frequency ratio", "f_x/f_z = {:g}", {1e4}, ratio, "Motion");
}

Entries measured(const char* file) {
  return {{"Indenter / Shape", "table"}, {"Indenter / Table", (data_folder() / "cases" / "extremes" / file).string()}};
}

void add_shapes(Cases& cases) {
  // Half the amplitude of sliding: a stick radius of a given ratio may lie on the flat of a face.
  const auto under = [](const Entries& indenter) {
    return with_stick_ratio(with_section(base_with({{"Motion / Normal amplitude", 1e-5}}), indenter), 0, 0.5);
  };
  vary(cases, "power law", "n = {:g}", {0.5, 0.7, 1, 1.5, 2, 3, 4, 6, 10, 20},
       [&](double n) { return under(power(n, indentation / std::pow(radius, n))); });
  vary(cases, "cone", "{:g} deg", {1e-3, 1, 45, 89}, [&](double degrees) { return under(cone(degrees)); });
  // A contact of about the radius, flat up to the given share of it.
  vary(cases, "flat with a rounded edge", "b = {:g} mm", {0.01, 0.5, 0.9, 0.99}, [&](double share) {
    return under(rounded_flat(share * radius, (1 - share) * radius * radius / (2 * indentation)));
  });
  const auto arc = [&](double share) { return under(sphere(1.1 * indentation / (share * std::atanh(share)))); };
  vary(cases, "sphere", "a/R = {:g}", {1e-3, 0.1, 0.3, 0.6}, arc);
  vary(cases, "sphere", "a/R = {:g}", {0.7}, arc, "Indenter / Radius");
  vary(cases, "sphere with a flat", "b = {:g} mm", {0.01, 0.3, 0.55},
       [&](double share) { return under(truncated_sphere(1e-2, share * radius)); });
  add(cases, "measured profile", "flat face", under(measured("flat-face.csv")));
  vary(cases, "limiting profile", "c/a = {:g}", {0.1, 0.5, 0.99}, [](double ratio) {
    return with(base_with({{"Wear / Stick radius ratio", ratio}, {"Motion / Normal amplitude", 1e-7}}),
                {{"Wear / State", "limiting"}, {"Motion / Tangential amplitude", "shakedown"}});
  });
}

void compute_at_least(int n_cycles, PreparedCase& prepared) {
  auto resolution = prepared.fem.resolution;
  resolution.n_ramp_cycles = n_cycles;
  prepared.fem = at_resolution(std::move(prepared.fem), resolution);
}

void add_numerics(Cases& cases) {
  const std::string steps = "Accuracy / Steps per cycle", rings = "Accuracy / Rings per radius";
  const auto with_steps = [&](double n) { return base_with({{steps, n}}); };
  const auto with_rings = [&](double n) { return base_with({{rings, n}}); };
  vary(cases, "steps per cycle", "{:g}", {4, 15}, with_steps, steps);
  vary(cases, "steps per cycle", "{:g}", {16, 36, 100, 10000}, with_steps);
  const auto first = cases.size();
  vary(cases, "cycles", "{:g} at least", {1, 10, 100}, [](double) { return extremes_base(); });
  // An elastic body takes fewer computations for its error budget.
  vary(cases, "cycles", "{:g} at least", {1000, 10000}, [&](double) {
    return with_numbers(elastic_base(), {{steps, 20}});
  });
  for (std::size_t i = first; i < cases.size(); ++i)
    cases[i].change = [n = std::stoi(cases[i].name)](PreparedCase& prepared) { compute_at_least(n, prepared); };
  vary(cases, "rings per radius", "{:g}", {4, 15}, with_rings, rings);
  vary(cases, "rings per radius", "{:g}", {16, 32, 128}, with_rings);
}

void add_bad_input(Cases& cases) {
  for (const auto& [place, value] :
       std::vector<std::pair<std::string, std::string>>{{"Elastomer / Relaxed shear modulus", "0"},
                                                        {"Friction / Coefficient", "0"},
                                                        {"Motion / Indentation", "0"},
                                                        {"Motion / Normal frequency", "inf"},
                                                        {"Motion / Tangential amplitude", "nan"},
                                                        {"Accuracy / Tolerance", "1e-9"}})
    add(cases, "refused input", place + " = " + value, with(extremes_base(), {{place, value}}), place);
}

template <class Property>
Cases chosen(const Cases& cases, Property property) {
  Cases some;
  std::copy_if(cases.begin(), cases.end(), std::back_inserter(some), property);
  return some;
}

/// The folder of the measured profiles is another one on every machine.
void leave_out_folder(std::string& text) {
  const std::string folder = (data_folder() / "cases" / "extremes" / "").string();
  const auto place = text.find(folder);
  if (place != std::string::npos) text.erase(place, folder.size());
}

}  // namespace

Entries extremes_base() {
  const Entries entries{{"Friction / Coefficient", "0.5"},      {"Friction / Law", "unidirectional"},
                        {"Motion / Indentation", "1e-4"},       {"Motion / Normal amplitude", "2e-5"},
                        {"Motion / Normal frequency", "1"},     {"Motion / Tangential amplitude", "1.5e-5"},
                        {"Motion / Tangential frequency", "1"}, {"Motion / Phase", "60"},
                        {"Accuracy / Tolerance", "1e-2"}};
  return with(with(entries, parabola(1e-2)), branches("standard solid", relaxed_modulus, {relaxed_modulus}, {0.1}));
}

Entries elastic_base() {
  return with_section(extremes_base(), elastic(relaxed_modulus));
}

Cases extreme_cases() {
  Cases cases;
  for (const auto add_theme : {add_bodies, add_friction_and_units, add_amplitudes, add_stick_zones,
                               add_phases_and_frequencies, add_shapes, add_numerics, add_bad_input})
    add_theme(cases);
  return cases;
}

Cases short_extreme_cases() {
  std::set<std::string> seen;
  return chosen(extreme_cases(), [&](const SuiteCase& one) { return seen.insert(one.family).second; });
}

Cases only_family(const Cases& cases, const std::string& text) {
  return chosen(cases, [&](const SuiteCase& one) { return one.family.find(text) != std::string::npos; });
}

SuiteRun run_extreme_suite(const Cases& cases) {
  auto run = run_suite("extremes", "Every parameter to its ends, along families of several values.", cases);
  for (auto& row : run.rows) {
    leave_out_folder(row.asked.text);
    leave_out_folder(row.refusal);
  }
  return run;
}

}  // namespace fretval
