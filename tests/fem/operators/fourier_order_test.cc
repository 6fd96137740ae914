#include "fem/operators/fourier_order.h"

#include <gtest/gtest.h>

namespace fretval::fem::fourier_order_test {
namespace {

TEST(FourierOrder, HasTheComponentsOfItsFields) {
  constexpr FourierOrder torsion{0, Parity::odd}, second{2, Parity::even};
  EXPECT_EQ(n_displacements(axisymmetric), 2U);
  EXPECT_EQ(n_displacements(torsion), 1U);
  EXPECT_EQ(n_displacements(lateral), 3U);
  EXPECT_EQ(n_displacements(second), 3U);
  EXPECT_FALSE(has_pressure(torsion));
  EXPECT_TRUE(has_pressure(axisymmetric));
  EXPECT_EQ(vertical_component(axisymmetric), 1U);
  EXPECT_EQ(vertical_component(second), 2U);
}

TEST(FourierOrder, IsOrderedByNumberAndParity) {
  EXPECT_TRUE((axisymmetric < FourierOrder{0, Parity::odd}));
  EXPECT_TRUE((FourierOrder{0, Parity::odd} < lateral));
  EXPECT_FALSE(lateral < lateral);
  EXPECT_TRUE((lateral == FourierOrder{1, Parity::even}));
}

}  // namespace
}  // namespace fretval::fem::fourier_order_test
