#include "comparison/reference/normal_responses.h"

#include <gtest/gtest.h>

#include <set>

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
  std::vector<Case> others(8, input);
  others[0].indenter.radius *= 2;
  others[1].elastomer.relaxed_modulus *= 2;
  others[2].elastomer.branch_times[0] *= 2;
  others[3].motion.normal_amplitude *= 0.5;
  others[4] = limiting_case(0.3, input.motion.normal_amplitude);
  others[5].elastomer.poisson_ratio = 0.3;
  for (auto* other : {&others[6], &others[7]}) other->body.shape = Case::Body::Shape::layer;
  others[6].body.thickness = 1e-3;
  others[7].body.thickness = 2e-3;
  std::set<double> forces{first->normal_force_max};
  for (const auto& other : others) EXPECT_TRUE(forces.insert(response_of(responses, other)->normal_force_max).second);
}

}  // namespace
}  // namespace fretval
