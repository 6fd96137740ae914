#include "comparison/tolerance_cases.h"

#include <cmath>
#include <limits>

#include "comparison/mdr_scene.h"
#include "mdr/profile.h"
#include "mdr/shakedown_amplitude.h"

namespace fretval {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double depth = 1e-4, radius = 1e-3, modulus = 1e6, frequency = 1;  // m, m, Pa, Hz
constexpr double unlocked = std::numeric_limits<double>::quiet_NaN();

Case::Indenter parabola() {
  Case::Indenter indenter;
  indenter.radius = 1e-2;
  return indenter;
}

Case::Indenter cone(double degrees) {
  Case::Indenter indenter;
  indenter.shape = Case::Shape::cone;
  indenter.slope_angle = degrees;
  return indenter;
}

/// f = depth (r/radius)^n
Case::Indenter power(double exponent) {
  Case::Indenter indenter;
  indenter.shape = Case::Shape::power;
  indenter.exponent = exponent;
  indenter.coefficient = depth / std::pow(radius, exponent);
  return indenter;
}

Case::Indenter rounded_flat(double flat_radius, double edge_radius) {
  Case::Indenter indenter;
  indenter.shape = Case::Shape::rounded_flat;
  indenter.flat_radius = flat_radius;
  indenter.edge_radius = edge_radius;
  return indenter;
}

Case::Indenter truncated_sphere(double sphere_radius, double flat_radius) {
  Case::Indenter indenter;
  indenter.shape = Case::Shape::truncated_sphere;
  indenter.radius = sphere_radius;
  indenter.flat_radius = flat_radius;
  return indenter;
}

Case::Elastomer elastic() {
  Case::Elastomer elastomer;
  elastomer.rheology = "elastic";
  elastomer.relaxed_modulus = modulus;
  return elastomer;
}

Case::Elastomer standard_solid(double modulus_ratio, double time) {
  auto elastomer = elastic();
  elastomer.rheology = "standard solid";
  elastomer.branch_moduli = {modulus_ratio * modulus};
  elastomer.branch_times = {time};
  return elastomer;
}

Case::Elastomer kelvin_voigt(double omega_tau) {
  auto elastomer = elastic();
  elastomer.rheology = "kelvin voigt";
  elastomer.viscosity = omega_tau * modulus / (2 * pi * frequency);
  return elastomer;
}

Case::Elastomer two_branches() {
  auto elastomer = elastic();
  elastomer.rheology = "prony";
  elastomer.branch_moduli = {0.5 * modulus, 1.0 * modulus};
  elastomer.branch_times = {0.5, 0.05};
  return elastomer;
}

Case::Elastomer three_branches() {
  auto elastomer = elastic();
  elastomer.rheology = "prony";
  elastomer.branch_moduli = {0.4 * modulus, 0.6 * modulus, 1.0 * modulus};
  elastomer.branch_times = {1.0, 0.15, 0.02};
  return elastomer;
}

/// How the tangential amplitude is given.
enum class Given {
  k,         ///< 3 mu Delta d/(2 u_x0)
  load,      ///< A/d0, A = 2 u_x0/(3 mu)
  shakedown  ///< shakedown radius over the contact radius at the largest indentation
};

struct Row {
  const char* name;
  Case::Indenter indenter;
  Case::Elastomer elastomer;
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

double tangential_amplitude(const Case& scene, Given given, double value) {
  const double mu = scene.friction_coefficient;
  if (given == Given::k) return 1.5 * mu * scene.motion.normal_amplitude / value;
  if (given == Given::load) return 1.5 * mu * scene.motion.indentation * value;
  const auto mdr = mdr_scene(scene);
  const double contact_radius = mdr::inverse_transform(mdr.profile, mdr::maximum_indentation(mdr.motion));
  return mdr::tangential_amplitude_for_shakedown(mdr.body, mu, mdr.motion,
                                                 mdr::transform(mdr.profile, value * contact_radius))
      .value();
}

}  // namespace

std::vector<Case> tolerance_cases(double tolerance) {
  std::vector<Case> cases;
  for (const auto& row : rows()) {
    Case scene;
    scene.name = row.name;
    scene.file = "suite tolerance";
    scene.indenter = row.indenter;
    scene.elastomer = row.elastomer;
    scene.friction_coefficient = row.friction;
    scene.motion.indentation = depth;
    scene.motion.normal_amplitude = row.normal * depth;
    scene.motion.normal_frequency = scene.motion.tangential_frequency = frequency;
    if (!std::isnan(row.phase)) scene.motion.phase = row.phase;
    scene.motion.tangential_amplitude = tangential_amplitude(scene, row.given, row.value);
    scene.tolerance = tolerance;
    cases.push_back(scene);
  }
  return cases;
}

}  // namespace fretval
