#include "comparison/simulation/fem_case/resolution_json.h"

#include <nlohmann/json.hpp>

namespace fretval {

using nlohmann::ordered_json;

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
