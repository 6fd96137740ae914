#pragma once

#include "comparison/reference/mdr_answer.h"
#include "comparison/simulation/compute_case.h"
#include "tests/comparison/shared_bodies.h"
#include "tests/comparison/suite_case.h"

namespace fretval {

/// What finite elements say at the resolution that the case asks for.
inline FeAnswer simulate_case(const Case& input) {
  const auto mdr = mdr_case(input);
  const auto fem = fem_case(input, expected_contact(mdr), limiting_indenter(mdr));
  return compute_case(fem, fem.resolution, shared_bodies());
}

/// A case of the tolerance suite with rings and steps of its own.
inline Case fixed_case(const std::string& name, unsigned rings, int steps) {
  auto input = suite_case(name, 1e-2);
  input.rings_per_radius = rings;
  input.steps_per_cycle = steps;
  return input;
}

inline MdrAnswer exact_answer(const Case& input) {
  const auto mdr = mdr_case(input);
  return mdr_answer(mdr, mdr_normal_response(mdr));
}

}  // namespace fretval
