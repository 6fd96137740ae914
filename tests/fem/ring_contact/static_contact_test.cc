#include "fem/ring_contact/static_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "fem/ring_contact/contact_events.h"
#include "fem/ring_contact/effective_radii.h"
#include "fem/ring_contact/stick_zone/contact_radius.h"
#include "fem/support/constants.h"
#include "tests/fem/convergence.h"
#include "tests/fem/half_space.h"
#include "tests/fem/recorded_history.h"

namespace fretval::fem::static_contact_test {
namespace {

// A step and a bend inside the rings: r from 0.3 to 0.55, 0.1 from there to 0.8, so the integral of 2 pi r f is known.
TEST(RingMeans, KeepTheVolumeOfWhatBendsAndJumps) {
  const auto f = [](double r) { return r < 0.3 || r > 0.8 ? 0 : r < 0.55 ? r : 0.1; };
  const double volume = 2 * pi * ((std::pow(0.55, 3) - std::pow(0.3, 3)) / 3 + 0.1 * (0.64 - 0.3025) / 2);
  for (const unsigned n : {16u, 64u}) {
    const auto& compliance = half_space(axisymmetric, n).compliance;
    EXPECT_NEAR(compliance.areas.dot(ring_means(compliance, f, {0.3, 0.55, 0.8})) / volume, 1, 1e-13);
    EXPECT_GT(std::abs(compliance.areas.dot(ring_means(compliance, f)) / volume - 1), 1e-6) << "blind to them";
  }
}

const std::vector<unsigned> meshes{16, 32, 64, 128};

/// `f = b r^n` with the transform `g = kappa b x^n`, kappa = (sqrt(pi)/2) n Gamma(n/2) / Gamma((n+1)/2): the contact
/// has the radius a where g(a) = d and the force `F = 8 int_0^a (d - g) dx = 8 n/(n+1) d a` (docs/theory.md).
/// b is such that d = 1 gives a = 1.
struct PowerLaw {
  double exponent;

  [[nodiscard]] double shape(double r) const {
    const double kappa = std::sqrt(pi) / 2 * exponent * std::tgamma(exponent / 2) / std::tgamma((exponent + 1) / 2);
    return std::pow(r, exponent) / kappa;
  }
  [[nodiscard]] double contact_radius(double indentation) const { return std::pow(indentation, 1 / exponent); }
  [[nodiscard]] double force(double indentation) const {
    return 8 * exponent / (exponent + 1) * indentation * contact_radius(indentation);
  }
};

struct Errors {
  std::vector<double> force, radius;  // per mesh, relative
};

/// Largest errors over eight contact radii in 0.8 to 1: where the edge lies in its ring matters.
Errors errors_of(const PowerLaw& indenter) {
  Errors errors;
  for (const unsigned n : meshes) {
    const auto& problem = normal_half_space(n);
    const Eigen::VectorXd profile = ring_means(problem.compliance, [&](double r) { return indenter.shape(r); });
    const ContactEvents events = contact_events(problem.compliance, profile);
    double force = 0, radius = 0;
    for (int k = 0; k < 8; ++k) {
      const double indentation = std::pow(1 - 0.2 * k / 7.3, indenter.exponent);
      const auto contact = static_contact(problem, profile, indentation);
      force =
          std::max(force, std::abs(contact.pressure.dot(problem.compliance.areas) / indenter.force(indentation) - 1));
      radius = std::max(
          radius,
          std::abs(largest_contact_radius(contact.gap, events).radius / indenter.contact_radius(indentation) - 1));
    }
    errors.force.push_back(force);
    errors.radius.push_back(radius);
  }
  return errors;
}

// Piecewise constant pressures against one that ends like a square root: the energy of the best ones is off by h^2 (the
// flat punch, with its singular edge, by h). Measured at 16, 32, 64, 128 rings per radius:
//   force   1.3e-3, 2.6e-4, 4.4e-5, 1.5e-5, order 2.2;   radius   1.8e-5, 1.6e-6, 1.3e-7, 5.7e-8.
// The radius is of third order down to the far field, 5e-8.
TEST(StaticContact, Hertz) {
  const Errors errors = errors_of({2});
  EXPECT_LT(errors.force[3], 3e-5);
  EXPECT_LT(errors.radius[2], 3e-7);
  EXPECT_LT(errors.radius[3], 1e-7);
  EXPECT_GT(observed_order(errors.force), 1.8);
  EXPECT_GT(std::log2(errors.radius[0] / errors.radius[2]) / 2, 2.8);
}

// Force 8.3e-4, 1.7e-4, 2.9e-5, 9.9e-6, order 2.2; radius 1.5e-5, 1.3e-6, 1.1e-7, 6.3e-8.
TEST(StaticContact, Cone) {
  const Errors errors = errors_of({1});
  EXPECT_LT(errors.force[3], 2e-5);
  EXPECT_LT(errors.radius[2], 3e-7);
  EXPECT_LT(errors.radius[3], 1e-7);
  EXPECT_GT(observed_order(errors.force), 1.8);
  EXPECT_GT(std::log2(errors.radius[0] / errors.radius[2]) / 2, 2.8);
}

// Force 2.2e-3, 4.5e-4, 7.5e-5, 2.5e-5, order 2.2; radius 1.1e-4, 8.0e-6, 1.2e-6, 1.2e-7, order 3.2.
TEST(StaticContact, FourthPower) {
  const Errors errors = errors_of({4});
  EXPECT_LT(errors.force[3], 5e-5);
  EXPECT_LT(errors.radius[3], 3e-7);
  EXPECT_GT(observed_order(errors.force), 1.8);
  EXPECT_GT(observed_order(errors.radius), 2.8);
}

/// Force of a unit displacement of the rings inside r = 1.
double punch_force(const ContactProblem& problem, unsigned n) {
  const Eigen::MatrixXd inside = problem.compliance.matrix->topLeftCorner(n, n);
  const Eigen::VectorXd areas = problem.compliance.areas.head(n);
  return areas.dot(inside.llt().solve(areas));
}

// A punch of m rings acts like one of radius (m - beta) h: its force is off by h (8.8e-4 at 128 rings, order 1.00). For
// the effective radius it is off by h^3 (1.7e-5, 1.4e-6 at 16, 32 rings), down to 1e-7 of the far field.
void check_punch(const FourierOrder& order, double expected) {
  std::vector<double> errors, corrected;
  for (const unsigned n : meshes) {
    const auto& problem = half_space(order, n);
    errors.push_back(punch_force(problem, n) / expected - 1);
    corrected.push_back(punch_force(problem, n) / effective_radii(problem.compliance).radius[n] / expected - 1);
  }
  EXPECT_LT(std::abs(errors[3]), 2e-3);
  EXPECT_GT(observed_order(errors), 0.95);
  EXPECT_LT(std::abs(corrected[2]), 3e-7);
  EXPECT_LT(std::abs(corrected[3]), 3e-7);
  EXPECT_GT(std::log2(corrected[0] / corrected[1]), 2.8);
}

TEST(StaticContact, FlatPunch) {
  check_punch(axisymmetric, 8);
}

TEST(StaticContact, FullStick) {
  check_punch(lateral, 16.0 / 3);
}

// target = C p / A + k p^m - gap, with pressure or gap zero: an answer is checked by its equations. Roundoff, and 1e-9
// of the wear where Newton's iterations end.
TEST(StaticContact, WearsByThePressureThatIsFound) {
  const auto& problem = normal_half_space(32);
  const auto& [radii, areas, matrix, half_space] = problem.compliance;
  const Eigen::Index n = problem.n_rings();
  Eigen::VectorXd target(n);
  for (Eigen::Index i = 0; i < n; ++i) target[i] = 0.5 - std::pow(radii[i] + radii[i + 1], 2) / 8;
  Eigen::VectorXd coefficient = Eigen::VectorXd::Zero(n);
  coefficient.segment(8, 24).setConstant(0.05);
  for (const double exponent : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    std::vector<BoxState> states(static_cast<std::size_t>(n), BoxState::lower);
    std::fill_n(states.begin(), 20, BoxState::interior);  // fewer than will touch
    ContactRoom room;
    StaticContact contact;
    WearingSolver(problem, {coefficient, exponent}, states).solve(target, states, room, contact);
    const auto& [pressure, gap] = contact;
    const Eigen::VectorXd worn = coefficient.cwiseProduct(pressure.array().max(0).pow(exponent).matrix());
    const Eigen::VectorXd left = target - (*matrix * pressure).cwiseQuotient(areas) + gap - worn;
    EXPECT_LT(left.cwiseAbs().maxCoeff(), 1e-6 * worn.maxCoeff()) << exponent;
    EXPECT_GT(pressure.minCoeff(), -1e-12);
    EXPECT_GT(gap.minCoeff(), -1e-12);
    EXPECT_EQ(pressure.cwiseProduct(gap).cwiseAbs().maxCoeff(), 0);
    EXPECT_GT(worn.maxCoeff(), 0.01);
  }
}

}  // namespace
}  // namespace fretval::fem::static_contact_test
