#include "comparison/trust/ladder.h"

#include <gtest/gtest.h>

#include "mdr/layer/layer_contact.h"
#include "mdr/profiles/power_law.h"
#include "tests/comparison/some_cycle.h"
#include "tests/comparison/suite_case.h"

namespace fretval::ladder_test {
namespace {

Case on_layer(double thickness, double poisson_ratio) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.body.shape = Case::Body::Shape::layer;
  scene.body.thickness = thickness;
  scene.elastomer.poisson_ratio = poisson_ratio;
  return scene;
}

TEST(Rungs, DropOneAssumptionEach) {
  const auto of_mdr = rungs_of(suite_case("parabola-elastic-steady", 1e-2));
  ASSERT_EQ(of_mdr.size(), 1U);
  EXPECT_EQ(of_mdr[0].key, "friction");
  EXPECT_TRUE(of_mdr[0].input.contact.vector_friction);
  EXPECT_FALSE(of_mdr[0].input.contact.coupled);
  const auto rungs = rungs_of(on_layer(3e-3, 0.4));
  ASSERT_EQ(rungs.size(), 3U);
  EXPECT_FALSE(rungs[0].input.contact.is_full());
  EXPECT_TRUE(rungs[2].input.body.is_half_space());
  EXPECT_EQ(rungs[0].key, "body");
  EXPECT_EQ(rungs[0].input.elastomer.poisson_ratio, 0.5);
  EXPECT_EQ(rungs[0].input.body.thickness, 3e-3);
  EXPECT_EQ(rungs[1].key, "poisson_ratio");
  EXPECT_TRUE(rungs[1].input.body.is_half_space());
  EXPECT_EQ(rungs[1].input.elastomer.poisson_ratio, 0.4);
  const auto own = case_for_mdr(on_layer(3e-3, 0.4));
  EXPECT_TRUE(own.body.is_half_space());
  EXPECT_EQ(own.elastomer.poisson_ratio, 0.5);
}

// A harmonic without an amplitude is no motion that friction could have a direction in.
TEST(Rungs, HaveNoFrictionWhereNothingMovesTangentially) {
  auto still = suite_case("parabola-elastic-steady", 1e-2);
  still.motion.tangential_amplitude = 0;
  still.motion.tangential_harmonics = {{0, 2, 0}};
  EXPECT_TRUE(rungs_of(still).empty());
  still.motion.tangential_harmonics = {{1e-6, 2, 0}};
  EXPECT_EQ(rungs_of(still).size(), 1U);
}

TEST(Rungs, AreCoupledOnlyWhereTheBodyIs) {
  EXPECT_FALSE(coupled_case(suite_case("parabola-elastic-steady", 1e-2)));
  const auto coupled = coupled_case(on_layer(3e-3, 0.5));
  ASSERT_TRUE(coupled);
  EXPECT_TRUE(coupled->contact.coupled);
  EXPECT_EQ(coupled->body.thickness, 3e-3);
  auto by_force = on_layer(3e-3, 0.4);
  by_force.motion.tangential_amplitude = 0;
  by_force.motion.tangential_force = 1;
  by_force.motion.normal_force = Case::NormalForce{2, 0.1};
  EXPECT_TRUE(coupled_case(by_force));
  EXPECT_EQ(rungs_of(by_force).size(), 3U);
  by_force.motion.phase.reset();
  EXPECT_FALSE(coupled_case(by_force)) << "friction as a vector has a fixed phase";
  EXPECT_EQ(rungs_of(by_force).size(), 2U);
}

TEST(Rungs, SayWhichBodyItIs) {
  auto scene = on_layer(3e-3, 0.5);
  EXPECT_EQ(rungs_of(scene).front().title, "a layer 3 mm thick");
  scene.body.is_bonded = false;
  EXPECT_EQ(rungs_of(scene).front().title, "a layer 3 mm thick on a frictionless base");
  scene.body.shape = Case::Body::Shape::cylinder;
  scene.body.radius = 8e-3;
  scene.body.is_bonded = true;
  EXPECT_EQ(rungs_of(scene).front().title, "a cylinder 3 mm thick, of radius 8 mm");
}

// MDR's own radius is sqrt(R d); that of the layer comes from springs that it couples, which no finite element enters.
TEST(Ladder, KnowsHowFarMdrIsOffOverALayer) {
  auto scene = on_layer(2e-3, 0.5);
  scene.motion.tangential_amplitude = 0;
  BodyStore bodies;
  const auto ladder = ladder_of(scene, bodies);
  ASSERT_EQ(ladder.rungs.size(), 1U);
  const auto& off = ladder.whole.off_by.at(Quantity::contact_radius_max);
  const double R = scene.indenter.radius, d = scene.motion.indentation, own = std::sqrt(R * d),
               layer =
                   mdr::layer_contact_at_depth(mdr::parabola(R), {2e-3, 0.5, mdr::LayerBase::bonded}, d).contact_radius;
  EXPECT_NEAR(off.value, own / layer - 1, off.uncertainty);
  EXPECT_LT(off.uncertainty, 2e-3);
  EXPECT_TRUE(off.is_resolved());
  EXPECT_FALSE(ladder.not_computed.empty());
}

// MDR's body and no tangential motion: it is the case.
TEST(Ladder, ResolvesNothingWhereMdrsAssumptionsHold) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.motion.tangential_amplitude = 0;
  BodyStore bodies;
  const auto ladder = ladder_of(scene, bodies);
  EXPECT_TRUE(ladder.rungs.empty());
  for (const auto& [quantity, off] : ladder.whole.off_by) EXPECT_LT(std::abs(off.value), 2e-2) << name_of(quantity);
}

// A boundary-element code has the never-slipped zone of a push 0.5 to 4 % below Cattaneo's (docs/theory.md).
TEST(Ladder, KnowsThatVectorFrictionLetsLessStick) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  BodyStore bodies;
  const auto ladder = ladder_of(scene, bodies);
  ASSERT_EQ(ladder.rungs.size(), 1U);
  const auto& off = ladder.rungs[0].off_by.at(Quantity::stick_radius_first_slip);
  EXPECT_GT(off.value, 0);
  EXPECT_LT(off.value, 0.06);
}

// E* = 2 G/(1 - nu): at a given depth the force of MDR's own model is 2 (1 - nu) of the true one.
TEST(Ladder, KnowsWhatPoissonsRatioMakesOfTheForce) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.elastomer.poisson_ratio = 0.3;
  scene.motion.tangential_amplitude = 0;
  BodyStore bodies;
  const auto ladder = ladder_of(scene, bodies);
  const auto& off = ladder.whole.off_by.at(Quantity::normal_force_max);
  EXPECT_NEAR(off.value, 2 * (1 - 0.3) - 1, off.uncertainty);
  EXPECT_NEAR(ladder.whole.off_by.at(Quantity::contact_radius_max).value, 0, 2e-3);
}

TEST(OffBy, IsResolvedAboveItsUncertainty) {
  const OffBy off{{2.0}, 0.25, 0.01};
  EXPECT_TRUE(off.is_resolved());
  EXPECT_FALSE((OffBy{{2.0}, 0.01, 0.02}).is_resolved());
}

// A radius of 2 mm that finite elements know to 0.01 of 1 mm beside one of 1 mm that MDR knows to 4 um: half of the
// truth, by 0.5 of 1e-5/2e-3 and 4e-6/2e-3. The mean force is what slip has locked in, and no relative error has a
// meaning for it.
TEST(OffBy, HasTheUncertaintiesOfBothMethods) {
  ProvedAnswer answer{};
  answer.fe.contact_radius_max = 2e-3;
  answer.fe.cycle = some_cycle({0.5, 0.25, 1e-5, 0, 1e-5});
  ErrorBar bar;
  bar.add(ErrorSource::rings, 0.01);
  answer.budget[Quantity::contact_radius_max] = bar;
  const Readings mdr{{Quantity::contact_radius_max, {1e-3, 4e-6}},
                     {Quantity::tangential_force_max, {0.25}},
                     {Quantity::tangential_force_mean, {0.5}}};
  const auto all = off_by(mdr, answer, {1e-3, 1e-4, 1e6, 1});
  const auto& radius = all.at(Quantity::contact_radius_max);
  EXPECT_NEAR(radius.value, -0.5, 1e-12);
  EXPECT_NEAR(radius.uncertainty, 0.0025 + 0.002, 1e-12);
  EXPECT_NEAR(all.at(Quantity::tangential_force_max).value, -0.5, 1e-12);
  EXPECT_EQ(all.count(Quantity::tangential_force_mean), 0U);
}

// (1 - 2 nu)/(2 (1 - nu)) over a half-space; over a layer that of nu = 1/2 has a maximum near kH = 1.
TEST(NotComputed, KnowsTheOrderOfWhatIsMissing) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  const auto names = [](const Case& input) {
    std::string all;
    for (const auto& one : not_computed_in(input, 1e-3)) all += one.assumption + ": " + one.order + "; ";
    return all;
  };
  EXPECT_EQ(names(scene).find("coupled"), std::string::npos);
  EXPECT_EQ(names(on_layer(1e-3, 0.5)).find("coupled"), std::string::npos);  // a rung
  scene.motion.phase.reset();
  scene.elastomer.poisson_ratio = 0.3;
  scene.friction_coefficient = 1;
  EXPECT_NE(names(scene).find("coupled: mu times the coupling of the surface at a wave of the contact radius: 0.29"),
            std::string::npos)
      << names(scene);
  auto unlocked = on_layer(1e-3, 0.5);
  unlocked.motion.phase.reset();
  EXPECT_NE(names(unlocked).find("coupled"), std::string::npos);
}

TEST(Ladder, RefusesWear) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.wear_kinetics = Case::WearKinetics{};
  BodyStore bodies;
  EXPECT_THROW(ladder_of(scene, bodies), InputError);
}

}  // namespace
}  // namespace fretval::ladder_test
