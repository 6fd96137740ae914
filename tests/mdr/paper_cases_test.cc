#include "mdr/paper_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "mdr/stick_radius.h"

namespace fretval::mdr {
namespace {

constexpr double pi = 3.14159265358979323846;

// A dozen rounding errors, relative to the sum of the lengths that enter.
constexpr double tolerance = 1e-12;

Motion locked(double normal, double tangential, double phase) {
  return {1, normal, tangential, 2, 2, phase};
}

double first_slip(const Motion& motion, double mu) {
  return stick_depths(elastic(1), mu, motion).first_slip;
}

TEST(PaperCases, CaseListIsTheOneLineFormula) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 10000; ++i) {
    const double mu = 0.05 + unit(random);
    const Motion motion = locked(0.01 + unit(random), 0.01 + unit(random), 4 * pi * (unit(random) - 0.5));
    const double scale = 1 + motion.normal_amplitude + motion.tangential_amplitude / mu;
    ASSERT_NEAR(paper_case_list_depth(1, mu, motion), first_slip(motion, mu), tolerance * scale);
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

TEST(PaperCases, RejectBadArguments) {
  EXPECT_THROW(paper_unlocked_depth(0.9, 1, locked(0.1, 0.1, 0)), std::invalid_argument);
  EXPECT_THROW(paper_quadrature_depth(1, 0, locked(0.1, 0.1, 0)), std::invalid_argument);
  EXPECT_THROW(paper_case_list_depth(1, 1, locked(0, 0.1, 0)), std::invalid_argument);
  EXPECT_THROW(paper_case_list_depth(1, 1, locked(0.1, 0, 0)), std::invalid_argument);
  EXPECT_THROW(paper_case_list_depth(1, 1, (Motion{1, 0.1, 0.1, 1, 1, std::nullopt})), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr
