#include "mdr/stick/paper_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <stdexcept>

#include "mdr/stick/stick_radius.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::paper_cases_test {
namespace {

// A dozen rounding errors, relative to the sum of the lengths that enter.
constexpr double tolerance = 1e-12;

Motion locked(double normal, double tangential, double phase) {
  return {1, normal, tangential, 2, 2, phase};
}

double first_slip(const Motion& motion, double mu) {
  return stick_depths(elastic(1), mu, motion).first_slip;
}

// The minimum of (20) over Omega without knowledge of its solution: between two singular points, where
// cos(Omega + phi0) = 0, the right-hand side is smooth and a sinusoid, so each half turn has one stationary point
// inside or none. Bisection of the slope finds it; the singular points themselves are candidates as well.
double least_by_brute_force(double mu, const Motion& motion) {
  const auto depth = [&](double angle) { return paper_no_slip_depth(1, mu, motion, angle); };
  const double tangential = 2 * motion.tangential_amplitude / (3 * mu);
  double least = motion.indentation + motion.normal_amplitude;
  for (const double sign : {1.0, -1.0}) {
    const double first = -*motion.phase - sign * pi / 2, last = first + pi;
    least = std::min({least, depth(first), depth(last)});
    const auto slope = [&](double angle) {
      return sign * tangential * std::sin(angle + *motion.phase) - motion.normal_amplitude * std::sin(angle);
    };
    if (!(slope(first) < 0 && slope(last) > 0)) continue;
    double lower = first, upper = last;
    for (int i = 0; i < 40; ++i) (slope((lower + upper) / 2) < 0 ? lower : upper) = (lower + upper) / 2;
    least = std::min(least, depth((lower + upper) / 2));
  }
  return least;
}

TEST(PaperCases, CaseListIsTheOneLineFormulaAndTheMinimumOf20) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 10000; ++i) {
    const double mu = 0.05 + unit(random);
    const Motion motion = locked(0.01 + unit(random), 0.01 + unit(random), 4 * pi * (unit(random) - 0.5));
    const double scale = 1 + motion.normal_amplitude + motion.tangential_amplitude / mu;
    const double depth = paper_case_list_depth(1, mu, motion);
    ASSERT_NEAR(depth, first_slip(motion, mu), tolerance * scale);
    ASSERT_NEAR(depth, least_by_brute_force(mu, motion), tolerance * scale);
  }
}

// The brute force is itself held against plain sampling, whose error is below (2 pi/n)^2/8 of the amplitudes.
TEST(PaperCases, NoSampleOf20IsBelowItsMinimum) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(0, 1);
  const int n_samples = 2000;
  for (int i = 0; i < 100; ++i) {
    const Motion motion = locked(unit(random), unit(random), 4 * pi * (unit(random) - 0.5));
    double least = 2;
    for (int j = 0; j < n_samples; ++j)
      least = std::min(least, paper_no_slip_depth(1, 0.7, motion, 2 * pi * j / n_samples));
    const double minimum = least_by_brute_force(0.7, motion);
    EXPECT_GE(least, minimum - tolerance);
    EXPECT_NEAR(least, minimum, 2 * pi * pi / (4.0 * n_samples * n_samples) * 2);
  }
}

TEST(PaperCases, Equation18IsEquation20WithThePhaseOfTheModulus) {
  const PronyBody body = standard_solid(1, 3, 0.2);
  const std::complex<double> ratio = complex_modulus_ratio(body, 4 * pi);
  const Motion motion = locked(0.2, 0.3, 0.8);
  for (int j = 0; j < 50; ++j) {
    const double time = 0.01 * j;
    EXPECT_NEAR(paper_no_slip_depth_at_time(body, 0.6, motion, time),
                paper_no_slip_depth(std::abs(ratio), 0.6, motion, 4 * pi * time + std::arg(ratio)), tolerance);
  }
}

TEST(PaperCases, Equation19IsTheCaseListForEveryRheology) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Rheology& body : {Rheology(elastic(1)), Rheology(kelvin_voigt(1, 0.1)),
                               Rheology(standard_solid(1, 3, 0.2)), Rheology(FractionalZener{1, 3, 0.1, 0.6})}) {
    for (int i = 0; i < 200; ++i) {
      const double mu = 0.1 + unit(random);
      const Motion motion = locked(0.01 + unit(random), 0.01 + unit(random), 4 * pi * (unit(random) - 0.5));
      const double rho = modulus_ratio(body, 4 * pi);
      const double scale = 1 + rho * (motion.normal_amplitude + motion.tangential_amplitude / mu);
      EXPECT_NEAR(paper_least_no_slip_depth(body, mu, motion), paper_case_list_depth(rho, mu, motion),
                  tolerance * scale);
    }
  }
}

TEST(PaperCases, CaseListHoldsWhereTheRadicandVanishes) {
  for (const double phase : {0.0, pi}) {
    const Motion motion = locked(0.2, 0.3, phase);  // k = 1 at mu = 1
    EXPECT_NEAR(paper_case_list_depth(1, 1, motion), first_slip(motion, 1), tolerance);
  }
}

TEST(PaperCases, UnlockedAndQuadratureEquations) {
  const Motion quadrature = locked(0.2, 0.3, pi / 2);
  EXPECT_NEAR(paper_quadrature_depth(1, 0.7, quadrature), first_slip(quadrature, 0.7), tolerance);
  const Motion in_phase = locked(0.2, 0.3, 0);
  EXPECT_NEAR(paper_unlocked_depth(1, 0.7, in_phase), first_slip(in_phase, 0.7), tolerance);
  Motion unlocked = in_phase;
  unlocked.phase.reset();
  EXPECT_NEAR(paper_unlocked_depth(1, 0.7, unlocked), first_slip(unlocked, 0.7), tolerance);
}

TEST(PaperCases, ModulusRatioScalesTheOscillation) {
  const PronyBody body = kelvin_voigt(1, 0.1);
  const double rho = modulus_ratio(body, 4 * pi);
  const Motion motion = locked(0.2, 0.3, 1);
  EXPECT_NEAR(paper_case_list_depth(rho, 0.7, motion), stick_depths(body, 0.7, motion).first_slip, tolerance);
}

// Each candidate is the right-hand side of (20) at its own angle: extrema inside the two intervals, and their ends.
TEST(PaperCases, CandidatesAreValuesOf20) {
  const double mu = 0.4, rho = 1.5;
  const Motion motion{1, 0.2, 0.3, 1, 1, 1.1};
  const double k = paper_amplitude_ratio(mu, motion);
  EXPECT_NEAR(k, 3 * mu * 0.2 / (2 * 0.3), 1e-15);
  const PaperCandidates candidates = paper_candidates(rho, mu, motion);
  const auto value = [&](double angle) { return paper_no_slip_depth(rho, mu, motion, angle); };
  EXPECT_NEAR(candidates.c3, value(pi / 2 - 1.1), 1e-14);
  EXPECT_NEAR(candidates.c4, value(-pi / 2 - 1.1), 1e-14);
  // cos(Omega + phi0)/k -+ cos(Omega) is largest at the argument of e^(-i phi0)/k -+ 1.
  const auto angle = [&](double sign) { return std::atan2(-std::sin(1.1) / k, std::cos(1.1) / k + sign); };
  EXPECT_NEAR(candidates.c1, value(angle(-1)), 1e-14);
  EXPECT_NEAR(candidates.c2, value(angle(1) + pi), 1e-14);
}

TEST(PaperCases, RejectBadArguments) {
  EXPECT_THROW(paper_unlocked_depth(0.9, 1, locked(0.1, 0.1, 0)), std::invalid_argument);
  EXPECT_THROW(paper_quadrature_depth(1, 0, locked(0.1, 0.1, 0)), std::invalid_argument);
  EXPECT_THROW(paper_case_list_depth(1, 1, locked(0, 0.1, 0)), std::invalid_argument);
  EXPECT_THROW(paper_case_list_depth(1, 1, locked(0.1, 0, 0)), std::invalid_argument);
  const Motion unlocked{1, 0.1, 0.1, 1, 1, std::nullopt}, unequal{1, 0.1, 0.1, 1, 2, 0.0};
  EXPECT_THROW(paper_case_list_depth(1, 1, unlocked), std::invalid_argument);
  EXPECT_THROW(paper_no_slip_depth(1, 1, unlocked, 0), std::invalid_argument);
  EXPECT_THROW(paper_no_slip_depth_at_time(elastic(1), 1, unlocked, 0), std::invalid_argument);
  EXPECT_THROW(paper_no_slip_depth_at_time(elastic(1), 1, unequal, 0), std::invalid_argument);
  EXPECT_THROW(paper_least_no_slip_depth(elastic(1), 1, unequal), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::paper_cases_test
