#include "fem/contact/force_balance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fem/expect_solver_error.h"

namespace fretval::fem::force_balance_test {
namespace {

/// Of a parabola, unit everything: 0 off the surface.
double hertz(double d) {
  return d > 0 ? std::pow(d, 1.5) : 0;
}

// From both sides, from off the surface, and with a stiffness that is a hundred times too large or too small.
TEST(ForceBalance, FindsTheDisplacement) {
  for (const double guess : {-0.5, 0.01, 0.9, 1.0, 5.0})
    for (const double stiffness : {0.015, 1.5, 150.0})
      EXPECT_NEAR(displacement_for_force(hertz, 1, {guess, stiffness, 1}), 1, 1e-11) << guess << " " << stiffness;
}

TEST(ForceBalance, FindsNoForceToo) {
  EXPECT_NEAR(displacement_for_force([](double u) { return std::sinh(u - 2); }, 0, {0, 1, 1}), 2, 1e-12);
}

TEST(ForceBalance, NeedsFewForces) {
  int n = 0;
  const auto counted = [&n](double d) { return ++n, hertz(d); };
  displacement_for_force(counted, 1, {0.98, 1.5, 1});
  EXPECT_LE(n, 5);
}

// The attempt is that of the displacement, also where the balance is between two trials, and is seldom made twice.
TEST(ForceBalance, GivesTheAttemptThatBalances) {
  int n = 0;
  const auto make = [&n](double u) { return ++n, u; };
  const auto smooth = attempt_for_force(make, [](double u) { return hertz(u); }, 1, {0.98, 1.5, 1});
  EXPECT_EQ(smooth.first, smooth.second);
  EXPECT_LE(n, 5);
  const auto jumping = [](double u) { return u < 0.3 ? u : u + 0.1; };
  const auto between = attempt_for_force(make, jumping, 0.35, {0, 1, 1});
  EXPECT_EQ(between.first, between.second);
}

// A reading that jumps over the value: there is its balance.
TEST(ForceBalance, IsWhereTheForceJumps) {
  const auto jumping = [](double u) { return u < 0.3 ? u : u + 0.1; };
  EXPECT_NEAR(displacement_for_force(jumping, 0.35, {0, 1, 1}), 0.3, 1e-12);
}

// A stiff body is known as closely, and a soft one is not asked for more than there is.
TEST(ForceBalance, IsWhereTheForceOfAnyStiffnessJumps) {
  for (const double stiffness : {1e-4, 1.0, 1e4}) {
    const auto jumping = [=](double u) { return stiffness * (u < 0.3 ? u : u + 0.1); };
    EXPECT_NEAR(displacement_for_force(jumping, 0.35 * stiffness, {0, stiffness, stiffness}), 0.3, 1e-12) << stiffness;
  }
}

TEST(ForceBalance, SaysWhenThereIsNone) {
  expect_solver_error(
      [] {
        displacement_for_force([](double u) { return std::tanh(u); }, 1.5, {0, 1, 1});
      },
      {"no displacement", "1.5"});
}

// Two forces that depend on both displacements, one of them bending off like friction near its limit.
TEST(ForcesBalance, FindsTheDisplacementsOfSeveralForces) {
  const auto forces = [](const Eigen::VectorXd& u, double) -> Eigen::VectorXd {
    return Eigen::Vector2d(std::pow(u[0] + 1, 1.5) + 0.1 * u[1], std::tanh(2 * u[1]) + 0.1 * u[0]);
  };
  const Eigen::Vector2d exact(0.3, 0.8);
  auto found = displacements_for_forces(forces, forces(exact, 0), {Eigen::Vector2d::Zero(), {}}, 1e-4, 1e-12);
  EXPECT_LT((found.displacements - exact).norm(), 1e-10);
  int n = 0;  // displacements that are tried
  Eigen::VectorXd last = Eigen::Vector2d::Zero();
  const auto counted = [&](const Eigen::VectorXd& u, double within) {
    if (u != last) ++n;
    last = u;
    return forces(u, within);
  };
  const Eigen::Vector2d next(0.31, 0.81);
  found = displacements_for_forces(counted, forces(next, 0), found, 1e-4, 1e-9);
  EXPECT_LT((found.displacements - next).norm(), 1e-7);
  EXPECT_LE(n, 6) << "the stiffness is known from the search before";
}

// Forces that are as wrong as they may be: the balance is found all the same, and few of them are asked for closely.
TEST(ForcesBalance, AsksForForcesAsCloselyAsItCanMakeUseOf) {
  constexpr double enough = 1e-9;
  int n = 0, n_close = 0;
  const auto forces = [&](const Eigen::VectorXd& u, double within) -> Eigen::VectorXd {
    ++n;
    if (within < 10 * enough) ++n_close;
    const Eigen::Vector2d error = within * Eigen::Vector2d(n % 2 == 0 ? 1 : -1, n % 3 == 0 ? 1 : -1);
    return Eigen::Vector2d(std::pow(u[0] + 1, 1.5) + 0.1 * u[1], std::tanh(2 * u[1]) + 0.1 * u[0]) + error;
  };
  const Eigen::Vector2d exact(0.3, 0.8);
  const Eigen::Vector2d values(std::pow(1.3, 1.5) + 0.08, std::tanh(1.6) + 0.03);
  Eigen::Matrix2d stiffness;
  stiffness << 1.7, 0.1, 0.1, 0.3;
  const auto found = displacements_for_forces(forces, values, {Eigen::Vector2d(0.31, 0.82), stiffness}, 1e-4, enough);
  EXPECT_LT((found.displacements - exact).norm(), 10 * enough);
  EXPECT_LT(2 * n_close, n) << n_close;
  const auto single = [&](const Eigen::VectorXd& u, double within) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, std::pow(u[0], 1.5) + (++n % 2 == 0 ? within : -within));
  };
  const auto one = displacements_for_forces(single, Eigen::VectorXd::Constant(1, 8),
                                            {Eigen::VectorXd::Constant(1, 3.9), {}}, 1e-4, enough);
  EXPECT_NEAR(one.displacements[0], 4, enough);
}

// Friction that turns with the displacement and is nearly used up, from where all sticks: 0.9999 of its limit is borne
// at 0.9999/sqrt(1 - 0.9999^2) times the elastic displacement of the limit, in the direction of the force.
TEST(ForcesBalance, FindsDisplacementsWhereNearlyAllSlips) {
  const auto friction = [](const Eigen::VectorXd& u, double) -> Eigen::VectorXd {
    return u / std::sqrt(1 + u.squaredNorm());
  };
  constexpr double share = 0.9999;
  const double far = share / std::sqrt(1 - share * share);
  const Eigen::Vector2d way(0.6, -0.8);
  for (const Eigen::Vector2d& start : {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(-20, 3)}) {
    const BalanceOfForces guess{start, Eigen::Matrix2d::Identity()};
    const auto found = displacements_for_forces(friction, share * way, guess, 1e-4, 1e-12);
    EXPECT_LT((found.displacements - far * way).norm(), 1e-5 * far) << start.transpose();
  }
}

// Where a contact has come apart no small displacement changes its force.
TEST(ForcesBalance, FindsItsWayBackToTheContact) {
  const auto force = [](const Eigen::VectorXd& at, double) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, std::pow(std::max(0.0, at[0] - 1), 1.5));
  };
  const auto found =
      displacements_for_forces(force, Eigen::VectorXd::Constant(1, 0.125),
                               {Eigen::VectorXd::Zero(1), Eigen::MatrixXd::Constant(1, 1, 1)}, 1e-4, 1e-9);
  EXPECT_NEAR(found.displacements[0], 1.25, 1e-8);
}

TEST(ForcesBalance, SaysWhereThereIsNone) {
  const auto bounded = [](const Eigen::VectorXd& u, double) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, std::tanh(u[0]));
  };
  EXPECT_THROW(
      displacements_for_forces(bounded, Eigen::VectorXd::Constant(1, 1.5), {Eigen::VectorXd::Zero(1), {}}, 1e-4, 1e-9),
      SolverError);
}

}  // namespace
}  // namespace fretval::fem::force_balance_test
