#include "fem/ring_contact/stick_zone/cycle_response.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"

namespace fretval::fem::cycle_response_test {
namespace {

/// Oscillation about an indented rest position, of a body that answers d and u_x with forces of given moduli and lags.
struct Sampled {
  Motion motion = one_frequency(0.8, 0.2, 0.1, 0.7);
  NormalHistory normal;
  FrictionHistory friction;
};

Sampled sampled(int n_steps) {
  Sampled s;
  s.normal.steps_per_cycle = n_steps;
  const double dt = 2 * pi / n_steps, begin = 2 * pi * 20;
  s.normal.first_balance = dt;
  for (auto* series : {&s.normal.time, &s.normal.force, &s.normal.indentation, &s.friction.force, &s.friction.indenter})
    series->resize(n_steps);
  s.normal.force_beyond = s.normal.force_beyond_uncertainty = Eigen::VectorXd::Zero(n_steps);
  s.normal.force_uncertainty = Eigen::VectorXd::Constant(n_steps, 0.003);
  s.friction.force_uncertainty = Eigen::VectorXd::Constant(n_steps, 0.002);
  s.friction.force_off_by_steps = Eigen::VectorXd::Zero(n_steps);
  s.friction.dissipated_uncertainty = 1e-4;
  s.friction.n_steps = 21L * n_steps;
  s.friction.amplitude = 0.1;
  s.friction.dissipated_energy = 0.01;
  for (int k = 0; k < n_steps; ++k) {
    const double t = begin + (k + 1) * dt;
    s.normal.time[k] = t;
    s.normal.indentation[k] = normal_motion(s.motion, t).value;
    s.normal.force[k] = 2 + 0.6 * std::cos(t + 0.3);
    s.friction.indenter[k] = tangential_motion(s.motion, t).value;
    s.friction.force[k] = 0.05 + 0.4 * std::cos(t + 0.7 + 0.5);
  }
  return s;
}

// The area of an ellipse is pi times both amplitudes times the sine of the lag.
TEST(CycleResponse, LoopsOfEllipsesAreExact) {
  const RelaxationModel body{1, {1}, {0.5}, 0};
  const double loops = pi * (0.2 * 0.6 * std::sin(0.3) + 0.1 * 0.4 * std::sin(0.5));
  for (const bool forces : {false, true}) {
    auto s = sampled(24);
    if (forces) {
      for (Eigen::Index k = 0; k < 24; ++k) {
        const double t = s.normal.time[k];
        s.normal.indentation[k] = 0.8 + 0.2 * std::cos(t - 0.3);
        s.friction.indenter[k] = 0.1 * std::cos(t + 0.7 - 0.5);
      }
      s.motion = one_frequency(2, 0.6, 0.4, 0.7);
      s.motion.normal_force = s.motion.tangential_force = true;
    }
    const auto response = cycle_response(body, 0.5, s.motion, 2.6, s.normal, s.friction);
    EXPECT_NEAR(response.friction_work + response.bulk_work, loops, 1e-12) << forces;
    EXPECT_EQ(response.friction_work, 0.01);
    EXPECT_NEAR(response.tangential_work, pi * 0.1 * 0.4 * std::sin(0.5), 1e-12) << forces;
    EXPECT_NEAR(response.sliding_work, 0.5 * 2.6 * 4 * 0.1, 1e-14) << forces;
  }
}

// A force that is uncertain by as much all the way, one way: four times that and the amplitude.
TEST(CycleResponse, CarriesWhatReadingTheForcesLeavesOpen) {
  auto s = sampled(360);
  const auto with_memory = cycle_response({1, {1}, {0.5}, 0}, 0.5, s.motion, 2.6, s.normal, s.friction).uncertainty;
  EXPECT_EQ(with_memory.tangential_force_max, 0.002);
  EXPECT_NEAR(with_memory.tangential_force_mean, 0.002, 1e-15);
  EXPECT_EQ(with_memory.friction_work, 1e-4);
  EXPECT_NEAR(with_memory.tangential_work, 4 * 0.002 * 0.1, 1e-7);
  EXPECT_NEAR(with_memory.cycle_work, 4 * (0.002 * 0.1 + 0.003 * 0.2), 1e-7);
  s.normal.force_beyond_uncertainty.setConstant(0.001);
  const auto with_rim = cycle_response({1, {1}, {0.5}, 0}, 0.5, s.motion, 2.6, s.normal, s.friction).uncertainty;
  EXPECT_NEAR(with_rim.cycle_work, 4 * (0.002 * 0.1 + 0.004 * 0.2), 1e-7);
  EXPECT_EQ(with_rim.tangential_work, with_memory.tangential_work);
  const auto elastic = cycle_response({1, {}, {}, 0}, 0.5, s.motion, 2.6, s.normal, s.friction).uncertainty;
  EXPECT_NEAR(elastic.friction_work, 4 * 0.002 * 0.1, 1e-7);
  s.friction.unseen_slip_energy = 0.01;
  const auto unseen = cycle_response({1, {}, {}, 0}, 0.5, s.motion, 2.6, s.normal, s.friction).uncertainty;
  EXPECT_NEAR(unseen.friction_work - elastic.friction_work, 0.01, 1e-15);
  EXPECT_NEAR(unseen.tangential_work - elastic.tangential_work, 0.01, 1e-15);
  EXPECT_NEAR(unseen.cycle_work - elastic.cycle_work, 0.01, 1e-15);
  s.motion.tangential_force = true;
  const auto prescribed = cycle_response({1, {}, {}, 0}, 0.5, s.motion, 2.6, s.normal, s.friction).uncertainty;
  EXPECT_EQ(prescribed.tangential_force_max, 0);
}

// A force that is too large by 0.01 while it pulls forward and by 0.03 while it pulls back, and lags by nothing.
TEST(CycleResponse, IsOffByWhatStepsLockIn) {
  auto s = sampled(360);
  for (Eigen::Index k = 0; k < 360; ++k) {
    const double t = s.normal.time[k] + 0.7;
    s.friction.force[k] = 0.4 * std::cos(t);
    s.friction.force_off_by_steps[k] = std::sin(t) < 0 ? 0.01 : -0.03;
  }
  const RelaxationModel elastic{1, {}, {}, 0};
  const auto off = cycle_response(elastic, 0.5, s.motion, 2.6, s.normal, s.friction).off_by_steps;
  EXPECT_NEAR(off.work, 2 * 0.1 * (0.01 + 0.03), 1e-4);
  EXPECT_NEAR(off.tangential_force_mean, -0.01, 1e-3);
  s.friction.force[100] = -0.5;
  s.friction.force_off_by_steps[100] = -0.02;
  EXPECT_EQ(cycle_response(elastic, 0.5, s.motion, 2.6, s.normal, s.friction).off_by_steps.tangential_force_max, 0.02);
  const RelaxationModel dashpot{1, {1}, {0.5}, 3 * 2 * pi / 360};  // bears 3 of 5 in a step
  EXPECT_NEAR(cycle_response(dashpot, 0.5, s.motion, 2.6, s.normal, s.friction).off_by_steps.work, off.work * 2 / 5,
              2e-3);
  s.motion.tangential_force = true;
  const auto known = cycle_response(elastic, 0.5, s.motion, 2.6, s.normal, s.friction).off_by_steps;
  EXPECT_EQ(known.tangential_force_max, 0);
  EXPECT_EQ(known.tangential_force_mean, 0);
  EXPECT_NEAR(known.work, 2 * 0.1 * (0.01 + 0.03), 2e-3);
}

TEST(CycleResponse, FindsTheExtremeBetweenTheSteps) {
  const auto s = sampled(36);
  const auto response = cycle_response({}, 0.5, s.motion, 2.6, s.normal, s.friction);
  EXPECT_NEAR(response.tangential_force_max, 0.45, 1e-5);
  EXPECT_LT(s.friction.force.cwiseAbs().maxCoeff(), 0.45 - 5e-5);
  EXPECT_NEAR(response.tangential_force_mean, 0.05, 1e-14);
}

// Sliding at mu F_N = 1 until it turns within a step: what interpolates goes beyond that.
TEST(CycleResponse, LargestForceIsNotBeyondTheFrictionLimit) {
  auto s = sampled(24);
  s.normal.force.setConstant(2);
  for (Eigen::Index k = 0; k < 24; ++k) s.friction.force[k] = k < 12 ? 1 : -1;
  const auto largest = [&](double mu) {
    return cycle_response({}, mu, s.motion, 2, s.normal, s.friction).tangential_force_max;
  };
  EXPECT_EQ(largest(0.5), 1);
  EXPECT_GT(largest(1), 1.02) << "it sticks";
}

// The contact begins to slide a step before mu F_N is largest, half a step after a sample.
TEST(CycleResponse, KnowsTheFrictionLimitBetweenTheSteps) {
  auto s = sampled(24);
  const double step = 2 * pi / 24;
  for (Eigen::Index k = 0; k < 24; ++k) {
    s.normal.force[k] = 2 + 0.6 * std::cos((static_cast<double>(k) - 11.5) * step);
    const double sliding = 0.5 * s.normal.force[k];
    s.friction.force[k] = k < 10 ? sliding - 0.12 * (10 - static_cast<double>(k)) : k < 13 ? sliding : -1;
  }
  const double between = 1.3, sampled_most = s.friction.force.maxCoeff();
  const auto response = cycle_response({}, 0.5, s.motion, 2.6, s.normal, s.friction);
  EXPECT_LT(sampled_most, between - 2e-3);
  EXPECT_NEAR(response.tangential_force_max, between, 1e-4);
  EXPECT_NEAR(response.between_steps.tangential_force_max, response.tangential_force_max - sampled_most, 1e-4);
}

TEST(CycleResponse, MeanForceIsUncertainByTheMeanAndTheLargestByItsOwnStep) {
  auto s = sampled(36);
  s.friction.force_uncertainty = Eigen::VectorXd::LinSpaced(36, 0.001, 0.005);
  Eigen::Index largest = 0;
  s.friction.force.maxCoeff(&largest);  // 0.45, against -0.35
  const auto uncertainty = cycle_response({}, 0.5, s.motion, 2.6, s.normal, s.friction).uncertainty;
  EXPECT_NEAR(uncertainty.tangential_force_mean, 0.003, 1e-15);
  EXPECT_EQ(uncertainty.tangential_force_max, s.friction.force_uncertainty[largest]);
}

// Forces in proportion to the displacements along a path with a corner, u = 0.1 to 0.4 and d = 0.8 to 1, sampled in the
// middle or at the ends of the steps: nothing is lost, and the mean force is that of the mean displacement. So, too,
// where the path is one of forces.
TEST(CycleResponse, AlongAPathKnowsTheForcesInTheMiddleOfTheSteps) {
  auto motion = one_frequency(0.8, 0.2, 0.1, 0);
  motion.path = SampledPath{{0, 2, 2 * pi}, {0.8, 1, 0.8}, {0.1, 0.4, 0.1}, 0.9, 0.25, true};
  const auto& path = *motion.path;
  for (const double fraction : {0.5, 1.0})
    for (const bool forces : {false, true}) {
      motion.normal_force = motion.tangential_force = forces;
      NormalHistory normal;
      FrictionHistory friction;
      normal.pieces = steps_of(path, 60);
      const auto n = static_cast<Eigen::Index>(normal.pieces.size());
      normal.steps_per_cycle = static_cast<int>(n);
      friction.n_steps = n;
      for (auto* series : {&normal.force, &normal.indentation, &normal.force_beyond, &normal.force_uncertainty,
                           &normal.force_beyond_uncertainty, &friction.force, &friction.indenter,
                           &friction.force_uncertainty, &friction.force_off_by_steps})
        series->setZero(n);
      for (Eigen::Index k = 0; k < n; ++k) {
        auto& step = normal.pieces[static_cast<std::size_t>(k)];
        step.fraction = fraction;
        const double t = step.begin + fraction * step.duration(), inside = (step.begin + step.end) / 2,
                     across = along(path, path.tangential, t, inside).value,
                     down = along(path, path.normal, t, inside).value;
        friction.force[k] = (forces ? 1 : 3) * across;
        friction.indenter[k] = across;
        normal.force[k] = (forces ? 1 : 2) * down;
        normal.indentation[k] = down;
      }
      const auto response = cycle_response({1, {}, {}, 0}, 0.5, motion, 2, normal, friction);
      EXPECT_NEAR(response.tangential_work, 0, 1e-14) << fraction << forces;
      EXPECT_NEAR(normal_work(motion, normal), 0, 1e-14) << fraction << forces;
      EXPECT_NEAR(response.tangential_force_mean, (forces ? 1 : 3) * 0.25, 1e-14) << fraction << forces;
    }
}

// A force that pulls the indenter once by 0.3, from where it rests: what sliding by as much would cost.
TEST(CycleResponse, OfASinglePassCountsTheWayFromRest) {
  auto motion = one_frequency(0.8, 0, 0, 0);
  motion.path = SampledPath{{0, 2 * pi}, {0.8, 0.8}, {0, 0.1}, 0.8, 0, false};
  motion.tangential_force = true;
  NormalHistory normal;
  FrictionHistory friction;
  normal.pieces = steps_of(*motion.path, 30);
  const auto n = static_cast<Eigen::Index>(normal.pieces.size());
  normal.steps_per_cycle = static_cast<int>(n);
  friction.n_steps = n;
  for (auto* series : {&normal.force_beyond, &normal.force_uncertainty, &normal.force_beyond_uncertainty,
                       &friction.force_uncertainty, &friction.force_off_by_steps})
    series->setZero(n);
  for (auto& step : normal.pieces) step.fraction = 1;
  normal.force.setConstant(n, 2);
  normal.indentation.setConstant(n, 0.8);
  friction.indenter = Eigen::VectorXd::LinSpaced(n, 0.3 / static_cast<double>(n), 0.3);
  friction.force = friction.indenter / 3;
  EXPECT_NEAR(cycle_response({1, {}, {}, 0}, 0.5, motion, 2, normal, friction).sliding_work, 0.5 * 2 * 0.3, 1e-14);
}

// A force that stands at its largest sample and falls from there within a step: its peak is no less than that sample
// and no more than mu F_N. A smooth one is known, and so is one that is prescribed.
TEST(CycleResponse, LeavesOpenWhereAForceThatBendsIsLargest) {
  auto s = sampled(72);
  const auto response = [&] { return cycle_response({1, {}, {}, 0}, 0.5, s.motion, 2.6, s.normal, s.friction); };
  EXPECT_LT(response().between_steps.tangential_force_max, 1e-5);
  s.friction.force.setConstant(0.1);
  for (Eigen::Index k = 0; k <= 40; ++k) s.friction.force[k] = 0.1 + 0.01 * static_cast<double>(k);
  s.friction.force[41] = 0.45;
  const auto bent = response();
  EXPECT_NEAR(bent.tangential_force_max, 0.5 + 0.02 * 0.02 / (2 * 0.06), 1e-12);  // the vertex of a parabola
  EXPECT_NEAR(bent.between_steps.tangential_force_max, 0.51 - bent.tangential_force_max,
              1e-12);  // what rises goes on rising
  s.normal.force.setConstant(2 * 0.503);
  const auto limited = response();
  EXPECT_NEAR(limited.tangential_force_max, 0.503, 1e-12);
  EXPECT_NEAR(limited.between_steps.tangential_force_max, 0.503 - 0.5, 1e-12);
  s.motion.tangential_force = true;
  EXPECT_EQ(response().between_steps.tangential_force_max, 0);
}

// A body with memory is touched somewhere in a step, at a full force, and left again where the indenter turns.
// Three rings under a pressure of 1, in a contact of mu = 0.5 that slides up to its largest sample, or one more.
TEST(CycleResponse, LeavesOpenWhetherASlidingContactHasStuckForAStep) {
  constexpr int n = 24, largest = 10;
  const auto open = [](int last_sliding) {
    auto s = sampled(n);
    s.normal.force.setConstant(1.8);
    s.normal.pressure = Eigen::MatrixXd::Ones(3, n);
    s.friction.traction = Eigen::MatrixXd::Constant(3, n, 0.1);
    for (int k = 5; k <= last_sliding; ++k) s.friction.traction.col(k) << 0.4, 0.5, 0.5;
    for (int k = 0; k < n; ++k) s.friction.force[k] = k > largest ? -0.1 : 0.9 + 0.01 * (k - largest);
    return cycle_response({1, {}, {}, 0}, 0.5, s.motion, 1.8, s.normal, s.friction).between_steps.tangential_force_max;
  };
  EXPECT_EQ(open(4), 0);
  EXPECT_NEAR(open(largest), 0.01, 1e-15);
  EXPECT_EQ(open(largest + 1), 0);
}

TEST(CycleResponse, LeavesOpenWhereInAStepAForceJumps) {
  constexpr int n = 32;
  constexpr double dt = 2 * pi / n, left = pi;
  const auto loop_of_touching_at = [&](double touched) {
    auto s = sampled(n);
    s.friction.force.setZero();
    for (Eigen::Index k = 0; k < n; ++k) {
      const double phase = std::remainder(s.normal.time[k] - pi, 2 * pi) + pi;
      s.normal.force[k] = phase > touched && phase < left + dt / 4 ? 1 : 0;
    }
    const auto response = cycle_response({1, {1}, {0.5}, 0}, 0.5, s.motion, 1, s.normal, s.friction);
    EXPECT_NEAR(response.between_steps.cycle_work, 0.2 * std::sin(pi / 2) * dt / 2, 0.05 * 0.2 * dt);
    EXPECT_LT(response.between_steps.tangential_work, 1e-15);
    return std::make_pair(response.friction_work + response.bulk_work, response.between_steps.cycle_work);
  };
  const double exact_at_first = -0.2;  // oint F dd = d(left) - d(touched) = -0.2 - 0.2 cos(touched)
  for (const double share : {0.05, 0.5, 0.95}) {
    const double touched = pi / 2 + share * dt;
    const auto [work, open] = loop_of_touching_at(touched);
    EXPECT_LE(std::abs(work - (exact_at_first - 0.2 * std::cos(touched))), 1.05 * open) << share;
  }
}

// What is smooth leaves nothing open, neither does a body whose forces cannot jump.
TEST(CycleResponse, OfSmoothForcesLeavesAThousandthOpen) {
  const auto s = sampled(64);
  const auto open = [&](const RelaxationModel& body) {
    return cycle_response(body, 0.5, s.motion, 2.6, s.normal, s.friction).between_steps;
  };
  EXPECT_LT(open({1, {1}, {0.5}, 0}).cycle_work, 1e-3 * pi * 0.2 * 0.6 * std::sin(0.3));
  EXPECT_LT(open({1, {1}, {0.5}, 0}).tangential_force_mean, 1e-5 * 0.4);
  EXPECT_EQ(open({1, {}, {}, 0}).cycle_work, 0);
}

TEST(CycleResponse, WithoutMemoryFrictionTakesTheTangentialLoop) {
  const auto s = sampled(24);
  const auto response = cycle_response({}, 0.5, s.motion, 2.6, s.normal, s.friction);
  EXPECT_NEAR(response.friction_work, pi * 0.1 * 0.4 * std::sin(0.5), 1e-12);
  EXPECT_EQ(response.bulk_work, 0);
}

// A force in proportion to the rate takes the integral of the squared rate over the period, which is 12 cycles long.
TEST(CycleResponse, OfAMotionThatCreepsIsThatOfAllItsCycles) {
  constexpr int n_cycles = 12, n_steps = 48 * n_cycles;
  auto s = sampled(n_steps);
  s.motion = one_frequency(0.8, 0.2, 0.1, {});
  s.motion.n_creep_cycles = n_cycles;
  const double dt = 2 * pi * n_cycles / n_steps;
  double work = 0, sum_of_squares = 0;
  for (int k = 0; k < n_steps; ++k) {
    s.normal.time[k] = s.normal.time[0] + k * dt;
    const auto across = tangential_motion(s.motion, s.normal.time[k]);
    s.friction.indenter[k] = across.value;
    s.friction.force[k] = 3 * across.rate;
    work += 3 * across.rate * across.rate * dt;
    sum_of_squares += across.rate * across.rate / n_steps;
  }
  EXPECT_NEAR(sum_of_squares, 0.1 * 0.1 / 2, 1e-2 * 0.1 * 0.1) << "a cosine's, twelve times over";
  const auto response = cycle_response({1, {}, {}, 0}, 0.5, s.motion, 2.6, s.normal, s.friction);
  EXPECT_NEAR(response.tangential_work, work, 1e-10);
}

}  // namespace
}  // namespace fretval::fem::cycle_response_test
