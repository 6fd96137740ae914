#include "mdr/layer/layer.h"

#include <gtest/gtest.h>

#include "tests/mdr/error_of.h"

namespace fretval::mdr::layer_test {
namespace {

// The numbers of an incompressible body, to the last bit, and Mindlin's ratio of stiffnesses G*/E* at nu = 0.
TEST(Layer, SpringsOfAnIncompressibleBodyAreThoseOfThePaper) {
  EXPECT_EQ(spring_modulus(Direction::normal, 0.5), 4);
  EXPECT_EQ(spring_modulus(Direction::tangential, 0.5), 8.0 / 3);
  EXPECT_EQ(spring_modulus_ratio(0.5), 1.5);
  EXPECT_EQ(spring_modulus_ratio(0), 1);
  for (const double nu : {0.0, 0.2, 0.37, 0.5})
    EXPECT_NEAR(spring_modulus_ratio(nu),
                spring_modulus(Direction::normal, nu) / spring_modulus(Direction::tangential, nu), 1e-15);
}

TEST(Layer, RejectsByName) {
  EXPECT_NE(error_of([] { validate(Layer{0, 0.3}); }).find("thickness"), std::string::npos);
  EXPECT_NE(error_of([] { validate(Layer{1, 0.51}); }).find("Poisson"), std::string::npos);
  EXPECT_NE(error_of([] { spring_modulus(Direction::normal, -0.1); }).find("Poisson"), std::string::npos);
  EXPECT_EQ(error_of([] { validate(Layer{1, 0}); }), "accepted");
}

}  // namespace
}  // namespace fretval::mdr::layer_test
