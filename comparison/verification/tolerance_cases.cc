#include <cmath>
#include <limits>

#include "comparison/support/constants.h"
#include "comparison/verification/suites.h"
#include "comparison/verification/written_case.h"

namespace fretval {
namespace {

constexpr double depth = 1e-4, contact_radius = 1e-3, modulus = 1e6, frequency = 1;  // m, m, Pa, Hz
constexpr double unlocked = std::numeric_limits<double>::quiet_NaN();

Entries r_to(double exponent) {
  return power(exponent, depth / std::pow(contact_radius, exponent));
}

Entries one_branch(double modulus_ratio, double time) {
  return branches("standard solid", modulus, {modulus_ratio * modulus}, {time});
}

Entries voigt(double omega_tau) {
  return kelvin_voigt(modulus, omega_tau * modulus / (2 * pi * frequency));
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
  const auto sphere = parabola(1e-2), hooke = elastic(modulus);
  const auto fast = one_branch(1, 0.1), slow = one_branch(3, 0.3), short_time = one_branch(2, 0.02);
  const auto two_branches = branches("prony", modulus, {0.5e6, 1e6}, {0.5, 0.05});
  const auto three_branches = branches("prony", modulus, {0.4e6, 0.6e6, 1e6}, {1.0, 0.15, 0.02});
  return {
      {"parabola-elastic-90", sphere, hooke, 0.5, 0.2, 90, Given::k, 1},
      {"parabola-elastic-0", sphere, hooke, 0.3, 0.1, 0, Given::k, 0.5},
      {"parabola-elastic-0-k1", sphere, hooke, 0.5, 0.25, 0, Given::k, 1},
      {"parabola-elastic-45", sphere, hooke, 0.7, 0.3, 45, Given::k, 2},
      {"parabola-elastic-180", sphere, hooke, 1.0, 0.4, 180, Given::k, 4},
      {"parabola-elastic-135", sphere, hooke, 0.2, 0.05, 135, Given::k, 0.3},
      {"parabola-elastic-steady", sphere, hooke, 0.5, 0, 0, Given::load, 0.3},
      {"parabola-elastic-free", sphere, hooke, 0.5, 0.1, unlocked, Given::k, 1},
      {"parabola-solid-20", sphere, fast, 0.5, 0.4, 20, Given::k, 1.5},
      {"parabola-solid-90", sphere, fast, 0.5, 0.25, 90, Given::k, 1},
      {"parabola-solid-60", sphere, short_time, 0.3, 0.2, 60, Given::k, 0.7},
      {"parabola-solid-150", sphere, slow, 0.8, 0.2, 150, Given::k, 3},
      {"parabola-voigt-30", sphere, voigt(0.3), 0.5, 0.2, 30, Given::k, 1},
      {"parabola-voigt-90", sphere, voigt(1), 0.4, 0.15, 90, Given::k, 0.8},
      {"parabola-voigt-0", sphere, voigt(2), 0.6, 0.1, 0, Given::k, 0.5},
      {"parabola-two-branches-120", sphere, two_branches, 0.5, 0.2, 120, Given::k, 1.5},
      {"parabola-three-branches-70", sphere, three_branches, 0.5, 0.25, 70, Given::k, 2},
      {"parabola-three-branches-free", sphere, three_branches, 0.5, 0.1, unlocked, Given::k, 1},
      {"cone-elastic-90", cone(5), hooke, 0.5, 0.2, 90, Given::k, 1},
      {"cone-elastic-0", cone(10), hooke, 0.3, 0.3, 0, Given::k, 2},
      {"cone-solid-45", cone(5), fast, 0.5, 0.25, 45, Given::k, 1},
      {"cone-voigt-120", cone(5), voigt(0.3), 0.3, 0.1, 120, Given::k, 0.5625},
      {"cone-voigt-180", cone(2), voigt(2), 0.9, 0.2, 180, Given::k, 1.5},
      {"cone-two-branches-free", cone(5), two_branches, 0.5, 0.15, unlocked, Given::k, 0.8},
      {"power-1.5-elastic-60", r_to(1.5), hooke, 0.5, 0.2, 60, Given::k, 1},
      {"power-1.5-voigt-90", r_to(1.5), voigt(1), 0.3, 0.1, 90, Given::k, 1},
      {"power-3-solid-30", r_to(3), fast, 0.5, 0.3, 30, Given::k, 1.2},
      {"power-4-elastic-150", r_to(4), hooke, 0.4, 0.2, 150, Given::k, 0.6},
      {"power-4-three-branches-80", r_to(4), three_branches, 0.6, 0.25, 80, Given::k, 2},
      {"power-6-elastic-90", r_to(6), hooke, 0.5, 0.5, 90, Given::k, 3},
      {"power-6-voigt-45", r_to(6), voigt(0.3), 0.5, 0.1, 45, Given::k, 1},
      {"rounded-flat-elastic-90", rounded_flat(5e-4, 3e-3), hooke, 0.5, 0.2, 90, Given::k, 1.5},
      {"rounded-flat-solid-0", rounded_flat(5e-4, 3e-3), fast, 0.4, 0.1, 0, Given::k, 0.6},
      {"rounded-flat-two-branches-120", rounded_flat(8e-4, 7e-4), two_branches, 0.6, 0.2, 120, Given::k, 2},
      {"truncated-sphere-elastic-90", truncated_sphere(7.6e-3, 4e-4), hooke, 0.5, 0.2, 90, Given::shakedown, 0.75},
      {"truncated-sphere-solid-60", truncated_sphere(8e-3, 3e-4), fast, 0.5, 0.1, 60, Given::shakedown, 0.8},
      {"truncated-sphere-voigt-30", truncated_sphere(7e-3, 5e-4), voigt(0.3), 0.3, 0.1, 30, Given::shakedown, 0.8},
      {"small-stick-parabola", sphere, hooke, 0.5, 0.2, 90, Given::shakedown, 0.02},
      {"small-stick-solid", sphere, fast, 0.5, 0.1, 90, Given::shakedown, 0.02},
      {"small-stick-cone", cone(5), hooke, 0.5, 0.15, 60, Given::shakedown, 0.05},
      {"small-stick-power-4", r_to(4), hooke, 0.3, 0.1, 90, Given::shakedown, 0.1},
      {"small-stick-voigt", sphere, voigt(0.3), 0.5, 0.1, 90, Given::shakedown, 0.05},
      {"narrow-slip-parabola", sphere, hooke, 0.5, 0, 0, Given::shakedown, 0.999},
      {"narrow-slip-solid", sphere, fast, 0.5, 0, 0, Given::shakedown, 0.998},
      {"narrow-slip-cone", cone(5), hooke, 0.5, 0, 0, Given::shakedown, 0.997},
      {"narrow-slip-power-3", r_to(3), two_branches, 0.5, 0, 0, Given::shakedown, 0.99},
      {"at-rest-parabola", sphere, hooke, 0.5, 0.3, 0, Given::load, 0},
      {"at-rest-cone", cone(5), fast, 0.5, 0.2, 0, Given::load, 0},
      {"no-first-slip-elastic", sphere, hooke, 0.5, 0.5, 10, Given::k, 0.8},
      {"no-first-slip-two-branches", cone(5), two_branches, 0.5, 0.3, 170, Given::k, 0.9},
  };
}

Entries entries_of(const Row& row, double tolerance) {
  const double sliding = 1.5 * row.friction * depth;
  Entries entries = with_numbers({{"Friction / Law", "unidirectional"}, {"Motion / Phase", "free"}},
                                 {{"Accuracy / Tolerance", tolerance},
                                  {"Friction / Coefficient", row.friction},
                                  {"Motion / Indentation", depth},
                                  {"Motion / Normal amplitude", row.normal * depth},
                                  {"Motion / Normal frequency", frequency},
                                  {"Motion / Tangential frequency", frequency},
                                  {"Motion / Tangential amplitude",
                                   row.given == Given::k ? sliding * row.normal / row.value : sliding * row.value}});
  if (!std::isnan(row.phase)) entries["Motion / Phase"] = entry_text(row.phase);
  entries = with(with(entries, row.indenter), row.elastomer);
  return row.given == Given::shakedown ? with_stick_ratio(entries, row.value) : entries;
}

}  // namespace

std::vector<SuiteCase> tolerance_cases(double tolerance) {
  std::vector<SuiteCase> cases;
  for (const auto& row : rows()) {
    SuiteCase one{"tolerance " + entry_text(tolerance), row.name, case_text(entries_of(row, tolerance))};
    one.must_be_conclusive = true;
    cases.push_back(one);
  }
  return cases;
}

SuiteRun run_tolerance_suite(const std::vector<double>& tolerances) {
  std::vector<SuiteCase> all;
  for (const double tolerance : tolerances)
    for (auto& one : tolerance_cases(tolerance)) all.push_back(std::move(one));
  return run_suite("tolerance", "Fifty varied cases, refined until their error bars meet a tolerance.", all);
}

}  // namespace fretval
