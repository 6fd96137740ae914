#pragma once

#include "comparison/reference/mdr_answer.h"
#include "comparison/simulation/compute_case.h"
#include "tests/comparison/suite_case.h"

namespace fretval {

/// What finite elements say at the resolution that the case asks for.
inline FeAnswer simulate_case(const Case& scene) {
  const auto mdr = mdr_case(scene);
  const auto fem = fem_case(scene, mdr);
  BodyStore bodies;
  return compute_case(fem, fem.resolution, bodies);
}

/// A case of the tolerance suite with rings and steps of its own.
inline Case fixed_case(const std::string& name, unsigned rings, int steps) {
  auto scene = suite_case(name, 1e-2);
  scene.rings_per_radius = rings;
  scene.steps_per_cycle = steps;
  return scene;
}

inline MdrAnswer exact_answer(const Case& scene) {
  const auto mdr = mdr_case(scene);
  return mdr_answer(mdr, mdr_normal_response(mdr));
}

}  // namespace fretval
