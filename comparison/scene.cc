#include "comparison/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "meshes/grading.h"

namespace fretval {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

// The contact line reaches a little beyond the largest contact, so that the first ring that never touches is on it.
constexpr double contact_line_reserve = 1.12;

// Rings at the edge of a worn stick zone over its radius: the last ring of width h carries a share of sqrt(2 h/c) of
// the force of a flat punch, and a part of that of order 0.1 ends up outside.
constexpr double worn_edge_ring = 5e-6;

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
    case Case::Shape::power:
      return [factor = indenter.coefficient * std::pow(length, indenter.exponent) / depth,
              n = indenter.exponent](double r) { return factor * std::pow(r, n); };
    case Case::Shape::rounded_flat:
      return [factor = length * length / (2 * indenter.edge_radius * depth), flat = indenter.flat_radius / length](
                 double r) { return r > flat ? factor * (r - flat) * (r - flat) : 0; };
    case Case::Shape::truncated_sphere:
      return [factor = length * length / (2 * indenter.radius * depth), flat = indenter.flat_radius / length](
                 double r) { return r > flat ? factor * (r - flat) * (r + flat) : 0; };
    case Case::Shape::table:
      break;
  }
  // The heights between measured points are data; what MDR adds is their transform.
  return [profile = mdr.profile, length, depth](double r) { return mdr::shape(profile, r * length) / depth; };
}

}  // namespace

bool BodySpecification::operator<(const BodySpecification& other) const {
  return std::tie(contact_nodes, growth, far_radius, degree) <
         std::tie(other.contact_nodes, other.growth, other.far_radius, other.degree);
}

FemScene fem_scene(const Case& scene, const MdrScene& mdr) {
  auto resolution = resolution_for(scene.tolerance);
  if (scene.rings_per_radius) resolution.elements_per_radius = *scene.rings_per_radius;
  if (scene.steps_per_cycle) resolution.steps_per_cycle = *scene.steps_per_cycle;
  const double deepest = scene.motion.indentation + scene.motion.normal_amplitude;
  const Units units{mdr::inverse_transform(mdr.profile, deepest), deepest, scene.elastomer.relaxed_modulus,
                    mdr::angular_frequency(scene.motion.normal_frequency)};
  FemScene fem{units, {}, {}, {}, scene.friction_coefficient, profile_in(units, scene, mdr), resolution, {}};
  if (mdr.limiting)
    fem.worn_edge = {mdr.limiting->stick_radius / units.length, mdr.limiting->outer_radius / units.length};
  fem.body = {contact_nodes(scene, mdr, units, resolution), resolution.growth, resolution.far_radius,
              resolution.degree};
  fem.relaxation.viscosity = mdr.body.viscosity * units.angular_frequency / units.modulus;
  for (const double modulus : mdr.body.branch_moduli) fem.relaxation.moduli.push_back(modulus / units.modulus);
  for (const double time : mdr.body.branch_times) fem.relaxation.times.push_back(time * units.angular_frequency);
  fem.motion = {scene.motion.indentation / deepest, scene.motion.normal_amplitude / deepest,
                mdr.motion.tangential_amplitude / deepest, mdr.motion.phase};
  fem.motion.n_ramp_cycles = resolution.n_ramp_cycles;
  return fem;
}

bool same_normal_problem(const FemScene& a, const Case& case_a, const FemScene& b, const Case& case_b) {
  const auto key = [](const FemScene& fem, const Case& scene) {
    const auto& indenter = scene.indenter;
    return std::make_tuple(fem.body.contact_nodes, indenter.shape, indenter.radius, indenter.slope_angle,
                           indenter.coefficient, indenter.exponent, indenter.flat_radius, indenter.edge_radius,
                           indenter.table, indenter.table_noise, scene.wear, scene.worn_stick_ratio,
                           fem.relaxation.moduli, fem.relaxation.times, fem.relaxation.viscosity,
                           scene.motion.indentation, scene.motion.normal_amplitude, fem.resolution.steps_per_cycle,
                           fem.resolution.n_ramp_cycles, fem.resolution.periodicity);
  };
  return key(a, case_a) == key(b, case_b);
}

}  // namespace fretval
