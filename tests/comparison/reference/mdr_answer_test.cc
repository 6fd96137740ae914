#include "comparison/reference/mdr_answer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/comparison/computed_case.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

// Hertz at the largest indentation: F = 16/3 G sqrt(R d^3).
TEST(MdrAnswer, OfAnElasticSphereIsHertzs) {
  const auto scene = read_case(elastic_case());
  const auto answer = exact_answer(scene);
  const double R = scene.indenter.radius, d = scene.motion.indentation + scene.motion.normal_amplitude;
  EXPECT_EQ(answer.modulus_ratio, 1);
  EXPECT_NEAR(answer.contact_radius_max.value() / std::sqrt(R * d), 1, 1e-9);
  EXPECT_NEAR(answer.normal_force_max.value() / (16e6 / 3 * std::sqrt(R * d * d * d)), 1, 1e-9);
  EXPECT_GE(answer.worn_radius.value(), answer.contact_radius_max.value());
}

TEST(MdrAnswer, SaysNullWhereNothingSticks) {
  const auto answer = exact_answer(read_case(replace(valid_case, "amplitude = 1.5e-5", "amplitude = 5e-4")));
  const auto json = to_json(answer);
  for (const char* key : {"stick_radius_first_slip", "stick_radius_shakedown", "worn_radius"})
    EXPECT_TRUE(json.at(key).is_null()) << key;
  EXPECT_TRUE(json.at("normal_force_max").is_number());
}

TEST(MdrAnswer, OfAWornProfileSticksNoFurtherThanItTouches) {
  Case input = limiting_case(0.3, 2e-6);
  EXPECT_TRUE(exact_answer(input).wears_no_more());
  input.motion.tangential_amplitude = 1e-6;
  const auto answer = exact_answer(input);
  EXPECT_TRUE(answer.wears_no_more());
  EXPECT_EQ(answer.stick_radius_shakedown, answer.contact_radius_max);
  EXPECT_EQ(answer.stick_radius_first_slip, answer.contact_radius_max);
  EXPECT_EQ(answer.worn_radius, mdr_case(input).limiting->outer_radius);
}

TEST(WornProfile, IsTheIndenterThatIsWornAlready) {
  const auto worn = mdr_case(limiting_case(0.5)), unworn = mdr_case(read_case());
  EXPECT_EQ(worn_profile(worn, 1e-4)->stick_radius, worn.limiting->stick_radius);
  EXPECT_EQ(worn_profile(unworn, 1e-4)->stick_radius, 1e-4);
  EXPECT_FALSE(worn_profile(unworn, std::nullopt));
}

}  // namespace
}  // namespace fretval
