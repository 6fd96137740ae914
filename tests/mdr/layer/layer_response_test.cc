#include "mdr/layer/layer_response.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/mdr/error_of.h"
#include "tests/mdr/layer/layer_waves.h"

namespace fretval::mdr::layer_response_test {
namespace {

constexpr double ratios[] = {0, 0.3, 0.45, 0.5};

// Of the exponential, which loses e^(2 kappa) of its digits.
TEST(LayerResponse, IsThatOfTheMatrixExponential) {
  for (const double nu : ratios) {
    for (const double kappa : {0.1, 0.7, 1.0, 1.3, 3.0}) {
      const double H = 0.6, k = kappa / H, tolerance = 1e-15 * std::exp(2 * kappa) / kappa / kappa;
      const LayerWaves bonded = layer_waves({H, nu}, k), sliding = layer_waves({H, nu, LayerBase::frictionless}, k);
      EXPECT_NEAR(response_ratio({H, nu}, Direction::normal, kappa), bonded.normal * k / (1 - nu), tolerance);
      EXPECT_NEAR(response_ratio({H, nu}, Direction::tangential, kappa), (bonded.along + bonded.across) * k / (2 - nu),
                  tolerance);
      EXPECT_NEAR(response_ratio({H, nu, LayerBase::frictionless}, Direction::normal, kappa),
                  sliding.normal * k / (1 - nu), tolerance);
    }
  }
}

// A long wave sees oedometric compression, simple shear, or the flow under a membrane; next order kappa^2.
TEST(LayerResponse, OfLongWavesIsThatOfAThinLayer) {
  const double kappa = 1e-4;
  for (const double nu : {0.0, 0.3, 0.45}) {
    EXPECT_NEAR(response_ratio({1, nu}, Direction::normal, kappa) / kappa * 2 * (1 - nu) * (1 - nu) / (1 - 2 * nu), 1,
                1e-6);
    EXPECT_NEAR(response_ratio({1, nu}, Direction::tangential, kappa) / kappa * (2 - nu) / 2, 1, 1e-7);
    EXPECT_NEAR(response_ratio({1, nu, LayerBase::frictionless}, Direction::normal, kappa) / kappa, 0.5, 1e-12);
  }
  EXPECT_NEAR(response_ratio({1, 0.5}, Direction::normal, kappa) / std::pow(kappa, 3), 2.0 / 3, 1e-7);
}

TEST(LayerResponse, BothFormsAgreeAndNeitherOverflows) {
  for (const LayerBase base : {LayerBase::bonded, LayerBase::frictionless}) {
    for (const Direction direction : {Direction::normal, Direction::tangential}) {
      if (base == LayerBase::frictionless && direction == Direction::tangential) continue;
      for (const double nu : ratios) {
        const Layer layer{1, nu, base};
        for (const double kappa : {0.0, 1e-9, 1e-3, 0.499, 0.501, 0.999, 1.001, 5.0, 20.0, 400.0, 1e6})
          EXPECT_NEAR(response_ratio(layer, direction, kappa), 1 + response_ratio_less_one(layer, direction, kappa),
                      4e-16);
        EXPECT_EQ(response_ratio(layer, direction, 1e6), 1);
        // Far from the base: 2 kappa^2 e^(-2 kappa)/... with the relative accuracy of so small a number.
        EXPECT_LT(response_ratio_less_one(layer, direction, 30), 0);
        EXPECT_GT(response_ratio_less_one(layer, direction, 30), -1e-22);
      }
    }
  }
}

TEST(LayerResponse, RefusesWhatNothingHolds) {
  EXPECT_NE(error_of([] {
              response_ratio({1, 0.5, LayerBase::frictionless}, Direction::tangential, 1);
            }).find("nothing holds the layer"),
            std::string::npos);
  EXPECT_NE(error_of([] {
              response_ratio_less_one({1, 0.5}, Direction::normal, -1);
            }).find("wave number"),
            std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::layer_response_test
