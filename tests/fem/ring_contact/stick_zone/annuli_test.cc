#include "fem/ring_contact/stick_zone/annuli.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/ring_contact/static_contact.h"
#include "fem/support/constants.h"
#include "tests/fem/half_space.h"
#include "tests/fem/ring_boundary_elements.h"

namespace fretval::fem::annuli_test {
namespace {

using Eigen::Index;

/// The parabola of g = r^2, whose contact has the radius 1 at d = 1, with a groove that no pressure closes.
double grooved(double r) {
  const double depth = r > 0.5 && r < 0.75 ? 0.3 * std::pow(std::sin(pi * (r - 0.5) / 0.25), 2) : 0;
  return r * r / 2 + depth;
}

StaticContact contact_at(const ContactProblem& problem, double (*profile)(double), double depth) {
  return static_contact(problem, ring_means(problem.compliance, profile), depth);
}

TEST(Annuli, RangesAreRingsSideBySide) {
  const auto ranges = ranges_of({true, true, false, true, false, false, true});
  ASSERT_EQ(ranges.size(), 3U);
  EXPECT_EQ(ranges[0].begin, 0);
  EXPECT_EQ(ranges[0].end, 2);
  EXPECT_EQ(ranges[1].begin, 3);
  EXPECT_EQ(ranges[2].end, 7);
  EXPECT_TRUE(ranges_of({false, false}).empty());
  const auto annuli = annuli_of({false, true, true}, {0, 0.5, 1, 1.5});
  ASSERT_EQ(annuli.size(), 1U);
  EXPECT_EQ(annuli[0].inner, 0.5);
  EXPECT_EQ(annuli[0].outer, 1.5);
}

// Hertz: a = sqrt(d), wherever that lies in its ring. Second order in the ring.
TEST(Annuli, OfAParabolaAreItsDisc) {
  const auto parabola = [](double r) { return r * r / 2; };
  double before = 0;
  for (const unsigned n : {16U, 32U, 64U}) {
    const auto& problem = normal_half_space(n);
    double largest = 0;
    for (int k = 0; k < 9; ++k) {
      const double d = 0.8 + 0.2 * k / 8.3;
      const auto contact = contact_at(problem, parabola, d);
      const auto annuli = contact_annuli(problem, contact.pressure, contact.gap);
      ASSERT_EQ(annuli.size(), 1U);
      EXPECT_EQ(annuli[0].inner, 0);
      largest = std::max(largest, std::abs(annuli[0].outer - std::sqrt(d)));
    }
    EXPECT_LT(largest, 0.06 / n);
    EXPECT_TRUE(before == 0 || largest < before / 2.5) << before << " " << largest;
    before = largest;
  }
}

// Where a disc and a ring touch, against boundary elements, which know the ends by their own rings.
TEST(Annuli, OfAGrooveAreThoseOfBoundaryElements) {
  constexpr int n_elements = 450;
  const RingBoundaryElements elements(1.125, n_elements);
  Eigen::VectorXd target(n_elements);
  for (Index i = 0; i < n_elements; ++i) target[i] = 1 - grooved(elements.middle[i]);
  const auto p = elements.pressures(target);
  std::vector<bool> touches;
  std::vector<double> radii{0};
  for (Index i = 0; i < n_elements; ++i) {
    touches.push_back(p[i] > 0);
    radii.push_back((i + 1) * 1.125 / n_elements);
  }
  const auto expected = annuli_of(touches, radii);
  ASSERT_EQ(expected.size(), 2U);
  const double element = 1.125 / n_elements;
  for (const unsigned n : {64U, 128U}) {
    const auto& problem = normal_half_space(n);
    const auto contact = contact_at(problem, grooved, 1);
    EXPECT_NEAR(contact.pressure.dot(problem.compliance.areas) / p.dot(elements.areas), 1, 30.0 / n / n);
    const auto annuli = contact_annuli(problem, contact.pressure, contact.gap);
    ASSERT_EQ(annuli.size(), 2U);
    const double near = element + 0.1 / n;  // theirs, and a tenth of a ring
    EXPECT_NEAR(annuli[0].outer, expected[0].outer, near);
    EXPECT_NEAR(annuli[1].inner, expected[1].inner, near);
    EXPECT_NEAR(annuli[1].outer, expected[1].outer, near);
  }
}

// Collins, Proceedings of the Edinburgh Mathematical Society 13 (1963) 303: the force of an annular flat punch over
// that of the disc is 1 - 4 e^3/(3 pi^2) - 8 e^5/(15 pi^2) - ..., e the inner over the outer radius. The hole takes
// away what the finite elements say to a percent of itself, and less with finer rings.
TEST(Annuli, AnAnnularPunchBearsWhatCollinsHasFound) {
  const double e = 0.25, lost = 4 * std::pow(e, 3) / (3 * pi * pi) + 8 * std::pow(e, 5) / (15 * pi * pi);
  double before = 0;
  for (const unsigned n : {32U, 64U, 128U}) {
    const auto& problem = normal_half_space(n);
    const auto force = [&](double inner) {
      const auto profile = ring_means(problem.compliance, [inner](double r) { return r > inner && r < 1 ? 0 : 1e3; });
      return static_contact(problem, profile, 1).pressure.dot(problem.compliance.areas);
    };
    const double error = std::abs((1 - force(e) / force(0)) / lost - 1);
    EXPECT_LT(error, 10.0 / n);
    EXPECT_TRUE(before == 0 || error < 0.7 * before) << before << " " << error;
    before = error;
  }
}

// Cattaneo and Mindlin: the margin of a stuck disc of radius c is the pressure of a contact of that radius.
TEST(Annuli, StickEndsWhereTheMarginDoes) {
  constexpr double c = 0.613;
  for (const unsigned n : {32U, 64U}) {
    const auto& problem = normal_half_space(n);
    const auto margin = contact_at(
                            problem, [](double r) { return r * r / 2; }, c * c)
                            .pressure;
    std::vector<bool> sticks;
    for (const double m : margin) sticks.push_back(m > 0);
    const auto annuli = stick_annuli(problem, margin, sticks);
    ASSERT_EQ(annuli.size(), 1U);
    EXPECT_EQ(annuli[0].inner, 0);
    EXPECT_NEAR(annuli[0].outer, c, 0.1 / n);
  }
}

TEST(Annuli, OfNothingAreNone) {
  const auto& problem = normal_half_space(16);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.n_rings());
  EXPECT_TRUE(contact_annuli(problem, none, Eigen::VectorXd::Ones(problem.n_rings())).empty());
  EXPECT_TRUE(stick_annuli(problem, none, std::vector<bool>(static_cast<std::size_t>(problem.n_rings()))).empty());
}

}  // namespace
}  // namespace fretval::fem::annuli_test
