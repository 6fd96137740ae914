#pragma once

#include "comparison/reference/mdr_answer.h"

namespace fretval {

/// How thick a body that is bonded to a rigid base has to be to count as a half-space: from here on the contact radius
/// at the largest indentation or, where it is prescribed, under the largest normal force, is that of a half-space but
/// for a share of it. In m, to three digits, by MDR for layers. share: 1e-3 to 0.5.
double thickness_of_half_space(const MdrCase& mdr, double poisson_ratio, double share);

/// MDR's answers to a case.
struct MdrAnswers {
  MdrAnswer own;                             ///< with its own body
  std::optional<MdrAnswer> half_space = {};  ///< of a layer: with a half-space in its place, without the cycle
};

/// MDR's answer to the case with a half-space in the place of its body, without the cycle.
MdrAnswer half_space_answer(const Case& input);

}  // namespace fretval
