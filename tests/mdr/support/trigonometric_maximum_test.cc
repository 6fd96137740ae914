#include "mdr/support/trigonometric_maximum.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <stdexcept>
#include <vector>

#include "mdr/support/constants.h"

namespace fretval::mdr::trigonometric_maximum_test {
namespace {

// The guarantee of the function, relative to the sum of the amplitudes.
constexpr double tolerance = 1e-13;

double sum_of_amplitudes(const std::vector<TrigonometricTerm>& terms) {
  double sum = 0;
  for (const auto& term : terms) sum += std::abs(term.amplitude);
  return sum;
}

double evaluate(const std::vector<TrigonometricTerm>& terms, double angle) {
  double value = 0;
  for (const auto& term : terms) value += term.amplitude * std::cos(term.order * angle + term.phase);
  return value;
}

// Every maximum is among the zeros of P'. With z = e^(i theta) they are the zeros on the unit circle of a polynomial of
// degree 2 n, eigenvalues of its companion matrix. An angle to 1e-7 gives the flat maximum to roundoff.
double maximum_from_companion_matrix(const std::vector<TrigonometricTerm>& terms, Eigen::Index order) {
  Eigen::VectorXcd slope = Eigen::VectorXcd::Zero(2 * order + 1);
  for (const auto& term : terms) {
    const std::complex<double> half = std::polar(term.amplitude / 2, term.phase) * std::complex<double>(0, term.order);
    slope(order + term.order) += half;
    slope(order - term.order) += std::conj(half);
  }
  Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(2 * order, 2 * order);
  companion.diagonal(-1).setOnes();
  companion.col(2 * order - 1) = -slope.head(2 * order) / slope(2 * order);
  const Eigen::VectorXcd zeros = companion.eigenvalues();
  double best = -sum_of_amplitudes(terms);
  for (Eigen::Index i = 0; i < zeros.size(); ++i) best = std::max(best, evaluate(terms, std::arg(zeros(i))));
  return best;
}

TEST(TrigonometricMaximum, OneOrderIsItsAmplitude) {
  const auto one = trigonometric_maximum({{-2, 5, 0.3}});
  EXPECT_NEAR(one.value, 2, tolerance);
  EXPECT_NEAR(std::cos(5 * one.angle + 0.3), -1, tolerance);
  EXPECT_NEAR(trigonometric_maximum({{3, 7, 0.4}, {4, 7, 0.4 + pi / 2}}).value, 5, tolerance * 7);
  EXPECT_NEAR(trigonometric_maximum({{3, 7, 0.4}, {2, 0, pi}}).value, 1, tolerance * 5);
}

TEST(TrigonometricMaximum, ConstantsAndNothing) {
  EXPECT_EQ(trigonometric_maximum({}).value, 0);
  EXPECT_EQ(trigonometric_maximum({{0, 3, 1}, {0, 4, 2}}).value, 0);
  EXPECT_NEAR(trigonometric_maximum({{2, 0, pi / 3}}).value, 1, tolerance);
  // Cancels to nothing but roundoff.
  EXPECT_NEAR(trigonometric_maximum({{1, 3, 0.5}, {-1, 3, 0.5}, {1, 2, 0.1}, {1, 2, 0.1 + pi}}).value, 0, tolerance);
}

TEST(TrigonometricMaximum, OneToTwoInClosedForm) {
  // a cos(theta) + b cos(2 theta) = a x + b (2 x^2 - 1), x = cos(theta).
  for (const double b : {-2.0, -1.0, -0.5, -0.26, -0.25, -0.1, 0.0, 0.3}) {
    const double expected = b < -0.25 ? -1 / (8 * b) - b : 1 + b;
    EXPECT_NEAR(trigonometric_maximum({{1, 1, 0}, {b, 2, 0}}).value, expected, tolerance * (1 + std::abs(b)));
  }
}

TEST(TrigonometricMaximum, FlatMaxima) {
  // 0.75 - 2 sin^4(theta/2), then 10 - 32 sin^6(theta/2), both shifted.
  const auto quartic = trigonometric_maximum({{1, 1, -0.7}, {-0.25, 2, -1.4}});
  EXPECT_NEAR(quartic.value, 0.75, tolerance * 1.25);
  EXPECT_NEAR(trigonometric_maximum({{15, 1, -0.7}, {-6, 2, -1.4}, {1, 3, -2.1}}).value, 10, tolerance * 22);
}

TEST(TrigonometricMaximum, RandomPolynomialsAgainstTheCompanionMatrix) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 300; ++i) {
    const int order = 2 + i % 11;
    std::vector<TrigonometricTerm> terms;
    for (int k = 0; k <= order; ++k) terms.push_back({0.05 + unit(random), k, 2 * pi * unit(random)});
    const auto maximum = trigonometric_maximum(terms);
    const double scale = sum_of_amplitudes(terms);
    ASSERT_NEAR(maximum.value, maximum_from_companion_matrix(terms, order), tolerance * scale) << i;
    ASSERT_NEAR(evaluate(terms, maximum.angle), maximum.value, tolerance * scale) << i;
  }
}

TEST(TrigonometricMaximum, NoDenseSampleIsHigher) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 20; ++i) {
    std::vector<TrigonometricTerm> terms(6);
    for (auto& term : terms) term = {unit(random), int(200 * unit(random)), 2 * pi * unit(random)};
    const double maximum = trigonometric_maximum(terms).value;
    for (int j = 0; j < 20000; ++j) ASSERT_LE(evaluate(terms, 1e-4 * pi * j), maximum + tolerance * 6);
  }
}

TEST(TrigonometricMaximum, NearlyEqualMaxima) {
  for (const double excess : {1e-3, 1e-7, 1e-11}) {
    const auto left = trigonometric_maximum({{1, 2, 0}, {excess, 1, 0}});
    EXPECT_NEAR(left.value, 1 + excess, tolerance);
    EXPECT_NEAR(std::cos(left.angle), 1, 1e-9);
    const auto right = trigonometric_maximum({{1, 2, 0}, {-excess, 1, 0}});
    EXPECT_NEAR(right.value, 1 + excess, tolerance);
    EXPECT_NEAR(std::cos(right.angle), -1, 1e-9);
  }
}

// Fejer kernel: one peak of height n and width 1/n, almost nothing elsewhere.
TEST(TrigonometricMaximum, NarrowPeak) {
  const int n = 300;
  for (const double position : {0.1, 2.5, 6.1}) {
    std::vector<TrigonometricTerm> terms{{1, 0, 0}};
    terms.reserve(n);
    for (int k = 1; k < n; ++k) terms.push_back({2 * (1 - double(k) / n), k, -k * position});
    const auto maximum = trigonometric_maximum(terms);
    EXPECT_NEAR(maximum.value, n, tolerance * n);
    EXPECT_NEAR(maximum.angle, position, 1e-9);
  }
}

TEST(TrigonometricMaximum, HighOrders) {
  for (const double position : {0.3, 3.1, 6.2}) {
    // The phases are rounded by 1e-11 at most, its square is the loss.
    const auto maximum = trigonometric_maximum({{1, 9999, -9999 * position}, {0.7, 10000, -10000 * position}});
    EXPECT_NEAR(maximum.value, 1.7, tolerance * 1.7);
  }
}

TEST(TrigonometricMaximum, ScalesWithTheAmplitudes) {
  const double unit = trigonometric_maximum({{1, 2, 0.3}, {0.7, 3, 0.9}}).value;
  for (const double scale : {1e-300, 1e-12, 1e12, 1e300}) {
    const double scaled = trigonometric_maximum({{scale, 2, 0.3}, {0.7 * scale, 3, 0.9}}).value;
    EXPECT_NEAR(scaled / scale, unit, tolerance * 1.7);
  }
}

TEST(TrigonometricMaximum, RejectsBadTerms) {
  EXPECT_THROW(trigonometric_maximum({{1, -1, 0}}), std::invalid_argument);
  EXPECT_THROW(trigonometric_maximum({{NAN, 1, 0}}), std::invalid_argument);
  EXPECT_THROW(trigonometric_maximum({{1, 1, INFINITY}}), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::trigonometric_maximum_test
