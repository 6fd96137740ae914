#include "comparison/reference/normal_responses.h"

#include <gtest/gtest.h>

#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

std::shared_ptr<const mdr::NormalResponse> response_of(NormalResponses& responses, const Case& input) {
  return responses.of(input, mdr_case(input));
}

TEST(NormalResponses, AreSharedByCasesThatDifferTangentially) {
  NormalResponses responses;
  Case input = read_case();
  const auto first = response_of(responses, input);
  input.motion.phase = 17;
  input.motion.tangential_amplitude *= 0.5;
  input.friction_coefficient *= 2;
  EXPECT_EQ(response_of(responses, input), first);
}

TEST(NormalResponses, AreMadeAnewForAnyOtherNormalProblem) {
  NormalResponses responses;
  const Case input = read_case();
  const auto first = response_of(responses, input);
  std::vector<Case> others(5, input);
  others[0].indenter.radius *= 2;
  others[1].elastomer.relaxed_modulus *= 2;
  others[2].elastomer.branch_times[0] *= 2;
  others[3].motion.normal_amplitude *= 0.5;
  others[4] = limiting_case(0.3, input.motion.normal_amplitude);
  for (const auto& other : others) EXPECT_NE(response_of(responses, other)->normal_force_max, first->normal_force_max);
}

}  // namespace
}  // namespace fretval
