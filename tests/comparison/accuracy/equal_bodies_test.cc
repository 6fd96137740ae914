#include <gtest/gtest.h>

#include "comparison/accuracy/proof.h"
#include "comparison/reference/half_space.h"
#include "tests/comparison/read_case.h"

// Bodies that are nearly the same have the same answers, each to its bar.
namespace fretval::equal_bodies_test {
namespace {

std::string on_body(const std::string& entries) {
  return valid_case + "subsection Body\n" + entries + "set Base = bonded\nend\n";
}

/// What quantities of the first one are over those of the second one.
struct Scales {
  double contact_radius = 1, normal_force = 1, shakedown = 1;
};

void expect_equal(const PreparedCase& one, const PreparedCase& other, const Scales& scales) {
  BodyStore bodies;
  const auto a = prove(one, Proof::bars, bodies), b = prove(other, Proof::bars, bodies);
  ASSERT_EQ(a.failure + b.failure, "");
  const auto within_bars = [&](Quantity quantity, double difference) {
    const double bars = a.budget.at(quantity).total() + b.budget.at(quantity).total();
    EXPECT_LT(std::abs(difference), bars) << traits_of(quantity).title;
    EXPECT_LT(bars, 0.01) << traits_of(quantity).title;
  };
  const double contact = *b.fe.contact_radius_max;
  within_bars(Quantity::contact_radius_max, *a.fe.contact_radius_max / contact / scales.contact_radius - 1);
  within_bars(Quantity::normal_force_max, a.fe.normal_force_max / b.fe.normal_force_max / scales.normal_force - 1);
  within_bars(Quantity::stick_radius_shakedown,
              (*a.fe.stick_radius_shakedown / scales.shakedown - *b.fe.stick_radius_shakedown) / contact);
}

TEST(EqualBodies, ACylinderOfALargeRadiusIsALayer) {
  const std::string thick = "set Thickness = 3 mm\n";
  expect_equal(prepared_case(on_body("set Shape = cylinder\nset Radius = 25 mm\n" + thick)),
               prepared_case(on_body("set Shape = layer\n" + thick)), {});
}

// What the thickness still does, some 4e-4, is MDR's.
TEST(EqualBodies, AThickLayerIsAHalfSpace) {
  const auto layer = prepared_case(on_body("set Shape = layer\nset Thickness = 1 m\n"));
  const auto over_layer = mdr_answer(layer.mdr, mdr_normal_response(layer.mdr)),
             half_space = half_space_answer(layer.input);
  const Scales scales{*over_layer.contact_radius_max / *half_space.contact_radius_max,
                      *over_layer.normal_force_max / *half_space.normal_force_max,
                      *over_layer.stick_radius_shakedown / *half_space.stick_radius_shakedown};
  EXPECT_NEAR(scales.contact_radius, 1, 2e-3);
  expect_equal(layer, prepared_case(), scales);
}

}  // namespace
}  // namespace fretval::equal_bodies_test
