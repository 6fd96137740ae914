#include "fem/full_contact/vector_friction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fem/contact/gross_slip.h"
#include "fem/history/friction_contact.h"
#include "tests/fem/full_contact/bodies.h"

namespace fretval::fem::vector_friction_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using full_contact_test::hertz_pressure;
using full_contact_test::surface_half_space;

constexpr int n_steps = 24;

/// Displacement along a line and, ahead by a phase, across it.
LateralMotion ellipse(double along, double across, double turned_by, double phase = 0.5) {
  const auto part = [=](double t, double of_along, double of_across) {
    return ValueAndRate{of_along * along * std::sin(t) + of_across * across * (std::sin(t + phase) - std::sin(phase)),
                        of_along * along * std::cos(t) + of_across * across * std::cos(t + phase)};
  };
  const double c = std::cos(turned_by), s = std::sin(turned_by);
  return {[=](double t, double) { return part(t, c, -s); }, [=](double t, double) { return part(t, s, c); }};
}

// One angle has one harmonic, s of order 1, and no direction but that of the motion.
TEST(VectorFriction, WithOneAngleIsTheRingContact) {
  const auto& surface = surface_half_space(0.5);
  const ContactProblem rings(ring_compliance(surface, lateral));
  const SurfaceOperator op(surface, angular_grid(1), SurfaceField::tangential);
  const auto motion = one_frequency(1, 0, 0.5, 0.3);
  const LateralMotion along_x{[&](double t, double) { return tangential_motion(motion, t); },
                              [](double, double) {
                                return ValueAndRate{0, 0};
                              }};
  for (const auto& relaxation :
       {RelaxationModel{}, RelaxationModel{1, {0.5, 2}, {1, 0.1}, 0}, RelaxationModel{1, {0.5}, {1}, 0.2}}) {
    FrictionContact of_rings(rings, relaxation, 0.7, motion, n_steps);
    VectorFriction of_points(op, relaxation, 0.7, along_x, n_steps);
    for (int k = 0; k < 12 * n_steps; ++k) {
      const VectorXd pressure = hertz_pressure(surface) * (1 + 0.4 * std::sin(0.1 * k));
      of_rings.step(pressure);
      of_points.step(pressure);
      ASSERT_LT((of_points.traction.col(0) - of_rings.traction).norm(), 1e-10) << k;
      ASSERT_LT((of_points.slip.col(0) - of_rings.slip).norm(), 1e-10) << k;
      ASSERT_EQ(of_points.traction.col(1).norm(), 0);
    }
    EXPECT_GT(of_rings.slip.norm(), 1e-3);
  }
}

TEST(VectorFriction, TurnsWithItsMotion) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator op(surface, angular_grid(8), SurfaceField::tangential);
  const auto motion = ellipse(0.6, 0.3, 0), turned = ellipse(0.6, 0.3, pi / 2);
  const RelaxationModel relaxation{1, {1}, {0.5}, 0};
  VectorFriction one(op, relaxation, 0.8, motion, n_steps), other(op, relaxation, 0.8, turned, n_steps);
  for (int k = 0; k < n_steps; ++k) {
    one.step(hertz_pressure(surface));
    other.step(hertz_pressure(surface));
    for (Index j = 0; j < 8; ++j) {
      const Index to = (j + 2) % 8;
      ASSERT_LT((other.traction.col(8 + to) - one.traction.col(j)).norm(), 1e-10) << k;
      ASSERT_LT((other.traction.col(to) + one.traction.col(8 + j)).norm(), 1e-10) << k;
    }
    ASSERT_NEAR(other.forces()[1], one.forces()[0], 1e-10);
    ASSERT_NEAR(other.forces()[2], one.forces()[2], 1e-10);
  }
}

// Half of the angles, or a quarter of them, are enough for a motion along x.
TEST(VectorFriction, NeedsNoAnglesThatMirrorsLeaveOut) {
  const auto& surface = surface_half_space(0.5);
  const auto motion = ellipse(0.6, 0, 0);
  const SurfaceOperator whole(surface, angular_grid(8), SurfaceField::tangential),
      half(surface, angular_grid(8, Mirrors::x), SurfaceField::tangential),
      quarter(surface, angular_grid(8, Mirrors::x_and_y), SurfaceField::tangential);
  VectorFriction one(whole, {}, 0.8, motion, n_steps), two(half, {}, 0.8, motion, n_steps),
      four(quarter, {}, 0.8, motion, n_steps);
  for (int k = 0; k < n_steps; ++k) {
    for (auto* friction : {&one, &two, &four}) friction->step(hertz_pressure(surface));
    ASSERT_NEAR(two.forces()[0], one.forces()[0], 1e-10);
    ASSERT_NEAR(four.forces()[0], one.forces()[0], 1e-10);
    ASSERT_NEAR(four.friction_work(), one.friction_work(), 1e-10);
    ASSERT_NEAR(one.forces()[1], 0, 1e-10);
    ASSERT_NEAR(one.forces()[2], 0, 1e-10);
  }
}

/// What the indenter has put in, by the trapezoidal rule, less what an elastic body has stored and friction has lost.
double energy_left(double n_cycles, int steps, double scale) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator op(surface, angular_grid(8), SurfaceField::tangential);
  const auto motion = ellipse(0.6, 0.4, 0.3);
  VectorFriction friction(op, {}, scale, motion, steps);
  double work = 0, lost = 0;
  Eigen::Vector3d before(0, 0, 0);
  for (int k = 0; k < n_cycles * steps; ++k) {
    friction.step(hertz_pressure(surface));
    work += (friction.forces() + before).head(2).dot(friction.increment) / 2;
    before = friction.forces();
    lost += friction.friction_work();
  }
  MatrixXd image;
  op.apply(friction.traction, image);
  const double stored = friction.traction.cwiseProduct(image).sum() / 2;
  EXPECT_GT(lost, 0.1 * work);
  EXPECT_GT(stored, 0.01 * work);
  return (work - stored - lost) / work;
}

// In one step to the next the balance is an identity, whatever the steps.
TEST(VectorFriction, LosesWhatIsNotStored) {
  for (const int steps : {12, 48}) EXPECT_NEAR(energy_left(1.3, steps, 0.8), 0, 1e-9);
}

/// Around a circle, from its rightmost point on.
LateralMotion circle_of(double radius) {
  return {[=](double t, double) {
            return ValueAndRate{radius * (std::cos(t) - 1), -radius * std::sin(t)};
          },
          [=](double t, double) {
            return ValueAndRate{radius * std::sin(t), radius * std::cos(t)};
          }};
}

/// What friction takes in the last of some cycles under a constant pressure of the rings.
double lost_in_a_cycle(const SurfaceOperator& op, const RelaxationModel& relaxation, const LateralMotion& motion,
                       const VectorXd& pressure, int n_cycles, int steps) {
  VectorFriction friction(op, relaxation, 0.8, motion, steps);
  double lost = 0;
  for (int k = 0; k < n_cycles * steps; ++k) {
    friction.step(pressure);
    if (k >= (n_cycles - 1) * steps) lost += friction.friction_work();
  }
  return lost;
}

// The direction of slip turns all the time, and differently at each point; points begin and end to slip inside steps.
TEST(VectorFriction, IsOfHigherThanFirstOrderInItsSteps) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator op(surface, angular_grid(8), SurfaceField::tangential);
  for (const auto& relaxation : {RelaxationModel{}, RelaxationModel{1, {0.5, 2}, {1, 0.1}, 0}}) {
    std::vector<double> lost;
    for (const int steps : {24, 48, 96})
      lost.push_back(lost_in_a_cycle(op, relaxation, ellipse(0.6, 0.4, 0.3), hertz_pressure(surface), 2, steps));
    const double order = std::log2((lost[1] - lost[0]) / (lost[2] - lost[1]));
    EXPECT_GT(order, 1.5) << lost[0] << " " << lost[1] << " " << lost[2];
    EXPECT_NEAR(lost[2] / lost[1], 1, 5e-3);
  }
}

// A disc under one traction, which over a body of nu = 0 displaces all of it alike, drags behind its indenter by l, the
// displacement by the friction limit. Where that goes round a circle of radius u the disc goes round one of
// sqrt(u² - l²), and friction takes 2 pi sqrt(u² - l²) times its force.
TEST(VectorFriction, DragsADiscAroundACircle) {
  const auto& surface = surface_half_space(0, 1);
  ASSERT_EQ(surface.n_rings(), 1);
  const SurfaceOperator op(surface, angular_grid(4), SurfaceField::tangential);
  const double force = 0.8 * op.areas()[0] * 4, radius = 1.5;
  MatrixXd traction = MatrixXd::Zero(1, 8), image;
  traction.leftCols(4).setConstant(0.8);
  op.apply(traction, image);
  const double drag = image.leftCols(4).mean() / op.areas()[0];
  ASSERT_LT((image.leftCols(4).array() / op.areas()[0] - drag).abs().maxCoeff(), 1e-10 * drag);
  ASSERT_GT(drag, 0.3 * radius);
  ASSERT_LT(drag, 0.7 * radius);
  const double exact = 2 * pi * std::sqrt(radius * radius - drag * drag) * force;
  const auto error = [&](int steps) {
    return lost_in_a_cycle(op, {}, circle_of(radius), VectorXd::Constant(1, 1), 4, steps) / exact - 1;
  };
  const double coarse = error(24), fine = error(48);
  EXPECT_LT(std::abs(fine), 5e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3) << coarse << " " << fine;
}

// A circular motion holds the force at an angle to the motion, and the torque at zero.
TEST(VectorFriction, GoesRoundWithACircularMotion) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator op(surface, angular_grid(8), SurfaceField::tangential);
  const auto circle = circle_of(0.4);
  VectorFriction friction(op, {}, 0.8, circle, n_steps);
  for (int k = 0; k < 4 * n_steps; ++k) friction.step(hertz_pressure(surface));
  const auto before = friction.forces();
  for (int k = 0; k < n_steps / 4; ++k) friction.step(hertz_pressure(surface));
  const auto after = friction.forces();
  EXPECT_NEAR(after[0], -before[1], 1e-3 * before.norm());
  EXPECT_NEAR(after[1], before[0], 1e-3 * before.norm());
}

/// Hertz's pressure under a tangential force that goes to and fro.
LateralMotion force_to_and_fro(double amplitude) {
  return {[=](double t, double) {
            return ValueAndRate{amplitude * std::sin(t), amplitude * std::cos(t)};
          },
          [](double, double) {
            return ValueAndRate{0, 0};
          },
          true};
}

// Without a mirror the indenter follows F_y as well; a circle of forces under a constant pressure moves it in a circle.
TEST(VectorFriction, FollowsForcesAround) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator op(surface, angular_grid(8), SurfaceField::tangential);
  const double amplitude = 0.6 * 0.8 * 2 * pi / 3;
  const LateralMotion circle{[=](double t, double) {
                               return ValueAndRate{amplitude * std::sin(t), amplitude * std::cos(t)};
                             },
                             [=](double t, double) {
                               return ValueAndRate{amplitude * std::cos(t), -amplitude * std::sin(t)};
                             },
                             true};
  VectorFriction friction(op, {}, 0.8, circle, n_steps);
  const auto go = [&](int n) {
    for (int k = 0; k < n; ++k) {
      friction.step(hertz_pressure(surface));
      const double balance = 2 * pi * (static_cast<double>(friction.n_steps) - 1 + friction.fraction()) / n_steps;
      ASSERT_NEAR(friction.forces()[0], amplitude * std::sin(balance), 1e-8);
      ASSERT_NEAR(friction.forces()[1], amplitude * std::cos(balance), 1e-8);
    }
  };
  go(4 * n_steps);
  const Eigen::Vector2d before = friction.increment;
  go(n_steps / 4);
  const Eigen::Vector2d after = friction.increment;
  EXPECT_NEAR(after[0], before[1], 1e-3 * before.norm());
  EXPECT_NEAR(after[1], -before[0], 1e-3 * before.norm());
}

// Prescribed as displacements, the way that a force has taken leads to the same force.
TEST(VectorFriction, FollowsAForce) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator op(surface, angular_grid(8, Mirrors::x_and_y), SurfaceField::tangential);
  const double borne = 0.8 * 2 * pi / 3, amplitude = 0.7 * borne;
  const auto force = force_to_and_fro(amplitude);
  for (const auto& relaxation : {RelaxationModel{}, RelaxationModel{1, {1}, {0.5}, 0}}) {
    VectorFriction pushed(op, relaxation, 0.8, force, n_steps);
    std::vector<double> increments, forces;
    for (int k = 0; k < n_steps; ++k) {
      pushed.step(hertz_pressure(surface));
      const double balance = 2 * pi * (k + pushed.fraction()) / n_steps;
      ASSERT_NEAR(pushed.forces()[0], amplitude * std::sin(balance), 1e-8);
      increments.push_back(pushed.increment[0]);
      forces.push_back(pushed.forces()[0]);
    }
    int step = 0;
    double at = 0;
    const LateralMotion displaced{[&](double t, double) {
                                    const double dt = 2 * pi / n_steps;
                                    return ValueAndRate{at + increments[step] * (t / dt - step), increments[step] / dt};
                                  },
                                  [](double, double) {
                                    return ValueAndRate{0, 0};
                                  }};
    VectorFriction moved(op, relaxation, 0.8, displaced, n_steps);
    for (; step < n_steps; ++step) {
      moved.step(hertz_pressure(surface));
      ASSERT_NEAR(moved.forces()[0], forces[step], 1e-7) << step;
      at += increments[step];
    }
    EXPECT_GT(moved.slip.norm(), 1e-4);
  }
}

TEST(VectorFriction, SlidesWhereFrictionDoesNotBearTheForce) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator op(surface, angular_grid(4, Mirrors::x_and_y), SurfaceField::tangential);
  const auto force = force_to_and_fro(1.01 * 0.8 * 2 * pi / 3);
  VectorFriction pushed(op, {}, 0.8, force, n_steps);
  EXPECT_THROW(
      {
        for (int k = 0; k < n_steps / 4; ++k) pushed.step(hertz_pressure(surface));
      },
      GrossSlip);
}

}  // namespace
}  // namespace fretval::fem::vector_friction_test
