#include "comparison/reference/springs_as_asked.h"

#include <gtest/gtest.h>

#include "comparison/reference/mdr_answer.h"
#include "tests/comparison/read_case.h"

namespace fretval::springs_as_asked_test {
namespace {

TEST(SpringsAsAsked, AreTheFewestThatAreEnough) {
  const auto fewest = [](int enough) {
    return refined_until_known([=](int times) { return times >= enough; }, [](int times) { return times; });
  };
  EXPECT_EQ(fewest(1), 1);
  EXPECT_EQ(fewest(3), 4);
  EXPECT_EQ(fewest(100), 8);
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

TEST(SpringsAsAsked, ThatNobodyAsksAreEnough) {
  auto mdr = mdr_case(on_a_layer(1e-3));
  EXPECT_FALSE(knows_normal_force(mdr, 1, 3e-5));
  EXPECT_TRUE(knows_normal_force(mdr, 1, 2e-5));
  mdr.tolerance = 0;
  EXPECT_TRUE(knows_normal_force(mdr, 1, 1));
}

}  // namespace
}  // namespace fretval::springs_as_asked_test
