#include "comparison/simulation/zone_answer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/simulation/compute_case.h"
#include "mdr/profiles/naive_contact.h"
#include "tests/comparison/damaged_case.h"
#include "tests/comparison/suite_case.h"

namespace fretval::zone_answer_test {
namespace {

const Resolution coarse{48, 2, 0.5, 10, 24, 1, 1e-3};

FeAnswer computed(const FemCase& fem, const Resolution& resolution = coarse) {
  BodyStore bodies;
  return compute_case(fem, resolution, bodies);
}

// Hertz, Cattaneo and Mindlin: what is read without any order has to be what is read in order.
TEST(ZoneAnswer, OfAWholeParabolaIsTheSameInAnyOrder) {
  auto fem = prepare({suite_case("parabola-elastic-90", 1e-2)}).front().fem;
  const auto in_order = computed(fem);
  fem.kind = ContactKind::annuli;
  const auto any = computed(fem);
  ASSERT_TRUE(any.as<ZoneAnswer>());
  EXPECT_FALSE(in_order.as<ZoneAnswer>());
  EXPECT_NEAR(any.normal_force_max / in_order.normal_force_max, 1, 1e-3);
  EXPECT_NEAR(any.contact_radius_max.value() / in_order.contact_radius_max.value(), 1, 1e-3);
  EXPECT_NEAR(any.stick_radius_shakedown.value() / in_order.stick_radius_shakedown.value(), 1, 5e-3);
  EXPECT_NEAR(any.stick_radius_first_slip.value() / in_order.stick_radius_first_slip.value(), 1, 5e-3);
  EXPECT_NEAR(any.cycle->value(Quantity::tangential_force_max) / in_order.cycle->value(Quantity::tangential_force_max),
              1, 5e-3);
  EXPECT_NEAR(any.cycle->value(Quantity::friction_work) / in_order.cycle->value(Quantity::friction_work), 1,
              0.1);  // a few rings slip
  ASSERT_EQ(any.as<ZoneAnswer>()->contact.size(), 1U);
  EXPECT_EQ(any.as<ZoneAnswer>()->contact_uncertainty, 0);
}

// F = 16/3 G sqrt(R) d^(3/2), a = sqrt(R d): what is beyond the contact changes nothing.
TEST(ZoneAnswer, AGrooveBeyondTheContactChangesNothing) {
  const auto prepared = prepared_damaged(groove(1.6, 1.8, 0.03));
  ASSERT_FALSE(prepared.mdr.falls().empty());
  const auto fe = computed(prepared.fem);
  const double R = 1e-2, d = 1.25e-4, G = 1e6;
  EXPECT_NEAR(fe.normal_force_max / (16 * G / 3 * std::sqrt(R * d * d * d)), 1, 1e-3);
  EXPECT_NEAR(fe.contact_radius_max.value() / std::sqrt(R * d), 1, 1e-3);
  const auto springs = mdr::naive_contact(prepared.mdr.profile, d);
  EXPECT_NEAR(springs.force_over_modulus * G / fe.as<ZoneAnswer>()->force_at_rest, 1, 1e-3);
}

// As long as all inside the edge touches, the problem is linear and springs are exact, whether the image falls or not.
TEST(ZoneAnswer, AGrooveThatIsClosedBearsWhatItsSpringsDo) {
  const auto prepared = prepared_damaged(groove(0.5, 0.7, 0.004));
  ASSERT_FALSE(prepared.mdr.falls().empty());
  const auto fe = computed(prepared.fem, with_rings(coarse, 2));
  ASSERT_EQ(fe.as<ZoneAnswer>()->contact.size(), 1U);
  const auto springs = mdr::naive_contact(prepared.mdr.profile, 1.25e-4);
  const auto whole = mdr::naive_contact(mdr::parabola(1e-2), 1.25e-4);
  EXPECT_GT(1 - springs.force_over_modulus / whole.force_over_modulus, 2e-3) << "the groove must be felt";
  EXPECT_NEAR(springs.force_over_modulus * 1e6 / fe.as<ZoneAnswer>()->force_at_rest, 1, 3e-4);
  EXPECT_NEAR(springs.radius / fe.as<ZoneAnswer>()->radius_at_rest, 1, 3e-4);
}

TEST(ZoneAnswer, AnOpenGrooveLeavesADiscAndARing) {
  const auto prepared = prepared_damaged(groove(0.5, 0.7, 0.04));
  const auto fe = computed(prepared.fem, with_rings(coarse, 2));
  const auto& contact = fe.as<ZoneAnswer>()->contact;
  ASSERT_EQ(contact.size(), 2U);
  EXPECT_EQ(contact[0].inner, 0);
  EXPECT_NEAR(contact[0].outer, 0.5e-3, 0.03e-3);
  EXPECT_NEAR(contact[1].inner, 0.7e-3, 0.03e-3);
  EXPECT_EQ(contact[1].outer, fe.contact_radius_max.value());
  EXPECT_NEAR(fe.as<ZoneAnswer>()->radius_at_rest, contact[1].outer, 0.03e-3) << "of all that touches";
  EXPECT_GT(fe.as<ZoneAnswer>()->pressure_max, 0);
  // Sums over all rings, not over the disc in the middle.
  const Eigen::VectorXd sums = fe.normal.pressure.transpose() * Eigen::VectorXd::Ones(fe.normal.pressure.rows());
  EXPECT_GT(sums.minCoeff(), 0);
  double beyond = 0, all = 0;
  const auto& radii = fe.body->radii;
  for (Eigen::Index i = 0; i < fe.normal.pressure.rows(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double force = fe.normal.pressure(i, 0) * (radii[k + 1] * radii[k + 1] - radii[k] * radii[k]);
    all += force;
    if (radii[k] * prepared.fem.units.length > 0.6e-3) beyond += force;
  }
  EXPECT_NEAR(fe.normal.force[0], std::acos(-1.0) * all, 1e-12 * all);
  EXPECT_GT(beyond, 0.3 * all);
  ASSERT_FALSE(fe.as<ZoneAnswer>()->shakedown.empty());
  EXPECT_EQ(fe.stick_radius_shakedown.has_value(), fe.as<ZoneAnswer>()->shakedown.size() == 1);
}

TEST(ZoneAnswer, RefusesATableThatEndsWithinReach) {
  try {
    prepared_damaged(groove(0.5, 0.7, 0.04), 1.5);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("its last row"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace fretval::zone_answer_test
