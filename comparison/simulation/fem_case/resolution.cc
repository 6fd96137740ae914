#include "comparison/simulation/fem_case/resolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

namespace fretval {

using nlohmann::ordered_json;

namespace {

constexpr double finest_edge_ring = 2e-6;  // gmsh tells nodes apart down to some 1e-7 of the contact line

auto key(const Resolution& r) {
  return std::make_tuple(r.elements_per_radius, r.degree, r.growth, r.far_radius, r.steps_per_cycle, r.n_ramp_cycles,
                         r.periodicity, r.n_creep_cycles, r.worn_edge_ring, r.surface_growth, r.wear_jump,
                         r.edge_before_node, r.focus.has_value(), r.focus ? r.focus->inner : 0,
                         r.focus ? r.focus->outer : 0, r.focus ? r.focus->ring : 0, r.n_angles, r.mesh_refinements,
                         r.first_step);
}

}  // namespace

Resolution with_rings(Resolution r, double factor) {
  r.elements_per_radius = static_cast<unsigned>(r.elements_per_radius * factor);
  r.worn_edge_ring = std::max(r.worn_edge_ring / (factor * factor), finest_edge_ring);
  r.surface_growth /= factor;
  if (r.focus) r.focus->ring /= factor;
  return r;
}

Resolution with_steps(Resolution r, double factor) {
  r.steps_per_cycle = static_cast<int>(r.steps_per_cycle * factor);
  return r;
}

Resolution with_angles(Resolution r, double factor) {
  r.n_angles = std::max(1U, static_cast<unsigned>(r.n_angles * factor) / 4) * 4;
  return r;
}

bool Resolution::operator<(const Resolution& other) const {
  return key(*this) < key(other);
}

bool Resolution::operator==(const Resolution& other) const {
  return key(*this) == key(other);
}

std::string text_of(const Resolution& r) {
  if (r.mesh_refinements)
    return fmt::format("{} rings, degree {}, mesh refined {} times, {} steps, {} ramp cycles", r.elements_per_radius,
                       r.degree, *r.mesh_refinements, r.steps_per_cycle, r.n_ramp_cycles);
  auto text = fmt::format("{} rings, degree {}, growth {:g}, far {:g}, {} steps, {} ramp cycles", r.elements_per_radius,
                          r.degree, r.growth, r.far_radius, r.steps_per_cycle, r.n_ramp_cycles);
  if (r.focus)
    text += fmt::format(", rings of {:.2g} from {:.6g} to {:.6g}", r.focus->ring, r.focus->inner, r.focus->outer);
  return text;
}

std::string change_text(const Resolution& before, const Resolution& after) {
  const auto side = [&](const Resolution& r) {
    return before.n_creep_cycles == after.n_creep_cycles
               ? text_of(r)
               : fmt::format("{}, {} creep cycles", text_of(r), r.n_creep_cycles);
  };
  return fmt::format("from {} to {}", side(before), side(after));
}

Resolution resolution_for(double tolerance, bool memory) {
  // What the rings at a worn edge let through is about a tenth of sqrt(2 ring/c) of the force.
  const double worn_edge_ring = std::max(5 * tolerance * tolerance, finest_edge_ring);
  const auto ramp = [memory](int n_cycles) { return memory ? n_cycles : 1; };
  if (tolerance >= 1e-2) return {24, 3, 0.5, 12, 32, ramp(4), 1e-4, 24, worn_edge_ring};
  if (tolerance >= 1e-3) return {32, 3, 0.5, 12, 72, ramp(8), 1e-5, 48, worn_edge_ring};
  return {48, 3, 0.3, 20, 72, ramp(12), 1e-6, 96, worn_edge_ring};
}

ordered_json focus_json(const Focus& focus) {
  return {{"inner", focus.inner}, {"outer", focus.outer}, {"ring", focus.ring}};
}

ordered_json resolution_json(const Resolution& r) {
  ordered_json json{{"elements_per_radius", r.elements_per_radius},
                    {"degree", r.degree},
                    {"growth", r.growth},
                    {"far_radius", r.far_radius},
                    {"steps_per_cycle", r.steps_per_cycle},
                    {"ramp_cycles", r.n_ramp_cycles},
                    {"periodicity", r.periodicity}};
  if (r.mesh_refinements) json["mesh_refinements"] = *r.mesh_refinements;
  if (r.focus) json["focus"] = focus_json(*r.focus);
  return json;
}

}  // namespace fretval
