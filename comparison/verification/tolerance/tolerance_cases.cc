#include "comparison/verification/tolerance/tolerance_cases.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

namespace fretval {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double depth = 1e-4, radius = 1e-3, modulus = 1e6, frequency = 1;  // m, m, Pa, Hz
constexpr double unlocked = std::numeric_limits<double>::quiet_NaN();

Entries parabola() {
  return {{"Indenter / Shape", "parabola"}, {"Indenter / Radius", entry_text(1e-2)}};
}

Entries cone(double degrees) {
  return {{"Indenter / Shape", "cone"}, {"Indenter / Slope angle", entry_text(degrees)}};
}

/// f = depth (r/radius)^n
Entries power(double exponent) {
  return {{"Indenter / Shape", "power"},
          {"Indenter / Exponent", entry_text(exponent)},
          {"Indenter / Coefficient", entry_text(depth / std::pow(radius, exponent))}};
}

Entries rounded_flat(double flat_radius, double edge_radius) {
  return {{"Indenter / Shape", "rounded flat"},
          {"Indenter / Flat radius", entry_text(flat_radius)},
          {"Indenter / Edge radius", entry_text(edge_radius)}};
}

Entries truncated_sphere(double sphere_radius, double flat_radius) {
  return {{"Indenter / Shape", "truncated sphere"},
          {"Indenter / Radius", entry_text(sphere_radius)},
          {"Indenter / Flat radius", entry_text(flat_radius)}};
}

Entries body(const char* rheology) {
  return {{"Elastomer / Rheology", rheology}, {"Elastomer / Relaxed shear modulus", entry_text(modulus)}};
}

Entries elastic() {
  return body("elastic");
}

std::string list_of(std::vector<double> values, double unit) {
  for (double& value : values) value *= unit;
  return fmt::format("{}", fmt::join(values, ", "));
}

/// Moduli over the relaxed one, times in s.
Entries branches(const char* rheology, const std::vector<double>& moduli, const std::vector<double>& times) {
  return with(body(rheology), {{"Elastomer / Branch moduli", list_of(moduli, modulus)},
                               {"Elastomer / Branch times", list_of(times, 1)}});
}

Entries standard_solid(double modulus_ratio, double time) {
  return branches("standard solid", {modulus_ratio}, {time});
}

Entries kelvin_voigt(double omega_tau) {
  return with(body("kelvin voigt"),
              {{"Elastomer / Viscosity", entry_text(omega_tau * modulus / (2 * pi * frequency))}});
}

Entries two_branches() {
  return branches("prony", {0.5, 1.0}, {0.5, 0.05});
}

Entries three_branches() {
  return branches("prony", {0.4, 0.6, 1.0}, {1.0, 0.15, 0.02});
}

/// How the tangential amplitude is given.
enum class Given {
  k,         ///< 3 mu Delta d/(2 u_x0)
  load,      ///< A/d0, A = 2 u_x0/(3 mu)
  shakedown  ///< shakedown radius over the contact radius at the largest indentation
};

struct Row {
  const char* name;
  Entries indenter, elastomer;
  double friction, normal;  ///< normal amplitude over the indentation
  double phase;             ///< deg
  Given given;
  double value;
};

std::vector<Row> rows() {
  const auto sphere = parabola();
  const auto fast = standard_solid(1, 0.1), slow = standard_solid(3, 0.3), short_time = standard_solid(2, 0.02);
  return {
      {"parabola-elastic-90", sphere, elastic(), 0.5, 0.2, 90, Given::k, 1},
      {"parabola-elastic-0", sphere, elastic(), 0.3, 0.1, 0, Given::k, 0.5},
      {"parabola-elastic-0-k1", sphere, elastic(), 0.5, 0.25, 0, Given::k, 1},
      {"parabola-elastic-45", sphere, elastic(), 0.7, 0.3, 45, Given::k, 2},
      {"parabola-elastic-180", sphere, elastic(), 1.0, 0.4, 180, Given::k, 4},
      {"parabola-elastic-135", sphere, elastic(), 0.2, 0.05, 135, Given::k, 0.3},
      {"parabola-elastic-steady", sphere, elastic(), 0.5, 0, 0, Given::load, 0.3},
      {"parabola-elastic-free", sphere, elastic(), 0.5, 0.1, unlocked, Given::k, 1},
      {"parabola-solid-20", sphere, fast, 0.5, 0.4, 20, Given::k, 1.5},
      {"parabola-solid-90", sphere, fast, 0.5, 0.25, 90, Given::k, 1},
      {"parabola-solid-60", sphere, short_time, 0.3, 0.2, 60, Given::k, 0.7},
      {"parabola-solid-150", sphere, slow, 0.8, 0.2, 150, Given::k, 3},
      {"parabola-voigt-30", sphere, kelvin_voigt(0.3), 0.5, 0.2, 30, Given::k, 1},
      {"parabola-voigt-90", sphere, kelvin_voigt(1), 0.4, 0.15, 90, Given::k, 0.8},
      {"parabola-voigt-0", sphere, kelvin_voigt(2), 0.6, 0.1, 0, Given::k, 0.5},
      {"parabola-two-branches-120", sphere, two_branches(), 0.5, 0.2, 120, Given::k, 1.5},
      {"parabola-three-branches-70", sphere, three_branches(), 0.5, 0.25, 70, Given::k, 2},
      {"parabola-three-branches-free", sphere, three_branches(), 0.5, 0.1, unlocked, Given::k, 1},
      {"cone-elastic-90", cone(5), elastic(), 0.5, 0.2, 90, Given::k, 1},
      {"cone-elastic-0", cone(10), elastic(), 0.3, 0.3, 0, Given::k, 2},
      {"cone-solid-45", cone(5), fast, 0.5, 0.25, 45, Given::k, 1},
      {"cone-voigt-120", cone(5), kelvin_voigt(0.3), 0.3, 0.1, 120, Given::k, 0.5625},
      {"cone-voigt-180", cone(2), kelvin_voigt(2), 0.9, 0.2, 180, Given::k, 1.5},
      {"cone-two-branches-free", cone(5), two_branches(), 0.5, 0.15, unlocked, Given::k, 0.8},
      {"power-1.5-elastic-60", power(1.5), elastic(), 0.5, 0.2, 60, Given::k, 1},
      {"power-1.5-voigt-90", power(1.5), kelvin_voigt(1), 0.3, 0.1, 90, Given::k, 1},
      {"power-3-solid-30", power(3), fast, 0.5, 0.3, 30, Given::k, 1.2},
      {"power-4-elastic-150", power(4), elastic(), 0.4, 0.2, 150, Given::k, 0.6},
      {"power-4-three-branches-80", power(4), three_branches(), 0.6, 0.25, 80, Given::k, 2},
      {"power-6-elastic-90", power(6), elastic(), 0.5, 0.5, 90, Given::k, 3},
      {"power-6-voigt-45", power(6), kelvin_voigt(0.3), 0.5, 0.1, 45, Given::k, 1},
      {"rounded-flat-elastic-90", rounded_flat(5e-4, 3e-3), elastic(), 0.5, 0.2, 90, Given::k, 1.5},
      {"rounded-flat-solid-0", rounded_flat(5e-4, 3e-3), fast, 0.4, 0.1, 0, Given::k, 0.6},
      {"rounded-flat-two-branches-120", rounded_flat(8e-4, 7e-4), two_branches(), 0.6, 0.2, 120, Given::k, 2},
      {"truncated-sphere-elastic-90", truncated_sphere(7.6e-3, 4e-4), elastic(), 0.5, 0.2, 90, Given::shakedown, 0.75},
      {"truncated-sphere-solid-60", truncated_sphere(8e-3, 3e-4), fast, 0.5, 0.1, 60, Given::shakedown, 0.8},
      {"truncated-sphere-voigt-30", truncated_sphere(7e-3, 5e-4), kelvin_voigt(0.3), 0.3, 0.1, 30, Given::shakedown,
       0.8},
      {"small-stick-parabola", sphere, elastic(), 0.5, 0.2, 90, Given::shakedown, 0.02},
      {"small-stick-solid", sphere, fast, 0.5, 0.1, 90, Given::shakedown, 0.02},
      {"small-stick-cone", cone(5), elastic(), 0.5, 0.15, 60, Given::shakedown, 0.05},
      {"small-stick-power-4", power(4), elastic(), 0.3, 0.1, 90, Given::shakedown, 0.1},
      {"small-stick-voigt", sphere, kelvin_voigt(0.3), 0.5, 0.1, 90, Given::shakedown, 0.05},
      {"narrow-slip-parabola", sphere, elastic(), 0.5, 0, 0, Given::shakedown, 0.999},
      {"narrow-slip-solid", sphere, fast, 0.5, 0, 0, Given::shakedown, 0.998},
      {"narrow-slip-cone", cone(5), elastic(), 0.5, 0, 0, Given::shakedown, 0.997},
      {"narrow-slip-power-3", power(3), two_branches(), 0.5, 0, 0, Given::shakedown, 0.99},
      {"at-rest-parabola", sphere, elastic(), 0.5, 0.3, 0, Given::load, 0},
      {"at-rest-cone", cone(5), fast, 0.5, 0.2, 0, Given::load, 0},
      {"no-first-slip-elastic", sphere, elastic(), 0.5, 0.5, 10, Given::k, 0.8},
      {"no-first-slip-two-branches", cone(5), two_branches(), 0.5, 0.3, 170, Given::k, 0.9},
  };
}

Entries with_tangential_amplitude(const Row& row, const Entries& entries) {
  if (row.given == Given::shakedown) return with_stick_ratio(entries, row.value);
  const double sliding = 1.5 * row.friction * depth;
  const double amplitude = row.given == Given::k ? sliding * row.normal / row.value : sliding * row.value;
  return with(entries, {{"Motion / Tangential amplitude", entry_text(amplitude)}});
}

Entries entries_of(const Row& row, double tolerance) {
  const Entries entries{{"Accuracy / Tolerance", entry_text(tolerance)},
                        {"Accuracy / Economise", "true"},
                        {"Friction / Law", "unidirectional"},
                        {"Friction / Coefficient", entry_text(row.friction)},
                        {"Motion / Indentation", entry_text(depth)},
                        {"Motion / Normal amplitude", entry_text(row.normal * depth)},
                        {"Motion / Tangential amplitude", "0"},
                        {"Motion / Normal frequency", entry_text(frequency)},
                        {"Motion / Tangential frequency", entry_text(frequency)},
                        {"Motion / Phase", std::isnan(row.phase) ? "free" : entry_text(row.phase)}};
  return with_tangential_amplitude(row, with(with(entries, row.indenter), row.elastomer));
}

}  // namespace

std::vector<std::pair<std::string, Entries>> tolerance_entries(double tolerance) {
  std::vector<std::pair<std::string, Entries>> all;
  for (const auto& row : rows()) all.emplace_back(row.name, entries_of(row, tolerance));
  return all;
}

std::vector<Case> tolerance_cases(double tolerance) {
  std::vector<Case> cases;
  for (const auto& [name, entries] : tolerance_entries(tolerance))
    cases.push_back(case_of(entries, name, "suite tolerance"));
  return cases;
}

}  // namespace fretval
