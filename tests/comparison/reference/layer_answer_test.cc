#include "comparison/reference/layer_answer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/reference/mdr_answer.h"
#include "mdr/layer/layer_contact.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/suite_case.h"

namespace fretval::layer_answer_test {
namespace {

Case on_layer(Case scene, double thickness, double poisson_ratio = 0.5) {
  scene.body.shape = Case::Body::Shape::layer;
  scene.body.thickness = thickness;
  scene.elastomer.poisson_ratio = poisson_ratio;
  return scene;
}

MdrAnswer answer_to(const Case& scene) {
  const auto mdr = mdr_case(scene);
  return mdr_answer_with_cycle(mdr, mdr_normal_response(mdr));
}

// A thousand times thicker than the contact is wide: off by a/H.
TEST(LayerAnswer, OfAThickLayerIsThatOfAHalfSpace) {
  const auto scene = suite_case("parabola-elastic-steady", 1e-2);
  for (const double nu : {0.5, 0.3}) {
    auto half_space_scene = scene;
    half_space_scene.elastomer.poisson_ratio = nu;
    const auto half_space = answer_to(half_space_scene), layer = answer_to(on_layer(scene, 1, nu));
    EXPECT_NEAR(layer.contact_radius_max.value() / half_space.contact_radius_max.value(), 1, 2e-3);
    EXPECT_NEAR(layer.normal_force_max.value() / half_space.normal_force_max.value(), 1, 4e-3);
    EXPECT_NEAR(layer.stick_radius_shakedown.value() / half_space.stick_radius_shakedown.value(), 1, 4e-3);
    EXPECT_NEAR(
        layer.cycle->value(Quantity::tangential_force_max) / half_space.cycle->value(Quantity::tangential_force_max), 1,
        1e-2);
  }
}

// Of the map of errors: a/H = 0.5 has 0.696 of Hertz's depth at a given contact radius (an independent computation).
TEST(LayerAnswer, OfAThinLayerIsAnother) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  const double R = scene.indenter.radius, a = 1e-3;
  scene.motion.indentation = 0.696 * a * a / R;
  scene.motion.tangential_amplitude = 0.1 * scene.motion.indentation;
  EXPECT_NEAR(answer_to(on_layer(scene, 2 * a)).contact_radius_max.value() / a, 1, 1e-3);
}

// The balance of forces, mu F_0 over F_x0, knows of no body.
TEST(LayerAnswer, SlidesAsAWholeWhereForcesBalance) {
  auto scene = on_layer(suite_case("parabola-elastic-steady", 1e-2), 1e-2);
  const double force = answer_to(scene).normal_force_max.value();
  scene.motion.normal_force = {force, 0};
  scene.motion.tangential_force = 0.3 * scene.friction_coefficient * force;
  EXPECT_NEAR(answer_to(scene).steady_sliding_share.value(), 1 / 0.3, 1e-12);
}

// An elastic layer under a force: where the layer bears it, to within what the reading says.
TEST(LayerAnswer, UnderAForceIndentsAsFarAsTheLayerLets) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.motion.normal_force = {1, 0.1};
  for (const double thickness : {5e-4, 1e-3, 2e-3}) {
    const auto mdr = mdr_case(on_layer(scene, thickness));
    const auto exact =
        mdr::layer_contact_under_force(mdr.profile, mdr.layer.value(), mdr.body.relaxed_modulus, 1.1).indentation;
    const auto answer = mdr_answer_with_cycle(mdr, mdr_normal_response(mdr));
    EXPECT_NEAR(answer.indentation_max.value() / exact, 1, 1e-6);
    EXPECT_LT(std::abs(answer.indentation_max.value() - exact), answer.stepped.indentation);
    EXPECT_LT(answer.stepped.indentation, 1e-4 * exact);
    // Over a parabola a ~ sqrt(d), over a thin layer less; the radius comes from springs of their own, without
    // friction.
    const double off = answer.stepped.indentation / exact, radius = answer.contact_radius_max.value();
    EXPECT_GT(answer.contact_radius_error, 0.2 * off * radius);
    EXPECT_LT(answer.contact_radius_error, off * radius);
  }
}

TEST(LayerAnswer, HasAnErrorOfTheForceWhereItIsNotPrescribed) {
  auto scene = on_layer(suite_case("parabola-elastic-90", 1e-2), 2e-3);
  EXPECT_GT(layer_normal_response(mdr_case(scene)).normal_force_error, 0);
  EXPECT_EQ(layer_normal_response(mdr_case(scene)).contact_radius_error, 0) << "it follows from the indentation";
  scene.motion.normal_force = {1, 0.1};
  EXPECT_EQ(layer_normal_response(mdr_case(scene)).normal_force_error, 0);
  EXPECT_FALSE(layer_worn_radius(mdr_case(scene), 5e-4, 1e-4)) << "its limiting state has another indentation";
}

// Under displacements: D(c) = d - A beta for a steady depth, D and beta of the half-space.
TEST(LayerAnswer, OfWearOnAThickLayerEndsInTheStateOfTheHalfSpace) {
  auto scene = on_layer(suite_case("parabola-elastic-steady", 1e-2), 10);
  scene.wear_kinetics = Case::WearKinetics{};
  const auto mdr = mdr_case(scene);
  const auto state = layer_wear_state(mdr, mdr::StickCriterion::shakedown);
  ASSERT_TRUE(state);
  const double R = scene.indenter.radius, d = scene.motion.indentation;
  const double stuck_depth = d - scene.motion.tangential_amplitude / (1.5 * scene.friction_coefficient);
  EXPECT_NEAR(state->stick_radius / std::sqrt(R * stuck_depth), 1, 1e-3);
  EXPECT_NEAR(mdr::maximum_indentation(state->motion) / d, 1, 1e-12);
}

/// A pass that pushes sideways at a depth.
Case push_on(const Case& layer, double displacement) {
  auto scene = layer;
  const double d = scene.motion.indentation;
  Case::Path path;
  path.file = "push.csv";
  path.time = {0, 1};
  path.normal = {d, d};
  path.tangential = {0, displacement};
  scene.motion.path = path;
  return scene;
}

// A single pass on a layer leaves the stick zone of the first quarter of the oscillation with its amplitude.
TEST(LayerAnswer, OfAPushIsThatOfTheOscillationThatBeginsWithIt) {
  auto scene = on_layer(suite_case("parabola-elastic-steady", 1e-2), 2e-3, 0.45);
  const auto oscillates = answer_to(scene), pushed = answer_to(push_on(scene, scene.motion.tangential_amplitude));
  EXPECT_TRUE(is_pass(pushed.motion_kind));
  EXPECT_NEAR(pushed.contact_radius_max.value() / oscillates.contact_radius_max.value(), 1, 1e-6);
  EXPECT_NEAR(pushed.stick_radius_first_slip.value() / oscillates.stick_radius_first_slip.value(), 1, 2e-3);
  EXPECT_NEAR(
      pushed.cycle->value(Quantity::tangential_force_max) / oscillates.cycle->value(Quantity::tangential_force_max), 1,
      2e-3);
}

TEST(LayerAnswer, IsRefusedByNameForWhatItDoesNotCompute) {
  auto scene = on_layer(suite_case("parabola-elastic-steady", 1e-2), 1e-2);
  scene.wear_kinetics = Case::WearKinetics{};
  EXPECT_NO_THROW(mdr_case(scene));
  auto two_frequencies = scene;
  two_frequencies.motion.phase = 0;
  two_frequencies.motion.tangential_frequency *= 2;
  expect_parts(refusal([&] { mdr_case(two_frequencies); }),
               {"Motion / Tangential frequency", "wear over a layer under two frequencies", "leave the Body out"});
  auto limiting = on_layer(suite_case("parabola-elastic-steady", 1e-2), 1e-2);
  limiting.wear = Case::Wear::limiting;
  expect_parts(refusal([&] { mdr_case(limiting); }), {"Wear / State = limiting", "over a layer"});
}

}  // namespace
}  // namespace fretval::layer_answer_test
