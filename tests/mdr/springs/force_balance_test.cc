#include "mdr/springs/force_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mdr/profiles/indentation.h"
#include "mdr/springs/spring_energy.h"

namespace fretval::mdr::force_balance_test {
namespace {

const double mu = 0.4;

TEST(ForceBalance, FindsTheMotionOfTheIndenter) {
  const Profile sphere = parabola(1);
  const SpringBed bed = spring_bed(sphere, 0.5, 300);
  for (const PronyBody& body : {elastic(2), standard_solid(1, 2, 0.2), kelvin_voigt(1, 0.3)}) {
    const SpringStep step(body, mu, 0.05);
    SpringState state = relaxed_state(bed, body, 0.05);
    for (int k = 1; k <= 40; ++k) {
      const double load = 0.012 * (1 + 0.3 * std::sin(0.4 * k)), traction = 0.3 * 1.5 * mu * load * std::sin(0.7 * k);
      const double d = indentation_for_load(step, state, bed, load);
      const double u_x = tangential_for_load(step, state, bed, d, traction);
      step.advance(state, bed, step.arrived(state, d, u_x));
      EXPECT_NEAR((bed.width * state.normal_load).sum() / load, 1, 1e-12);
      EXPECT_NEAR((bed.width * state.tangential_load).sum(), traction, 1e-12 * load);
    }
    EXPECT_THROW(static_cast<void>(tangential_for_load(step, state, bed, state.indenter.indentation, 1)),
                 std::runtime_error);
    EXPECT_THROW(static_cast<void>(indentation_for_load(step, state, bed, -1)), std::invalid_argument);
  }
}

// The lines are what the step itself finds, through loss of contact, touch in mid-step and slip, wherever the indenter
// arrives.
TEST(ForceBalance, LinesAreTheLoadsOfTheStep) {
  const SpringBed bed = spring_bed(parabola(1), 0.5, 60);
  for (const PronyBody& body : {elastic(2), prony(1, {2, 1}, {0.2, 3}), prony(1, {2}, {0.2}, 0.3)}) {
    const SpringStep step(body, mu, 0.05);
    SpringState state = relaxed_state(bed, body, 0.05);
    Eigen::Index n_touched = 0, n_slipping = 0;
    for (int k = 1; k <= 60; ++k) {
      const double d = 0.05 + 0.04 * std::sin(0.9 * k), u_x = 0.03 * std::sin(0.5 * k);
      const NormalLines normal = step.normal_lines(state, bed);
      const TangentialLines tangential = step.tangential_lines(state, bed, d);
      n_touched += (state.normal_load == 0 && d > normal.touch).count();
      const Eigen::ArrayXd stuck = tangential.value + (u_x - state.indenter.tangential) * tangential.slope;
      n_slipping += (stuck.abs() > tangential.most && tangential.most > 0).count();
      step.advance(state, bed, step.arrived(state, d, u_x));
      const Eigen::ArrayXd load = (d > normal.touch).select(normal.slope * (d - normal.zero), 0),
                           traction = stuck.min(tangential.most).max(-tangential.most);
      ASSERT_LT((load - state.normal_load).abs().maxCoeff(), 1e-14) << k;
      ASSERT_LT((traction - state.tangential_load).abs().maxCoeff(), 1e-14) << k;
    }
    EXPECT_GT(n_touched, 100);
    EXPECT_GT(n_slipping, 100);
  }
}

// A flat punch that comes down on a body with a dashpot: all springs touch at once, and at once bear more than is asked
// for.
TEST(ForceBalance, StopsWhereTheLoadJumps) {
  const SpringBed bed = spring_bed([](double) { return 0.0; }, 1.0, 4);
  const PronyBody body = kelvin_voigt(1, 10);
  const SpringStep step(body, mu, 0.05);
  SpringState state = relaxed_state(bed, body, 0);
  step.advance(state, bed, {-0.01, 0, 0, 0});
  const double d = indentation_for_load(step, state, bed, 1e-3);
  EXPECT_NEAR(d, 0, 1e-14);
  const auto load_at = [&](double indentation) {
    SpringState trial = state;
    step.advance(trial, bed, step.arrived(state, indentation, 0));
    return (bed.width * trial.normal_load).sum();
  };
  EXPECT_LT(load_at(d - 1e-12), 1e-3);
  EXPECT_GT(load_at(d + 1e-12), 1e-3);
}

// A load that presses beyond the deepest spring: there numbers may lie farther apart than what is roundoff of the depth.
// All springs touch then, and bear d sum(w) - sum(w g).
TEST(ForceBalance, EndsBeyondTheDeepestSpring) {
  const SpringBed bed = spring_bed(parabola(1), 0.5, 100);
  const double width = bed.width.sum(), filled = (bed.width * bed.depth).sum(), deepest = bed.depth.maxCoeff();
  for (int k = 1; k < 2000; ++k) {
    const double d = deepest * (1 + k * 1e-3), load = d * width - filled;
    EXPECT_NEAR(relaxed_indentation(bed, elastic(1), load * normal_scale(elastic(1))), d, 1e-14);
  }
}

// Elastic force control is quasi-static: the forces give back Hertz' indentation.
TEST(ForceBalance, OfElasticContactIsHertz) {
  const Profile sphere = parabola(1);
  const SpringBed bed = spring_bed(sphere, 0.5, 2000);
  const SpringStep step(elastic(2), mu, 1);
  const double d =
      indentation_for_load(step, relaxed_state(bed, elastic(2), 0.01), bed, normal_force(sphere, 2, 0.1) / (8 * 2));
  EXPECT_NEAR(d / 0.1, 1, 1e-6);
}

}  // namespace
}  // namespace fretval::mdr::force_balance_test
