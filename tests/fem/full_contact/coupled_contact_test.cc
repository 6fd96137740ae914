#include "fem/full_contact/coupled_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fem/contact/require_room.h"
#include "fem/full_contact/surface_history.h"
#include "fem/ring_contact/static_contact.h"
#include "tests/fem/full_contact/bodies.h"

namespace fretval::fem::coupled_contact_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using full_contact_test::nowhere;
using full_contact_test::ramp;
using full_contact_test::round_profile;
using full_contact_test::surface_half_space;

// Over an incompressible half-space, or where it is told to, pressure knows nothing of friction.
TEST(CoupledContact, WithoutCouplingIsBothContactsSideBySide) {
  for (const double nu : {0.5, 0.3}) {
    const auto& surface = surface_half_space(nu);
    const auto operators = coupled_operators(surface, angular_grid(4), false);
    const IndenterMotion motion{ramp(0.3, 0.6), {ramp(0, 0.2), ramp(0, 0.1)}};
    const auto profile = round_profile(surface, 2, 4);
    CoupledContact contact(operators, {}, 0.5, profile, motion, 6);
    VectorFriction friction(operators.tangential, {}, 0.5, motion.lateral, 6);
    const ContactProblem rings(ring_compliance(surface, axisymmetric));
    for (int k = 1; k <= 6; ++k) {
      contact.step();
      const auto pressed = static_contact(rings, profile.col(0), 0.3 + 0.3 * k / 6);
      friction.step(pressed.pressure);
      ASSERT_LT((contact.pressure - pressed.pressure.replicate(1, 4)).norm(), 1e-9);
      ASSERT_LT((contact.gap - pressed.gap.replicate(1, 4)).norm(), 1e-9);
      ASSERT_LT((contact.friction.traction - friction.traction).norm(), 1e-9);
    }
  }
}

// Cut off at 25 by tractions that an incompressible half-space answers to exactly, coupling is roundoff but for h^3.
TEST(CoupledContact, OverAnIncompressibleHalfSpaceIsNotCoupled) {
  const auto& surface = surface_half_space(0.5, 16);
  const IndenterMotion motion{ramp(0.3, 0.6), {ramp(0, 0.2), ramp(0, 0.1)}};
  const auto profile = round_profile(surface, 2, 4);
  const auto on = coupled_operators(surface, angular_grid(4)), off = coupled_operators(surface, angular_grid(4), false);
  CoupledContact coupled(on, {}, 0.5, profile, motion, 6), other(off, {}, 0.5, profile, motion, 6);
  for (int k = 0; k < 6; ++k) {
    coupled.step();
    other.step();
  }
  EXPECT_NEAR(coupled.normal_force() / other.normal_force(), 1, 1e-4);
  EXPECT_NEAR(coupled.friction.forces()[0] / other.friction.forces()[0], 1, 1e-3);
}

/// Stick radius over contact radius of a body that is pressed with friction from a depth of 0 on, by an indenter under
/// which the contact grows at a constant rate.
double share_that_sticks(const std::function<double(double)>& profile, double exponent, int n_steps) {
  const auto& surface = surface_half_space(0.3, 32, 3);
  const auto operators = coupled_operators(surface, angular_grid(4, Mirrors::x));
  const auto rings = ring_problems(surface);
  const auto depth = [=](double t, double) {
    return ValueAndRate{0.9 * std::pow(t / (2 * pi), exponent),
                        0.9 * exponent * std::pow(t / (2 * pi), exponent - 1) / (2 * pi)};
  };
  const IndenterMotion motion{depth, {nowhere, nowhere}};
  const MatrixXd heights = ring_means(rings.normal.compliance, profile, {1}).replicate(1, 2);
  CoupledContact contact(operators, {}, 0.2, heights, motion, n_steps);
  const auto history = coupled_contact_history(std::move(contact), rings, exactly(1));
  return history.sticks_at_the_end.radius / history.contact.radius;
}

// Pressing is self-similar, and sticks within one share of the contact under every power law (Spence 1968): for nu =
// 0.3 and mu = 0.2 in 0.6983 of it, by an axisymmetric solution with exact kernels. One of the power laws is a flat
// punch, under which it is proportional and takes a single step. To a ring of the contact.
TEST(CoupledContact, PressedWithFrictionSticksWithinOneShareOfTheContact) {
  constexpr double spence = 0.6983, ring = 1 / (32 * 0.9);
  EXPECT_NEAR(share_that_sticks([](double r) { return r < 1 ? 0.0 : 10.0; }, 1, 1), spence, ring);
  for (const double exponent : {2.0, 4.0})
    EXPECT_NEAR(share_that_sticks([=](double r) { return std::pow(r, exponent); }, exponent, 64), spence, ring);
}

// An elastic body and its indenter: work of normal and tangential forces = stored + lost. In each step that is an
// identity but for points that touch or lift, whose gap closes or opens against the mean of their pressures: of second
// order.
TEST(CoupledContact, LosesWhatIsNotStored) {
  const auto& surface = surface_half_space(0.3);
  const auto operators = coupled_operators(surface, angular_grid(4));
  std::vector<double> left;
  for (const int n_steps : {20, 40, 80}) {
    const IndenterMotion motion{ramp(0, 0.6), {ramp(0, 0.2), ramp(0, 0.1)}};
    CoupledContact contact(operators, {}, 0.5, round_profile(surface, 2, 4), motion, n_steps);
    double work = 0, lost = 0, opening = 0;
    Eigen::Vector3d before(0, 0, 0);
    for (int k = 0; k < n_steps; ++k) {
      const MatrixXd pressed = contact.pressure, open = contact.gap;
      contact.step();
      opening +=
          (operators.normal.areas().transpose() * ((pressed + contact.pressure) / 2).cwiseProduct(contact.gap - open))
              .sum();
      Eigen::Vector3d now = contact.friction.forces();
      now[2] = contact.normal_force();
      const Eigen::Vector3d way(contact.friction.increment[0], contact.friction.increment[1], 0.6 / n_steps);
      work += (now + before).dot(way) / 2;
      before = now;
      lost += contact.friction.friction_work();
    }
    MatrixXd fields(surface.n_rings(), 12);
    fields << contact.friction.traction, contact.pressure;
    const double stored = fields.cwiseProduct(full_contact_test::response(operators, fields)).sum() / 2;
    EXPECT_GT(lost, 1e-3 * work);
    EXPECT_NEAR((work + opening - stored - lost) / work, 0, 1e-9);
    left.push_back((work - stored - lost) / work);
  }
  EXPECT_NEAR(left[2], 0, 1e-3);
  EXPECT_LT(std::abs(left[2]), 0.4 * std::abs(left[1]));
}

// Both forces at once: what they lead to, prescribed as displacements, makes the same forces, and to find it takes
// little more once the stiffness is known.
TEST(CoupledContact, FollowsForcesInBothDirections) {
  const auto& surface = surface_half_space(0.3);
  const auto operators = coupled_operators(surface, angular_grid(4, Mirrors::x));
  const auto profile = round_profile(surface, 2, 2);
  constexpr int n_steps = 12;
  const IndenterMotion forces{ramp(0.6, 1.2), {ramp(0, 0.3), nowhere, true}, true};
  CoupledContact pushed(operators, {}, 0.5, profile, forces, n_steps);
  std::vector<double> depths{pushed.depth}, ways{0};
  EXPECT_NEAR(pushed.normal_force(), 0.6, 1e-9);
  int by_force = 0, by_displacement = 0;  // alternations after the first step
  for (int k = 1; k <= n_steps; ++k) {
    pushed.step();
    if (k > 1) by_force += pushed.n_alternations;
    const double share = static_cast<double>(k) / n_steps;
    ASSERT_NEAR(pushed.normal_force(), 0.6 + 0.6 * share, 1e-8) << k;
    ASSERT_NEAR(pushed.friction.forces()[0], 0.3 * share, 1e-8) << k;
    depths.push_back(pushed.depth);
    ways.push_back(pushed.friction.displacement[0]);
  }
  const auto along = [](const std::vector<double>& values) {
    return [&values](double t, double inside) {
      const double dt = 2 * pi / n_steps;
      const auto k = static_cast<std::size_t>(inside / dt);
      const double rate = (values[k + 1] - values[k]) / dt;
      return ValueAndRate{values[k] + rate * (t - static_cast<double>(k) * dt), rate};
    };
  };
  const IndenterMotion displacements{along(depths), {along(ways), nowhere}};
  CoupledContact moved(operators, {}, 0.5, profile, displacements, n_steps);
  for (int k = 1; k <= n_steps; ++k) {
    moved.step();
    if (k > 1) by_displacement += moved.n_alternations;
  }
  EXPECT_NEAR(moved.normal_force(), 1.2, 1e-7);
  EXPECT_NEAR(moved.friction.forces()[0], 0.3, 1e-7);
  EXPECT_GT(ways.back(), 0.01);
  EXPECT_LT(by_force, 1.5 * by_displacement);
}

// A normal force that stays, and a tangential one that goes round.
TEST(CoupledContact, FollowsForcesAround) {
  const auto& surface = surface_half_space(0.3);
  const auto operators = coupled_operators(surface, angular_grid(4));
  constexpr int n_steps = 16;
  const auto part = [](double (*f)(double), double sign, double (*rate)(double)) {
    return [=](double t, double) { return ValueAndRate{0.1 * f(t), sign * 0.1 * rate(t)}; };
  };
  const IndenterMotion forces{ramp(0.6, 0.6), {part(std::sin, 1, std::cos), part(std::cos, -1, std::sin), true}, true};
  CoupledContact contact(operators, {}, 0.5, round_profile(surface, 2, 4), forces, n_steps);
  for (int k = 1; k <= n_steps; ++k) {
    contact.step();
    const double t = 2 * pi * k / n_steps;
    ASSERT_NEAR(contact.normal_force(), 0.6, 1e-8) << k;
    ASSERT_NEAR(contact.friction.forces()[0], 0.1 * std::sin(t), 1e-8) << k;
    ASSERT_NEAR(contact.friction.forces()[1], 0.1 * std::cos(t), 1e-8) << k;
  }
}

// Every step begins with what the cycle before makes it expect.
TEST(CoupledContact, TakesFewerAlternationsTheCloserItComesToItsPeriodicState) {
  const auto& surface = surface_half_space(0.3);
  const auto operators = coupled_operators(surface, angular_grid(4, Mirrors::x));
  const auto swing = [](double mean, double amplitude) {
    return [=](double t, double) { return ValueAndRate{mean + amplitude * std::sin(t), amplitude * std::cos(t)}; };
  };
  constexpr int n_steps = 16, n_cycles = 6;
  const IndenterMotion motion{swing(0.5, 0.1), {swing(0, 0.05), nowhere}};
  CoupledContact contact(operators, {}, 0.5, round_profile(surface, 2, 2), motion, n_steps);
  std::vector<int> alternations(n_cycles, 0);
  for (int& of_cycle : alternations)
    for (int k = 0; k < n_steps; ++k) {
      contact.step();
      of_cycle += contact.n_alternations;
    }
  EXPECT_LT(alternations.back(), 0.5 * alternations.front());
}

TEST(CoupledContact, RefusesWhatItCannotDo) {
  const auto& surface = surface_half_space(0.3);
  EXPECT_THROW(coupled_operators(surface, angular_grid(4, Mirrors::x_and_y)), std::invalid_argument);
  const auto operators = coupled_operators(surface, angular_grid(4));
  const IndenterMotion too_deep{ramp(3, 3), {nowhere, nowhere}};
  EXPECT_THROW(CoupledContact(operators, {}, 0.5, round_profile(surface, 2, 4), too_deep, 6), NoRoom);
}

// Pressed without friction and left alone, a body with memory and a dashpot stays as it is, also where nothing touches
// it.
TEST(CoupledContact, StaysAtRestWhereNothingMoves) {
  const auto& surface = surface_half_space(0.3);
  const auto operators = coupled_operators(surface, angular_grid(4));
  const IndenterMotion still{ramp(0.5, 0.5), {nowhere, nowhere}};
  CoupledContact contact(operators, {1, {1}, {0.5}, 0.2}, 0.5, round_profile(surface, 2, 4), still, 6);
  const MatrixXd pressure = contact.pressure, gap = contact.gap;
  ASSERT_GT(gap.maxCoeff(), 0.1);
  for (int k = 0; k < 3; ++k) {
    contact.step();
    ASSERT_LT((contact.pressure - pressure).norm(), 1e-8 * pressure.norm()) << k;
    ASSERT_LT((contact.gap - gap).norm(), 1e-8 * gap.norm()) << k;
    ASSERT_LT(contact.friction.traction.norm(), 1e-8 * pressure.norm()) << k;
  }
}

}  // namespace
}  // namespace fretval::fem::coupled_contact_test
