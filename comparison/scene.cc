#include "comparison/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "mdr/shakedown_amplitude.h"
#include "meshes/grading.h"

namespace fretval {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

// The contact line reaches a little beyond the largest contact, so that the first ring that never touches is on it.
constexpr double contact_line_reserve = 1.12;

// Rings at the edge of a worn stick zone over its radius: the last ring of width h carries a share of sqrt(2 h/c) of
// the force of a flat punch, and a part of that of order 0.1 ends up outside.
constexpr double worn_edge_ring = 5e-6;

mdr::Profile profile_of(const Case::Indenter& indenter) {
  switch (indenter.shape) {
    case Case::Shape::parabola:
      return mdr::parabola(indenter.radius);
    case Case::Shape::cone:
      return mdr::cone(indenter.slope_angle * degree);
    default:
      return mdr::power_law(indenter.coefficient, indenter.exponent);
  }
}

mdr::PronyBody body_of(const Case::Elastomer& elastomer) {
  return mdr::prony(elastomer.relaxed_modulus, elastomer.branch_moduli, elastomer.branch_times, elastomer.viscosity);
}

mdr::LimitingProfile limiting_of(const Case& scene, const MdrScene& mdr) {
  const double deepest = mdr::maximum_indentation(mdr.motion);
  const double unworn_radius = mdr::inverse_transform(mdr.profile, deepest);
  return mdr::limiting_profile(mdr.profile, scene.worn_stick_ratio * unworn_radius, deepest);
}

double amplitude_for_shakedown(const Case& scene, const MdrScene& mdr) {
  const double depth = mdr::transform(mdr.profile, mdr.limiting->stick_radius);
  const auto amplitude = mdr::tangential_amplitude_for_shakedown(mdr.body, mdr.friction_coefficient, mdr.motion, depth);
  if (!amplitude)
    throw InputError(
        fmt::format("{}: Wear / Stick radius ratio = {:g}: no tangential amplitude shakes down there, because "
                    "the contact opens inside it in every cycle; expected a smaller ratio or a smaller Motion / "
                    "Normal amplitude",
                    scene.file, scene.worn_stick_ratio));
  return *amplitude;
}

std::vector<double> contact_nodes(const Case& scene, const MdrScene& mdr, const Units& units,
                                  const Resolution& resolution) {
  const double ring = 1.0 / resolution.elements_per_radius;
  if (scene.wear == Case::Wear::unworn) {
    const auto n = static_cast<unsigned>(std::ceil(contact_line_reserve * resolution.elements_per_radius / 2)) * 2;
    return meshes::uniform_nodes(n * ring, n);
  }
  const double edge = mdr.limiting->stick_radius / units.length;
  // Rounded up to quarters of the contact radius, so that profiles with the same c share their body.
  const double end = std::ceil(4 * contact_line_reserve * mdr.limiting->outer_radius / units.length) / 4;
  return meshes::graded_nodes(edge, end, ring, worn_edge_ring * edge, resolution.growth);
}

std::function<double(double)> profile_in(const Units& units, const Case& scene, const MdrScene& mdr) {
  const double length = units.length, depth = units.depth;
  if (mdr.limiting)
    return [worn = *mdr.limiting, length, depth](double r) { return mdr::shape(worn, r * length) / depth; };
  // Written out rather than taken from mdr/, so that an error there cannot cancel in the comparison.
  const auto& indenter = scene.indenter;
  switch (indenter.shape) {
    case Case::Shape::parabola:
      return [factor = length * length / (2 * indenter.radius * depth)](double r) { return factor * r * r; };
    case Case::Shape::cone:
      return [factor = std::tan(indenter.slope_angle * degree) * length / depth](double r) { return factor * r; };
    default:
      return [factor = indenter.coefficient * std::pow(length, indenter.exponent) / depth,
              n = indenter.exponent](double r) { return factor * std::pow(r, n); };
  }
}

}  // namespace

bool BodySpecification::operator<(const BodySpecification& other) const {
  return std::tie(contact_nodes, growth, far_radius, degree) <
         std::tie(other.contact_nodes, other.growth, other.far_radius, other.degree);
}

MdrScene mdr_scene(const Case& scene) {
  const auto& motion = scene.motion;
  const bool amplitude_follows = std::isnan(motion.tangential_amplitude);
  std::optional<double> phase;
  if (motion.phase) phase = *motion.phase * degree;
  MdrScene mdr{profile_of(scene.indenter),
               body_of(scene.elastomer),
               scene.friction_coefficient,
               {motion.indentation, motion.normal_amplitude, amplitude_follows ? 0 : motion.tangential_amplitude,
                motion.frequency, motion.frequency, phase},
               {}};
  if (scene.wear == Case::Wear::limiting) mdr.limiting = limiting_of(scene, mdr);
  if (amplitude_follows) mdr.motion.tangential_amplitude = amplitude_for_shakedown(scene, mdr);
  return mdr;
}

FemScene fem_scene(const Case& scene, const MdrScene& mdr) {
  auto resolution = resolution_for(scene.tolerance);
  if (scene.rings_per_radius) resolution.elements_per_radius = *scene.rings_per_radius;
  if (scene.steps_per_cycle) resolution.steps_per_cycle = *scene.steps_per_cycle;
  const double deepest = scene.motion.indentation + scene.motion.normal_amplitude;
  const Units units{mdr::inverse_transform(mdr.profile, deepest), deepest, scene.elastomer.relaxed_modulus,
                    mdr::angular_frequency(scene.motion.frequency)};
  FemScene fem{units, {}, {}, {}, scene.friction_coefficient, profile_in(units, scene, mdr), resolution, {}};
  if (mdr.limiting)
    fem.worn_edge = {mdr.limiting->stick_radius / units.length, mdr.limiting->outer_radius / units.length};
  fem.body = {contact_nodes(scene, mdr, units, resolution), resolution.growth, resolution.far_radius,
              resolution.degree};
  fem.relaxation.viscosity = scene.elastomer.viscosity * units.angular_frequency / units.modulus;
  for (const double modulus : scene.elastomer.branch_moduli) fem.relaxation.moduli.push_back(modulus / units.modulus);
  for (const double time : scene.elastomer.branch_times) fem.relaxation.times.push_back(time * units.angular_frequency);
  fem.motion = {scene.motion.indentation / deepest, scene.motion.normal_amplitude / deepest,
                mdr.motion.tangential_amplitude / deepest, mdr.motion.phase};
  fem.motion.n_ramp_cycles = resolution.n_ramp_cycles;
  return fem;
}

bool same_normal_problem(const FemScene& a, const Case& case_a, const FemScene& b, const Case& case_b) {
  const auto key = [](const FemScene& fem, const Case& scene) {
    const auto& indenter = scene.indenter;
    return std::make_tuple(fem.body.contact_nodes, indenter.shape, indenter.radius, indenter.slope_angle,
                           indenter.coefficient, indenter.exponent, scene.wear, scene.worn_stick_ratio,
                           fem.relaxation.moduli, fem.relaxation.times, fem.relaxation.viscosity,
                           scene.motion.indentation, scene.motion.normal_amplitude, fem.resolution.steps_per_cycle,
                           fem.resolution.n_ramp_cycles, fem.resolution.periodicity);
  };
  return key(a, case_a) == key(b, case_b);
}

}  // namespace fretval
