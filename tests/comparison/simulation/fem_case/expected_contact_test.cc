#include "comparison/simulation/fem_case/expected_contact.h"

#include <gtest/gtest.h>

#include "mdr/layer/layer_contact.h"
#include "mdr/profiles/power_law.h"

namespace fretval::expected_contact_test {
namespace {

Case::Body layer(double thickness) {
  Case::Body body;
  body.shape = Case::Body::Shape::layer;
  body.thickness = thickness;
  return body;
}

TEST(ExpectedContact, IsThatOfTheElasticContactOverAHalfSpace) {
  EXPECT_DOUBLE_EQ(expected_contact_radius(mdr::parabola(1e-2), 1e-4, {}, 0.5), 1e-3);
}

// The contact line reaches 1.25 times as far: a tenth too little is enough, and too much costs rings.
TEST(ExpectedContact, IsCloseToThatOverALayer) {
  const auto profile = mdr::parabola(1e-2);
  const double indentation = 1e-4;
  for (const double nu : {0.0, 0.3, 0.45, 0.49, 0.5})
    for (const double thickness : {2e-4, 5e-4, 1e-3, 3e-3, 1e-1}) {
      const double exact =
          mdr::layer_contact_at_depth(profile, {thickness, nu, mdr::LayerBase::bonded}, indentation).contact_radius;
      const double expected = expected_contact_radius(profile, indentation, layer(thickness), nu);
      EXPECT_GT(expected, 0.9 * exact) << nu << " " << thickness;
      EXPECT_LT(expected, 1.45 * exact) << nu << " " << thickness;
    }
}

}  // namespace
}  // namespace fretval::expected_contact_test
