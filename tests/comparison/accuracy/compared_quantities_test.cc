#include "comparison/accuracy/compared_quantities.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/reference/mdr_answer.h"
#include "comparison/simulation/fe_answer.h"

namespace fretval {
namespace {

TEST(ComparedQuantities, OfAWornStateAreNoSlipNoForceAndTheWholeIndentation) {
  const Units units{2, 0.5, 4, 1};  // a force of 4
  const MdrAnswer answer{1.2, 2.5, std::nullopt, 1, std::nullopt, 4 * std::exp(1.0), 0.9};
  auto measures = quantities_of(answer, units, false);
  EXPECT_EQ(measures.size(), 4U);
  EXPECT_EQ(measures.at(Quantity::contact_radius_max), 1.25);
  EXPECT_EQ(measures.at(Quantity::stick_radius_first_slip), 0);
  EXPECT_EQ(measures.at(Quantity::stick_radius_shakedown), 0.5);
  EXPECT_NEAR(measures.at(Quantity::normal_force_max), 1, 1e-15);
  measures = quantities_of(answer, units, true);
  EXPECT_EQ(measures.count(Quantity::slip_inside_stick_zone), 0U) << "the outer part of the contact slips";
  EXPECT_EQ(measures.at(Quantity::force_outside_stick_zone), 0);
  EXPECT_EQ(measures.at(Quantity::maximum_indentation), 1);
  EXPECT_EQ(measures.at(Quantity::limiting_amplitude), 0.9);
  const MdrAnswer all_sticks{1.2, 1, std::nullopt, 1, std::nullopt, 3, 1};
  EXPECT_EQ(quantities_of(all_sticks, units, true).at(Quantity::slip_inside_stick_zone), 0);
}

TEST(ComparedQuantities, OfEqualAnswersAreEqual) {
  const Units units{2, 0.5, 4, 1};
  MdrAnswer mdr{1.2, 2.5, std::nullopt, 1, std::nullopt, 3, 1};
  FeAnswer fe;
  fe.contact_radius_max = 2.5;
  fe.stick_radius_shakedown = 1;
  fe.normal_force_max = 3;
  EXPECT_EQ(quantities_of(fe, units), quantities_of(mdr, units, false));
  fe.contact_radius_max.reset();
  fe.no_wear = NoWearEvidence{0, 0, 1, 1};
  mdr.contact_radius_max = 1;  // all of it sticks
  auto worn = quantities_of(mdr, units, true);
  worn.erase(Quantity::contact_radius_max);
  EXPECT_EQ(quantities_of(fe, units), worn);
  fe.no_wear = NoWearEvidence{0.1, 0.2, 0.7, 1.4};
  const auto errors = errors_of(quantities_of(fe, units), worn);
  EXPECT_EQ(errors.at(Quantity::slip_inside_stick_zone), 0.1);
  EXPECT_EQ(errors.at(Quantity::force_outside_stick_zone), 0.2);
  EXPECT_NEAR(errors.at(Quantity::maximum_indentation), 0.3, 1e-15);
  EXPECT_NEAR(errors.at(Quantity::limiting_amplitude), 0.4, 1e-15);
}

TEST(ComparedQuantities, AreComparedWhereBothHaveThem) {
  const auto a = Quantity::contact_radius_max, b = Quantity::normal_force_max, c = Quantity::stick_radius_shakedown;
  EXPECT_EQ(errors_of({{a, 1}, {b, 2}}, {{b, 5}, {c, 0}}), (Quantities{{b, 3}}));
  EXPECT_EQ(largest_of({{a, 1}, {b, 2}}), 2);
  EXPECT_TRUE(std::isnan(largest_of({})));
}

}  // namespace
}  // namespace fretval
