#include "mdr/layer/layer_limiting_profile.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "mdr/stick/limiting_profile.h"
#include "mdr/support/constants.h"
#include "tests/mdr/error_of.h"
#include "tests/mdr/layer/layer_surface.h"

namespace fretval::mdr::layer_limiting_profile_test {
namespace {

TEST(LayerLimitingProfile, OnAThickLayerIsThePapers) {
  for (const Profile& unworn : {parabola(1), cone(0.3)}) {
    const double d = transform(unworn, 1.0), c = 0.6;
    const LayerLimitingProfile layered = layer_limiting_profile(unworn, {1e6, 0.5}, c, d);
    const LimitingProfile exact = limiting_profile(unworn, c, d);
    EXPECT_NEAR(layered.outer_radius, exact.outer_radius, 1e-5);
    for (const double r : {0.3, 0.61, 0.9, 1.1, 1.3}) EXPECT_NEAR(shape(layered, r), shape(exact, r), 3e-6);  // a/H
    EXPECT_NEAR(transform(layered, 0.8), transform(exact, 0.8), 3e-6);
    EXPECT_NEAR(limiting_normal_force(layered, 2, d), limiting_normal_force(exact, 2, d), 1e-4);
  }
}

// The surface that the pressure within c makes in three dimensions: the indenter inside, and beyond c what is left
// under the indenter when it is at its deepest.
TEST(LayerLimitingProfile, RunsAlongTheFreeSurface) {
  for (const Layer& layer : {Layer{1, 0.5}, Layer{0.7, 0.3}}) {
    const double c = 0.7, d = layer_contact(parabola(1), layer, 1).indentation;
    const LayerLimitingProfile worn = layer_limiting_profile(parabola(1), layer, c, d);
    const auto surface = [&](double r) {
      return surface_displacement(
          layer, c, [&](double s) { return limiting_pressure(worn, 1, d, s); }, r);
    };
    for (const double r : {0.0, 0.4}) EXPECT_NEAR(d - surface(r), shape(parabola(1), r), 1e-5 * d);
    for (const double r : {0.72, 0.9, 1.05}) {
      EXPECT_GT(worn_depth(worn, r), 0);
      EXPECT_NEAR(d - surface(r), shape(worn, r), 1e-5 * d);
    }
    EXPECT_NEAR(d - surface(worn.outer_radius), shape(parabola(1), worn.outer_radius), 1e-5 * d);
    EXPECT_EQ(worn_depth(worn, worn.outer_radius * 1.01), 0);
  }
}

// On a thick layer that of the paper's profile; on any 2 pi int (f_inf - f) r dr, by a midpoint rule of its own.
TEST(LayerLimitingProfile, HasTheVolumeBetweenBothShapes) {
  const double c = 0.6;
  EXPECT_NEAR(worn_volume(layer_limiting_profile(parabola(1), {1e6, 0.5}, c, 1)) /
                  worn_volume(limiting_profile(parabola(1), c, 1)),
              1, 1e-4);
  const LayerLimitingProfile worn = layer_limiting_profile(parabola(1), {0.7, 0.3}, c, 0.6);
  constexpr int n = 2000;
  const double width = (worn.outer_radius - c) / n;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double r = c + (i + 0.5) * width;
    sum += 2 * pi * r * width * (shape(worn, r) - shape(parabola(1), r));
  }
  EXPECT_NEAR(worn_volume(worn) / sum, 1, 1e-4);
}

TEST(LayerLimitingProfile, WearsNothingWhereAllOfTheContactSticks) {
  const Layer layer{0.5, 0.45};
  const LayerContact contact = layer_contact(parabola(1), layer, 1);
  const LayerLimitingProfile worn = layer_limiting_profile(parabola(1), layer, 1, contact.indentation);
  EXPECT_NEAR(worn.outer_radius, 1, 1e-5);  // both surfaces touch in a curve: the root of roundoff
  EXPECT_NEAR(limiting_normal_force(worn, 3, contact.indentation), normal_force(contact, 3), 1e-8);
}

TEST(LayerLimitingProfile, PressureAddsUpToTheForce) {
  const Layer layer{0.5, 0.5};
  const LayerLimitingProfile worn = layer_limiting_profile(parabola(1), layer, 0.7, 0.5);
  const double c = 0.7;
  const double sum = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
      [&](double angle) {
        const double r = c * std::sin(angle);
        return 2 * pi * limiting_pressure(worn, 2, 0.5, r) * r * c * std::cos(angle);
      },
      0, pi / 2, 3, 1e-9);
  EXPECT_NEAR(sum / limiting_normal_force(worn, 2, 0.5), 1, 1e-8);
}

TEST(LayerLimitingProfile, RejectsBadArguments) {
  const Layer layer{1, 0.5};
  EXPECT_NE(error_of([&] { layer_limiting_profile(parabola(1), layer, 2, 0.5); }).find("stick radius"),
            std::string::npos);
  EXPECT_NE(error_of([&] { layer_limiting_profile(parabola(1), layer, 0.5, 0); }).find("indentation"),
            std::string::npos);
  const LayerLimitingProfile worn = layer_limiting_profile(parabola(1), layer, 0.6, 0.5);
  EXPECT_NE(error_of([&] { limiting_normal_force(worn, 1, 0.6); }).find("indentation"), std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::layer_limiting_profile_test
