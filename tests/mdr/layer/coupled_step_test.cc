#include "mdr/layer/coupled_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/layer/layer_contact.h"
#include "mdr/layer/layer_slip.h"
#include "mdr/springs/spring_history.h"
#include "tests/mdr/error_of.h"

namespace fretval::mdr::coupled_step_test {
namespace {

const double mu = 0.6;

double bears(const CoupledBed& bed, const SpringState& state) {
  return (bed.springs.width * (state.normal_load + state.rim_load)).sum();
}

CoupledBed uncoupled(Eigen::Index n) {
  const LayerModes none{Eigen::MatrixXd(n, 0), Eigen::ArrayXd(0)};
  return {spring_bed(parabola(1), 1.2, n), {1, 0.5}, none, none};
}

std::vector<PronyBody> bodies() {
  return {elastic(1), standard_solid(1, 1.5, 0.3), prony(1, {1, 0.5}, {0.05, 0.4}), kelvin_voigt(1, 0.15)};
}

// Without modes the springs that are always in contact are those of mdr/springs/, step by step. With a dashpot, which
// has no spring in which the contact ends, all of them are, through loss of contact and slip.
TEST(CoupledStep, WithoutCouplingIsTheStepOfIndependentSprings) {
  const double dt = 1.0 / 60;
  const CoupledBed bed = uncoupled(40);
  const IndenterPath path = ramped_path(harmonic_motion({1, 0.4, 0.3, 1, 1, 0.7}), 2);
  for (const PronyBody& body : bodies()) {
    SpringState independent = relaxed_state(bed.springs, body, 1), coupled = relaxed_state(bed, body, 1);
    const SpringStep step(body, mu, dt);
    const CoupledStep coupled_step(bed, body, mu, dt);
    Eigen::Index n = bed.springs.position.size();
    for (int k = 1; k <= 240; ++k) {
      step.advance(independent, bed.springs, path(k * dt));
      coupled_step.advance(coupled, {path(k * dt), {}, {}});
      while (body.viscosity == 0 && (independent.normal_load[n - 1] <= 0 || coupled.rim_load[n - 1] > 0)) --n;
    }
    const auto differ = [n](const Eigen::ArrayXd& one, const Eigen::ArrayXd& other) {
      return (one - other).head(n).abs().maxCoeff();
    };
    EXPECT_GE(n, 10);
    EXPECT_LT(differ(independent.normal_load, coupled.normal_load), 1e-12);
    EXPECT_LT(differ(independent.tangential_load, coupled.tangential_load), 1e-12);
    EXPECT_LT(differ(independent.normal_depth, coupled.normal_depth), 1e-12);
    EXPECT_LT(differ(independent.tangential_shift, coupled.tangential_shift), 1e-12);
    EXPECT_LT(differ(independent.slip, coupled.slip), 1e-12);
  }
}

// Without modes the springs are those of a half-space: Hertz and Cattaneo, F = (4/3) d^(3/2) of E*, and
// F_x = mu F (1 - (1 - A/d)^(3/2)) of G*. Wherever in a spring the contact ends.
TEST(CoupledStep, WithoutCouplingBearsWhatAHalfSpaceDoes) {
  const CoupledBed bed = uncoupled(40);
  const CoupledStep step(bed, elastic(1), mu, 0.1);
  const double limit = mu * spring_modulus_ratio(0.5);
  for (const double d : {0.6, 0.61, 0.63, 0.66, 0.7}) {
    SpringState state = relaxed_state(bed, elastic(1), d);
    const double load = 2 * d * std::sqrt(d) / 3, pull = limit * load * 0.4;
    for (int k = 1; k <= 4; ++k) step.advance(state, {state.indenter, load, pull * k / 4});
    EXPECT_NEAR(state.indenter.indentation, d, 3e-6);
    EXPECT_NEAR(state.indenter.tangential, limit * d * (1 - std::cbrt(0.6 * 0.6)),
                3e-4);  // and the stick zone ends anywhere
  }
}

// Springs of equal width: second order, which two beds extrapolate.
double extrapolated(const std::function<double(Eigen::Index)>& of_springs) {
  return of_springs(200) + (of_springs(200) - of_springs(100)) / 3;
}

TEST(CoupledStep, RelaxedSpringsBearTheLayersContact) {
  const Layer layer{0.7, 0.45};
  const LayerContact contact = layer_contact(parabola(1), layer, 1);
  const double load = extrapolated([&](Eigen::Index n) {
    const CoupledBed bed = coupled_bed(spring_bed(parabola(1), 1.1, n), layer);
    const SpringState state = relaxed_state(bed, elastic(2), contact.indentation);
    const double all = bears(bed, state);
    EXPECT_NEAR(relaxed_indentation(bed, all), contact.indentation, 1e-10);
    return all;
  });
  EXPECT_NEAR(load / contact.load, 1, 1e-7);
}

// A contact that only grows is elastic at every instant but for the factor G (Lee and Radok): its force is the integral
// of G(t-t') over the elastic force of the same layer.
TEST(CoupledStep, AGrowingContactIsLeesAndRadoks) {
  const Layer layer{0.5, 0.5};
  const PronyBody body = standard_solid(1, 1.5, 0.3);
  const double dt = 1.0 / 200, duration = 0.6;
  const int n_steps = 120;
  const CoupledBed bed = coupled_bed(spring_bed(parabola(1), 1.2, 200), layer);
  const CoupledStep step(bed, body, mu, dt);
  SpringState state = relaxed_state(bed, body, 0);
  double memory = 0, elastic_before = 0;
  const double decay = std::exp(-dt / 0.3), gain = branch_gain(body, 0, dt);
  for (int k = 1; k <= n_steps; ++k) {
    const double d = 0.5 * k * dt / duration;
    step.advance(state, {{d, 0.5 / duration, 0, 0}, {}, {}});
    const SpringState at_rest = relaxed_state(bed, body, d);
    const double now = bears(bed, at_rest);
    memory = decay * memory + gain * (now - elastic_before);
    elastic_before = now;
    if (k % 20 != 0) continue;
    EXPECT_NEAR(bears(bed, state) / (now + memory), 1, 2e-4) << k;  // dt: touching springs
  }
}

// A push at a constant indentation is the one of mdr/layer/layer_slip.h, and any G(t) relaxes to it.
TEST(CoupledStep, PushesAsTheRowSays) {
  for (const Layer& layer : {Layer{1, 0.5}, Layer{0.4, 0.3}}) {
    const LayerContact contact = layer_contact(parabola(1), layer, 1);
    const LayerPush push = layer_push_to_radius(contact, mu, 1, 0.7);
    const CoupledBed bed = coupled_bed(spring_bed(parabola(1), 1.1, 300), layer);
    const double limit = mu * spring_modulus_ratio(layer.poisson_ratio);
    for (const PronyBody& body : {elastic(1), standard_solid(1, 0.5, 0.1)}) {
      SpringState state = relaxed_state(bed, body, contact.indentation);
      const double duration = body.branch_moduli.empty() ? 1 : 100, dt = duration / 50;  // slow against 0.1 s
      const CoupledStep step(bed, body, mu, dt);
      for (int k = 1; k <= 50; ++k)
        step.advance(state, {{contact.indentation, 0, push.tangential_displacement * k / 50,
                              push.tangential_displacement / duration},
                             {},
                             {}});
      const double load = (bed.springs.width * state.tangential_load).sum() / (mu * contact.load) *
                          spring_modulus(Direction::tangential, layer.poisson_ratio) /
                          spring_modulus(Direction::normal, layer.poisson_ratio);
      EXPECT_NEAR(load / (push.tangential_force / mu / normal_force(contact, 1)), 1,
                  body.branch_moduli.empty() ? 1e-4 : 1e-3);  // springs; what of the branch has not relaxed
      const auto sticks = state.tangential_load < limit * state.normal_load;
      EXPECT_NEAR(sticks.cast<double>().sum() * bed.springs.width[0], 0.7, 2.1 * bed.springs.width[0]);
    }
  }
}

TEST(CoupledStep, SaysWhenItSlidesAndWhenNothingHoldsTheLayer) {
  const CoupledBed bed = coupled_bed(spring_bed(parabola(1), 1.1, 50), {1, 0.5});
  SpringState state = relaxed_state(bed, elastic(1), 0.5);
  const CoupledStep step(bed, elastic(1), mu, 0.1);
  EXPECT_THROW(step.advance(state, {state.indenter, {}, 10.0}), GrossSlip);
  const CoupledBed sliding = coupled_bed(spring_bed(parabola(1), 1.1, 50), {1, 0.5, LayerBase::frictionless});
  SpringState free = relaxed_state(sliding, elastic(1), 0.5);
  const CoupledStep sliding_step(sliding, elastic(1), mu, 0.1);
  sliding_step.advance(free, {{0.6, 1, 0, 0}, {}, {}});
  EXPECT_NE(error_of([&] {
              sliding_step.advance(free, {{0.6, 0, 0.1, 1}, {}, {}});
            }).find("frictionless"),
            std::string::npos);
  EXPECT_NE(error_of([&] { CoupledStep(bed, elastic(1), 0, 0.1); }).find("friction"), std::string::npos);
  EXPECT_NE(error_of([&] { CoupledStep(bed, elastic(1), mu, 0); }).find("time step"), std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::coupled_step_test
