#include "mdr/rheology/prony_approximation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <stdexcept>

#include "mdr/motion/motion.h"

namespace fretval::mdr::prony_approximation_test {
namespace {

TEST(PronyApproximation, HasTheModulusOfTheFractionalBodyOverTheRange) {
  for (const double order : {0.2, 0.5, 0.8, 1.0}) {
    for (const double time : {1e-4, 0.1, 30.0}) {
      const FractionalZener body{1, 5, time, order};
      const PronyApproximation approximation = prony_approximation(body, 0.1, 1000);
      EXPECT_EQ(approximation.body.relaxed_modulus, 1);
      // 7.6e-3 at the slow end for the order 0.2, whose spectrum is the broadest; 3e-3 for the others.
      EXPECT_LT(approximation.worst, order < 0.5 ? 1e-2 : 3e-3) << "order " << order << ", time " << time;
      const double rho = std::abs(complex_modulus(body, angular_frequency(1)));
      EXPECT_NEAR(std::abs(complex_modulus(approximation.body, angular_frequency(1))) / rho, 1, 1e-3)
          << "order " << order << ", time " << time;
      // Between the samples, too.
      for (const double frequency : {0.117, 1.03, 13.7, 555.0}) {
        const auto exact = complex_modulus(body, angular_frequency(frequency));
        const auto fitted = complex_modulus(approximation.body, angular_frequency(frequency));
        EXPECT_LT(std::abs(fitted - exact) / std::abs(exact), 1.2 * approximation.worst + 1e-12);
      }
    }
  }
}

TEST(PronyApproximation, RejectsBadRanges) {
  EXPECT_THROW(prony_approximation({1, 1, 1, 0.5}, 0, 1), std::invalid_argument);
  EXPECT_THROW(prony_approximation({1, 1, 1, 0.5}, 2, 1), std::invalid_argument);
  EXPECT_THROW(prony_approximation({1, 1, 1, 2}, 1, 2), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::prony_approximation_test
