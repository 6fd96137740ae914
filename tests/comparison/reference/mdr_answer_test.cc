#include "comparison/reference/mdr_answer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/data/path_table.h"
#include "comparison/reference/mdr_readings.h"
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

MdrAnswer answer_with_cycle(const Case& scene) {
  const auto mdr = mdr_case(scene);
  return mdr_answer_with_cycle(mdr, mdr_normal_response(mdr));
}

// Mindlin and Deresiewicz: what a loop between +-u_x0 at constant normal force costs, and the force at its ends.
TEST(MdrAnswer, OfACycleIsMindlinAndDeresiewiczs) {
  auto scene = read_case(elastic_case());
  scene.motion.normal_amplitude = 0;
  const double R = scene.indenter.radius, d = scene.motion.indentation, mu = scene.friction_coefficient,
               sliding = 1.5 * mu * d, force = 16e6 / 3 * std::sqrt(R * d * d * d),
               x = scene.motion.tangential_amplitude / sliding;
  ASSERT_LT(x, 1);
  EXPECT_FALSE(exact_answer(scene).cycle) << "closed forms alone";
  const auto cycle = answer_with_cycle(scene).cycle.value();
  const double work =
      mu * force * sliding * (8 * (x - 0.4 * (1 - std::pow(1 - x, 2.5))) - 4 * x * (1 - std::pow(1 - x, 1.5)));
  EXPECT_NEAR(cycle.value(Quantity::tangential_force_max) / (mu * force * (1 - std::pow(1 - x, 1.5))), 1, 1e-4);
  EXPECT_NEAR(cycle.value(Quantity::friction_work) / work, 1, 2e-3);
  EXPECT_LE(std::abs(cycle.value(Quantity::friction_work) - work), cycle.uncertainty(Quantity::friction_work));
  EXPECT_EQ(cycle.value(Quantity::bulk_work), 0);
  EXPECT_NEAR(cycle.value(Quantity::tangential_work) / cycle.value(Quantity::friction_work), 1, 1e-3);
  EXPECT_NEAR(cycle.value(Quantity::tangential_force_mean), 0, 1e-9 * mu * force);
  EXPECT_NEAR(cycle.sliding_work, 4 * mu * force * x * sliding, 1e-6 * mu * force * sliding);
}

TEST(MdrAnswer, HasSpringsForTheToleranceOfACycle) {
  auto scene = read_case(elastic_case());
  scene.elastomer.rheology = Case::Rheology::kelvin_voigt;
  scene.elastomer.viscosity = 5e4;
  const auto usual = answer_with_cycle(scene).cycle.value();
  EXPECT_EQ(usual.readings.count(Quantity::tangential_force_max), 0U);
  scene.cycle_tolerance = usual.uncertainty(Quantity::tangential_work) / usual.value(Quantity::tangential_work);
  const auto fine = answer_with_cycle(scene).cycle.value();
  EXPECT_EQ(fine.readings.count(Quantity::tangential_force_max), 1U);
  EXPECT_LE(fine.uncertainty(Quantity::tangential_work) / fine.value(Quantity::tangential_work),
            *scene.cycle_tolerance / 4);
  EXPECT_LE(fine.uncertainty(Quantity::friction_work) / fine.value(Quantity::bulk_work), *scene.cycle_tolerance / 4);
  EXPECT_LE(fine.uncertainty(Quantity::tangential_force_mean) / fine.value(Quantity::tangential_force_max),
            *scene.cycle_tolerance / 4);
  EXPECT_LE(std::abs(fine.value(Quantity::tangential_work) - usual.value(Quantity::tangential_work)),
            usual.uncertainty(Quantity::tangential_work));
}

/// The elastic case along a path of forces.
Case along_forces(std::vector<double> normal, std::vector<double> tangential) {
  auto scene = read_case(elastic_case());
  Case::Path path{{{}, std::move(normal), std::move(tangential), false, true, true}, "rows.csv"};
  for (std::size_t k = 0; k < path.normal.size(); ++k) path.time.push_back(5 + static_cast<double>(k));
  scene.motion = motion_along(path);
  return scene;
}

// Hertz; Cattaneo and Mindlin: F(c) = F_N - F_x/mu, u_x = (3 mu/2)(d(F_N) - d(F(c))).
TEST(MdrAnswer, OfAPassOfForcesIsCattaneosAndMindlins) {
  const auto scene = along_forces({0.5, 0.5}, {0, 0.1});
  const auto answer = answer_with_cycle(scene);
  const double R = scene.indenter.radius, mu = scene.friction_coefficient;
  const auto depth = [&](double force) { return std::pow(3 * force / (16e6 * std::sqrt(R)), 2.0 / 3); };
  const double d = depth(0.5), stuck = depth(0.5 - 0.1 / mu);
  EXPECT_TRUE(is_pass(answer.motion_kind));
  EXPECT_FALSE(answer.stick_radius_shakedown || answer.worn_radius);
  EXPECT_NEAR(answer.indentation_max.value() / d, 1, 1e-5);
  EXPECT_NEAR(answer.contact_radius_max.value() / std::sqrt(R * d), 1, 1e-5);
  EXPECT_NEAR(answer.stick_radius_first_slip.value() / std::sqrt(R * stuck), 1, 1e-5);
  EXPECT_NEAR(answer.tangential_amplitude.value() / (0.75 * mu * (d - stuck)), 1, 1e-4);
  EXPECT_NEAR(answer.cycle.value().sliding_work / (mu * 0.5 * 1.5 * mu * (d - stuck)), 1, 1e-4);
  EXPECT_LT(answer.stepping_error, 1e-4);
}

TEST(MdrAnswer, OfAPassSaysWhenItSlides) {
  const auto answer = answer_with_cycle(along_forces({0.5, 0.3}, {0, 0.2}));
  EXPECT_NEAR(answer.as<GrossSlipShare>()->time.value(), 5 + 5.0 / 6, 1e-9);
  EXPECT_FALSE(answer.stick_radius_first_slip);
}

// The springs lose what the indenter puts in.
TEST(MdrAnswer, OfABodyWithADashpotHasWhatIsLost) {
  auto scene = read_case(elastic_case());
  scene.elastomer.rheology = Case::Rheology::kelvin_voigt;
  scene.elastomer.viscosity = 5e4;
  const auto answer = answer_with_cycle(scene);
  ASSERT_TRUE(answer.cycle);
  EXPECT_FALSE(answer.slip_decay);
  // Of the indenter that only presses, 4 pi omega eta a Delta d^2 with a between both extremes of it.
  const double rate = 2 * std::acos(-1.0) * scene.motion.normal_frequency, depth = scene.motion.indentation,
               amplitude = scene.motion.normal_amplitude, radius = std::sqrt(scene.indenter.radius * depth),
               pressed = 8 * std::acos(-1.0) * rate * 5e4 * radius * amplitude * amplitude;
  EXPECT_GT(answer.cycle->value(Quantity::bulk_work), 0.8 * pressed);
  EXPECT_LT(answer.cycle->value(Quantity::bulk_work), 1.5 * pressed);
  EXPECT_GT(answer.cycle->value(Quantity::tangential_work), answer.cycle->value(Quantity::friction_work));
  EXPECT_LT(answer.cycle->uncertainty(Quantity::friction_work), 0.02 * answer.cycle->value(Quantity::bulk_work));
}

// A second harmonic of next to nothing: springs that are stepped, held against the closed form of one.
TEST(MdrAnswer, OfSeveralHarmonicsSaysWhatItsLargestForceMayBeOff) {
  auto scene = read_case(elastic_case());
  scene.elastomer.rheology = Case::Rheology::kelvin_voigt;
  scene.elastomer.viscosity = 5e4;
  const auto one = exact_answer(scene);
  EXPECT_EQ(one.normal_force_error, 0);
  scene.motion.normal_harmonics = {{1e-12 * scene.motion.normal_amplitude, 2 * scene.motion.normal_frequency, 0}};
  const auto stepped = exact_answer(scene);
  EXPECT_GT(stepped.normal_force_error, 0);
  EXPECT_LT(stepped.normal_force_error, 1e-5 * *one.normal_force_max);
  EXPECT_NEAR(*stepped.normal_force_max, *one.normal_force_max, 2 * stepped.normal_force_error);
}

TEST(MdrAnswer, OfAStandardSolidSaysHowSlipDiesOut) {
  const auto scene = read_case();
  const double q = std::exp(-1 / (0.1 * scene.motion.normal_frequency));
  EXPECT_NEAR(answer_with_cycle(scene).slip_decay.value(), (1 + q) / 2, 1e-12);
}

TEST(MdrAnswer, SaysAfterHowManyCyclesSlipHasEnded) {
  const auto cycles = [](const Case& scene, int n_ramp) {
    const auto mdr = mdr_case(scene);
    return settling_cycles(mdr, answer_with_cycle(scene), n_ramp);
  };
  const auto scene = read_case();
  const auto four = cycles(scene, 4), eight = cycles(scene, 8);
  ASSERT_TRUE(four && eight);
  EXPECT_LT(four->error, 0.3);
  EXPECT_GT(four->cycles, 2);
  EXPECT_GT(eight->cycles, four->cycles);
  EXPECT_FALSE(cycles(read_case(elastic_case()), 4));
}

TEST(MdrAnswer, HasNoCycleWithoutALockedMotion) {
  auto scene = read_case(elastic_case());
  scene.motion.phase.reset();
  EXPECT_FALSE(answer_with_cycle(scene).cycle);
}

}  // namespace
}  // namespace fretval
