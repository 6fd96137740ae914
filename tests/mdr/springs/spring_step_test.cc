#include "mdr/springs/spring_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "mdr/profiles/indentation.h"
#include "mdr/springs/spring_energy.h"
#include "mdr/stick/surface_fields.h"
#include "mdr/support/constants.h"
#include "tests/worse.h"

namespace fretval::mdr::spring_step_test {
namespace {

const double mu = 0.4;

SpringBed flat_bed(Eigen::Index n) {
  return spring_bed([](double) { return 0.0; }, 1.0, n);
}

// Hertz and Cattaneo-Mindlin by elastic springs: the force error of a partial spring at the edge is of order width^2.
TEST(SpringStep, ElasticSpringsAreHertzAndCattaneoMindlin) {
  const Profile sphere = parabola(2);
  const double d = 0.1, u_x = 0.03, G = 3;
  const SpringBed bed = spring_bed(sphere, 0.5, 2000);
  SpringState state = relaxed_state(bed, elastic(G), 0);
  const SpringStep step(elastic(G), mu, 1);
  step.advance(state, bed, {d, 0, 0, 0});
  EXPECT_NEAR(normal_force(bed, elastic(G), state) / normal_force(sphere, G, d), 1, 1e-6);
  step.advance(state, bed, {d, 0, u_x, 0});
  EXPECT_NEAR(tangential_force(bed, elastic(G), state) / tangential_force_cattaneo_mindlin(sphere, G, mu, d, u_x), 1,
              1e-6);
  const double c = stick_radius_cattaneo_mindlin(sphere, mu, d, u_x);
  for (Eigen::Index j = 0; j < 2000; ++j) {
    if (bed.position[j] < c - 1e-3) {
      EXPECT_NEAR(state.tangential_shift[j], u_x, 1e-16);
    }
    if (bed.position[j] > c + 1e-3) {
      EXPECT_LT(state.tangential_shift[j], u_x);
    }
  }
}

// Step indentation and relaxation: q = 4 G(t) d, exact for every dt, because the springs of a flat punch stay put.
TEST(SpringStep, RelaxationAfterAStepIsExact) {
  const PronyBody body = prony(1, {2, 0.5}, {0.3, 4});
  const SpringBed bed = flat_bed(3);
  const double dt = 0.17;
  SpringState state = relaxed_state(bed, body, 0);
  // A jump is a motion within a step of no duration.
  SpringStep(body, mu, 1e-12).advance(state, bed, {0.01, 0, 0, 0});
  const SpringStep step(body, mu, dt);
  for (int k = 1; k <= 50; ++k) {
    step.advance(state, bed, {0.01, 0, 0, 0});
    EXPECT_NEAR(normal_force(bed, body, state) / (8 * relaxation(body, k * dt) * 0.01), 1, 1e-11);
  }
}

// Where a step is so short that theta comes from its series, the tenth digit of the recovery tells its slope.
TEST(SpringStep, FreeKelvinVoigtSpringRecoversExactlyInShortSteps) {
  const PronyBody body = kelvin_voigt(1, 2000);
  const SpringBed bed = flat_bed(1);
  SpringState state = relaxed_state(bed, body, 1);
  SpringStep(body, mu, 1).advance(state, bed, {-1, -2, 0, 0});
  EXPECT_NEAR(1 - state.normal_depth[0], -std::expm1(-1.0 / 2000), 1e-14);
}

// A free Kelvin-Voigt spring recovers as exp(-G0 t/eta), which the fitted theta rule follows exactly for every dt.
TEST(SpringStep, FreeKelvinVoigtSpringRecoversExactly) {
  const PronyBody body = kelvin_voigt(2, 0.6);
  const SpringBed bed = flat_bed(1);
  for (const double dt : {0.01, 0.3, 5.0}) {
    SpringState state = relaxed_state(bed, body, 0.1);
    const SpringStep step(body, mu, dt);
    for (int k = 1; k <= 4; ++k) {
      step.advance(state, bed, {-1, 0, 0, 0});
      EXPECT_NEAR(state.normal_depth[0], 0.1 * std::exp(-k * dt / 0.3), 1e-15) << dt;
      EXPECT_EQ(state.normal_load[0], 0);
    }
  }
}

// Full stick in permanent contact: force amplitudes |G|, heat pi G'' u^2 per cycle, springs 4 and 8/3 per length.
TEST(SpringStep, OscillatingFlatPunchHasTheComplexModulus) {
  for (const PronyBody& body : {standard_solid(1, 2, 0.2), prony(1, {1, 3, 2, 1}, {0.01, 0.1, 1, 10}),
                                kelvin_voigt(1, 0.4), prony(1, {2}, {0.2}, 0.3)}) {
    const SpringBed bed = flat_bed(4);
    const double omega = 2.5, normal = 0.01, tangential = 0.02;
    double before = 0;
    for (const int n : {100, 200}) {
      const double dt = 2 * pi / omega / n;
      const SpringStep step(body, 10, dt);
      SpringState state = relaxed_state(bed, body, 1);
      Dissipation heat;
      double worst = 0;
      for (int k = 1; k <= 60 * n; ++k) {
        const double angle = omega * k * dt;
        const SpringState last = state;
        step.advance(state, bed,
                     {1 + normal * std::sin(angle), normal * omega * std::cos(angle), tangential * std::sin(angle),
                      tangential * omega * std::cos(angle)});
        if (k <= 59 * n) continue;
        const Dissipation more = dissipation({bed.width, bed.width}, body, 10, dt, last, state);
        heat = {heat.friction + more.friction, heat.bulk + more.bulk};
        const std::complex<double> modulus = complex_modulus(body, omega);
        const double expected =
            8 * (1 + normal * (modulus.real() * std::sin(angle) + modulus.imag() * std::cos(angle)));
        worst = worse(worst, std::abs(normal_force(bed, body, state) - expected));
      }
      const double loss = complex_modulus(body, omega).imag();
      const double expected = pi * loss * (8 * normal * normal + 16.0 / 3 * tangential * tangential);
      EXPECT_NEAR(heat.bulk / expected, 1, 30.0 / (n * n));
      EXPECT_NEAR(heat.friction / expected, 0, 1e-11);  // roundoff of the slip times the limit
      // Second order, or exact to roundoff where there is no branch.
      if (before > 1e-12) {
        EXPECT_NEAR(before / worst, 4, 0.2);
      }
      before = worst;
    }
  }
}

// A branch split into several with its relaxation time is the same body, whether the number of branches is known to the
// compiler (up to three) or not: oblique, with slip and loss of contact.
TEST(SpringStep, ASplitBranchIsTheSameBody) {
  const SpringBed bed = spring_bed(parabola(1), 0.5, 50);
  const auto end_of_path = [&](const PronyBody& body) {
    const SpringStep step(body, mu, 0.05);
    SpringState state = relaxed_state(bed, body, 0.1);
    for (int k = 1; k <= 64; ++k) {
      const double d = 0.1 + 0.12 * std::sin(0.3 * k), u_x = 0.05 * std::sin(0.2 * k);
      step.advance(state, bed,
                   {d, (d - state.indenter.indentation) / 0.05, u_x, (u_x - state.indenter.tangential) / 0.05});
    }
    return state;
  };
  for (const double viscosity : {0.0, 0.1}) {
    const SpringState whole = end_of_path(prony(1, {2}, {0.3}, viscosity));
    ASSERT_GT(whole.tangential_load.abs().maxCoeff(), 1e-3);
    for (const auto& moduli :
         {std::vector<double>{0.5, 1.5}, {0.25, 0.75, 1}, {0.25, 0.75, 0.5, 0.5}, {0.25, 0.25, 0.5, 0.5, 0.5}}) {
      const SpringState split = end_of_path(prony(1, moduli, std::vector<double>(moduli.size(), 0.3), viscosity));
      const auto difference = [](const auto& a, const auto& b) { return (a - b).abs().maxCoeff(); };
      EXPECT_LT(difference(split.normal_load, whole.normal_load), 1e-14) << moduli.size();
      EXPECT_LT(difference(split.tangential_load, whole.tangential_load), 1e-14) << moduli.size();
      EXPECT_LT(difference(split.normal_memory.rowwise().sum(), whole.normal_memory.col(0)), 1e-14);
      EXPECT_LT(difference(split.tangential_memory.rowwise().sum(), whole.tangential_memory.col(0)), 1e-14);
    }
  }
}

// Roundoff of each of very many steps would add up to slip.
TEST(SpringStep, SpringsThatStickSlipByNothingAtAll) {
  const SpringBed bed = flat_bed(7);
  for (const PronyBody& body : {elastic(1), prony(1, {2, 0.5}, {0.3, 4}), kelvin_voigt(1, 0.2)}) {
    SpringState state = relaxed_state(bed, body, 1);
    const SpringStep step(body, mu, 0.1);
    for (int k = 1; k <= 50; ++k) {
      step.advance(state, bed, {1, 0, 0.01 * std::sin(0.3 * k), 0.03 * std::cos(0.3 * k)});
      EXPECT_TRUE((state.slip == 0).all()) << k;
    }
    EXPECT_GT(state.tangential_load.abs().minCoeff(), 0);
  }
}

TEST(SpringStep, RejectsBadArguments) {
  EXPECT_THROW(SpringStep(elastic(1), 0, 1), std::invalid_argument);
  EXPECT_THROW(SpringStep(elastic(1), 1, 0), std::invalid_argument);
  EXPECT_THROW(relaxed_state(flat_bed(2), elastic(1), NAN), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::spring_step_test
