#include "fem/support/wide_registers.h"

#include <gtest/gtest.h>

#include "tests/fem/random_vector.h"

namespace fretval::fem {
namespace {

// A fused operation would differ in the last bit of one of them.
TEST(WideRegisters, SayHowManyNumbersTheyTakeAndChangeNoBit) {
  const Eigen::VectorXd x = random_vector(1003, 1), y = random_vector(1003, 2);
  Eigen::VectorXd wide(x.size());
  int width = 0;
  in_wide_registers([&](auto numbers) {
    width = numbers;
    for (Eigen::Index i = 0; i < wide.size(); ++i) wide[i] = x[i] * y[i] + y[i];
  });
  EXPECT_TRUE(width == 2 || width == 4) << width;
  for (Eigen::Index i = 0; i < wide.size(); ++i) EXPECT_EQ(wide[i], x[i] * y[i] + y[i]) << i;
}

}  // namespace
}  // namespace fretval::fem
