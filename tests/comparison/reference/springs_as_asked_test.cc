#include "comparison/reference/springs_as_asked.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "comparison/reference/mdr_answer.h"
#include "tests/comparison/read_case.h"

namespace fretval::springs_as_asked_test {
namespace {

// With errors that fall by an order.
TEST(SpringsAsAsked, AreTheFewestThatAreEnough) {
  const auto fewest = [](double excess, double order) {
    return refined_until_known([=](int times) { return excess / std::pow(times, order); },
                               [](int times) { return times; });
  };
  EXPECT_EQ(fewest(1, 2), 1);
  EXPECT_EQ(fewest(15, 2), 4);
  EXPECT_EQ(fewest(63, 2), 8);
}

// Where errors hardly fall the last doublings, which take longest, would be in vain: a half each is hoped for at least.
TEST(SpringsAsAsked, AreNotMoreThanThereIsHopeFor) {
  const auto most = [](std::vector<double> excesses) {
    return refined_until_known([&](int times) { return excesses.at(static_cast<std::size_t>(std::log2(times))); },
                               [](int times) { return times; });
  };
  EXPECT_EQ(most({5, 4.1}), 2);
  EXPECT_EQ(most({5, 3.9, 2.1}), 4);
  EXPECT_EQ(most({5, 3.9, 1.9, 0.9}), 8);
  EXPECT_EQ(most({50, 10, 6, 1}), 4) << "once by 5, which is not enough";
  EXPECT_EQ(most({50, 10, 4, 2}), 8);
}

Case on_a_layer(double tolerance) {
  auto input = read_case(elastic_case());
  input.body.shape = Case::Body::Shape::layer;
  input.body.thickness = 2e-3;
  input.tolerance = tolerance;
  return input;
}

// A tolerance that MDR's own answer does not meet could be met by no finite elements.
TEST(SpringsAsAsked, OfALayerAreKnownToAQuarterOfTheTolerance) {
  const auto answer_to = [](double tolerance) {
    const auto mdr = mdr_case(on_a_layer(tolerance));
    return mdr_answer(mdr, mdr_normal_response(mdr));
  };
  const auto usual = answer_to(1e-2), fine = answer_to(4e-5);
  const double a = fine.contact_radius_max.value(), force = fine.normal_force_max.value();
  EXPECT_GT(usual.normal_force_error, 1e-6 * force);
  EXPECT_LE(fine.normal_force_error, 1e-6 * force);
  EXPECT_LE(fine.stepped.first_slip, 1e-5 * a);
  EXPECT_LE(fine.stepped.shakedown, 1e-5 * a);
  EXPECT_NEAR(usual.normal_force_max.value(), force, usual.normal_force_error);
  EXPECT_NEAR(usual.stick_radius_shakedown.value(), fine.stick_radius_shakedown.value(), usual.stepped.shakedown);
}

// Under a normal force and without a period the oscillations that springs go through leave nearly all of their error:
// springs that were only finer came no nearer to a quarter of the tolerance, and took forty times as long.
TEST(SpringsAsAskedSlow, OfAnUnlockedPhaseAreKnownToAQuarterOfTheTolerance) {
  auto text = replace(valid_case, "parabola\n  set Radius = 1e-2", "cone\n  set Slope angle = 5");
  text = replace(text, "Indentation = 1e-4", "Normal force = 0.3");
  text = replace(text, "Normal amplitude = 2e-5", "Normal force amplitude = 0.06");
  text = replace(text, "Tangential amplitude = 1.5e-5", "Tangential amplitude = 1e-5");
  text = replace(text, "Phase = 60", "Phase = free");
  const auto input = read_case(replace(text, "Tolerance = 0.01", "Tolerance = 1e-3"));
  const auto mdr = mdr_case(input);
  const auto answer = mdr_answer(mdr, mdr_normal_response(mdr));
  EXPECT_LE(answer.stepped.first_slip, input.tolerance / 4 * answer.contact_radius_max.value());
}

TEST(SpringsAsAsked, OfALineAreFewer) {
  auto mdr = mdr_case(read_case());
  mdr.coarser_springs = 2;
  const auto springs = fineness_of(mdr, mdr::SpringFineness{200, 180, 4, 1e-8, 48}, 1);
  EXPECT_EQ(springs.n_springs, 100);
  EXPECT_EQ(springs.steps_per_oscillation, 90);
  EXPECT_EQ(springs.n_ramp_periods, 4);
  EXPECT_EQ(springs.n_oscillations, 48);
  const auto along_path = fineness_of(mdr, mdr::PathFineness{200, 180, 10, 1e-8, 1}, 4);
  EXPECT_EQ(along_path.n_springs, 400);
  EXPECT_EQ(along_path.steps_per_duration * along_path.subdivisions, 360);
}

TEST(SpringsAsAsked, ThatNobodyAsksAreEnough) {
  auto mdr = mdr_case(on_a_layer(1e-3));
  EXPECT_NEAR(excess_of_normal_force(mdr, 2, 1e-4), 2, 1e-12);
  mdr.tolerance = 0;
  EXPECT_EQ(excess_of_normal_force(mdr, 1, 1), 0);
}

}  // namespace
}  // namespace fretval::springs_as_asked_test
