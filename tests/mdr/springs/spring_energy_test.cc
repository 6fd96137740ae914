#include "mdr/springs/spring_energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mdr/springs/spring_history.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::spring_energy_test {
namespace {

const double mu = 0.4;

SpringBed flat_bed(Eigen::Index n) {
  return spring_bed([](double) { return 0.0; }, 1.0, n);
}

// A flat punch of radius 1 pressed in by d: F = 8 G d, with energy F d/2; stuck and pulled by u: (16/3) G u.
TEST(SpringEnergy, OfAnElasticFlatPunchIsHalfForceTimesDisplacement) {
  const PronyBody body = elastic(3);
  const SpringBed bed = flat_bed(4);
  SpringState state = relaxed_state(bed, body, 0.1);
  SpringStep(body, 1e9, 1).advance(state, bed, {0.1, 0, -0.02, 0});
  EXPECT_NEAR(normal_force(bed, body, state), 8 * 3 * 0.1, 1e-14);
  EXPECT_NEAR(tangential_force(bed, body, state), -16 * 0.02, 1e-14);
  EXPECT_NEAR(stored_energy(bed, body, state), 8 * 3 * 0.1 * 0.1 / 2 + 16 * 0.02 * 0.02 / 2, 1e-14);
}

// Of a flat punch F/(2 pi a^2) = 4 G d/(pi a); Hertz: 8 G a/(pi R), of second order.
TEST(SpringEnergy, PressureOnTheAxisIsThatOfTheElasticBody) {
  const PronyBody body = elastic(3);
  const SpringBed flat = flat_bed(4);
  EXPECT_NEAR(axis_pressure(axis_weights(flat), body, relaxed_state(flat, body, 0.1)), 4 * 3 * 0.1 / pi, 1e-14);
  const double a = 0.7, exact = 8 * 3 * a / (pi * 2);
  std::vector<double> errors;
  for (const Eigen::Index n : {50, 100}) {
    const SpringBed bed = spring_bed(parabola(2), a, n);
    errors.push_back(std::abs(axis_pressure(axis_weights(bed), body, relaxed_state(bed, body, a * a / 2)) / exact - 1));
  }
  EXPECT_LT(errors[1], 1e-4);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.2);
}

// Pressed in at a constant rate from first touch: q = 4 (G d' + eta v) up to x = sqrt(R d), where it jumps to 0.
TEST(SpringEnergy, ForceOfADashpotsEdgeIsThatOfAPartOfASpring) {
  const double G = 3, eta = 2, R = 5, v = 0.1;
  const PronyBody body = kelvin_voigt(G, eta);
  const auto worst_error = [&](Eigen::Index n) {
    const SpringBed bed = spring_bed(parabola(R), 1, n);
    SpringState state = relaxed_state(bed, body, 0);
    const double dt = 0.01;
    double worst = 0;
    for (int k = 1; k * v * dt < 1 / R; ++k) {
      const double d = k * v * dt, a = std::sqrt(R * d);
      SpringStep(body, mu, dt).advance(state, bed, {d, v, 0, 0});
      if (a < 0.3) continue;
      const double exact = 8 * (G * d * a * 2 / 3 + eta * v * a);
      worst = std::max(worst, std::abs(forces_of_springs(bed, body, axis_weights(bed), state, {}).normal / exact - 1));
    }
    return worst;
  };
  const double coarse = worst_error(50), fine = worst_error(100);
  EXPECT_LT(fine, 1e-3);  // whole springs: up to 1e-2
  EXPECT_GT(std::log2(coarse / fine), 1.8);
}

// Springs end 0.2 or 0.8 of a spring beyond the contact of radius 0.6; with the part of a spring their widths add up to
// it, whether the last spring touches or not.
TEST(SpringEnergy, WidthsEndAtTheEdge) {
  for (const double beyond : {0.2, 0.8}) {
    const double a = 0.6, width = a / (50 - beyond);
    const SpringBed bed = spring_bed(parabola(1), 50 * width, 50);
    const auto state = relaxed_state(bed, elastic(1), a * a);
    const Eigen::ArrayXd in_contact = (state.normal_load > 0).cast<double>(), all = bed.width + edge_widths(bed, state);
    EXPECT_GT(std::abs((bed.width * in_contact).sum() - a) / width, 0.19) << beyond;
    EXPECT_NEAR((all * in_contact).sum() / width, a / width, 0.02) << beyond;
    EXPECT_NEAR((all * in_contact * state.normal_load).sum(), 2 * a * a * a / 3, 1e-6) << beyond;
  }
  const SpringBed two = spring_bed(parabola(1), 0.5, 2);
  EXPECT_EQ(edge_widths(two, relaxed_state(two, elastic(1), 0.1)).abs().maxCoeff(), 0);
}

// A small oscillation of a standard solid, after ten periods: pi G'' amplitude^2 of each direction times the contact.
TEST(SpringEnergy, SmallOscillationsLoseWhatTheWholeContactDoes) {
  const double d = 0.36, normal = 1e-4 * d, shift = 1e-6 * d, omega_tau = 0.5, loss = 2 * omega_tau / (1 + 0.25);
  const auto motion = harmonic_motion({d, normal, shift, 1, 1, 0.3});
  for (const double beyond : {0.2, 0.4}) {
    const auto body = standard_solid(1, 2, omega_tau / (2 * pi));
    const auto bed = spring_bed(parabola(1), 0.6 * 50 / (50 - beyond), 50);
    const auto history = spring_history(bed, body, 1, {ramped_path(motion, 10), {}, {}}, {1, 360, 10, 400, 1e-9});
    const double exact = pi * loss * 0.6 * (8 * normal * normal + 16.0 / 3 * shift * shift);
    EXPECT_NEAR(history.bulk_work / exact, 1, 3e-4) << beyond;  // whole springs: 4e-3, 8e-3
    EXPECT_NEAR(history.indenter_work / exact, 1, 3e-4) << beyond;
  }
}

// After a jump by d, the branch holds G1 d^2/2 per unit of the scale, and e^(-2 dt/tau) of it a step later; the rest
// is heat. Tangentially the scale is 2/3 of the normal one.
TEST(SpringEnergy, RelaxingBranchTurnsWhatItStoredIntoHeat) {
  const double G0 = 2, G1 = 5, tau = 0.3, dt = 0.2, stuck = 10, d = 0.01, u = 0.004;
  const PronyBody body = standard_solid(G0, G1, tau);
  const SpringBed bed = flat_bed(3);
  SpringState state = relaxed_state(bed, body, 0);
  SpringStep(body, stuck, 1e-12).advance(state, bed, {d, 0, u, 0});  // a jump
  const double jump = 8 * d * d / 2 + 16.0 / 3 * u * u / 2;
  EXPECT_NEAR(stored_energy(bed, body, state) / ((G0 + G1) * jump), 1, 1e-11);
  const SpringState before = state;
  SpringStep(body, stuck, dt).advance(state, bed, {d, 0, u, 0});
  const double left = std::exp(-2 * dt / tau);
  EXPECT_NEAR(stored_energy(bed, body, state) / ((G0 + G1 * left) * jump), 1, 1e-11);
  const Dissipation heat = dissipation({bed.width, bed.width}, body, stuck, dt, before, state);
  EXPECT_NEAR(heat.bulk / (G1 * (1 - left) * jump), 1, 1e-11);
  EXPECT_NEAR(heat.friction, 0, 1e-17);
}

// Constant rate v for dt: eta v^2 dt per unit of the scale, whatever the sign of v.
TEST(SpringEnergy, DashpotHeatIsItsForceTimesThePath) {
  const PronyBody body = kelvin_voigt(2, 0.7);
  const SpringBed bed = flat_bed(3);
  for (const double move : {0.03, -0.03}) {
    const SpringState before = relaxed_state(bed, body, 0.1);
    SpringState after = before;
    after.normal_depth += move;
    EXPECT_NEAR(dissipation({bed.width, bed.width}, body, mu, 0.5, before, after).bulk, 8 * 0.7 * move * move / 0.5,
                1e-15);
    after = before;
    after.tangential_shift += move;
    EXPECT_NEAR(dissipation({bed.width, bed.width}, body, mu, 0.5, before, after).bulk,
                16.0 / 3 * 0.7 * move * move / 0.5, 1e-15);
  }
}

// Under full slip, force mu F times the path of the indenter.
TEST(SpringEnergy, SlidingHeatIsFrictionForceTimesPath) {
  const PronyBody body = elastic(3);
  const SpringBed bed = spring_bed(parabola(1), 0.3, 50);
  const SpringStep step(body, mu, 1);
  SpringState state = relaxed_state(bed, body, 0.09);
  step.advance(state, bed, {0.09, 0, 1, 0});  // all slide
  const SpringState before = state;
  step.advance(state, bed, {0.09, 0, 1.5, 0});
  EXPECT_NEAR(dissipation({bed.width, bed.width}, body, mu, 1, before, state).friction /
                  (mu * normal_force(bed, body, state) * 0.5),
              1, 1e-13);
}

// Work done on the springs = heat + change of what they store, at every step and up to the third order in it.
TEST(SpringEnergy, EnergyBalances) {
  const Profile sphere = parabola(1);
  const SpringBed bed = spring_bed(sphere, 0.4, 100);
  for (const PronyBody& body : {elastic(2), standard_solid(1, 2, 0.2), prony(1, {2, 1}, {0.1, 0.5}, 0.05)}) {
    double before = 0;
    for (const int n : {200, 400, 800}) {
      const double dt = 2.0 / n;
      const SpringStep step(body, mu, dt);
      SpringState state = relaxed_state(bed, body, 0.1);
      const double start = stored_energy(bed, body, state);
      double work = 0, heat = 0;
      for (int k = 1; k <= n; ++k) {
        const double t = k * dt;
        const SpringState last = state;
        step.advance(
            state, bed,
            {0.1 + 0.04 * std::sin(3 * t), 0.12 * std::cos(3 * t), 0.02 * std::sin(4 * t), 0.08 * std::cos(4 * t)});
        const Dissipation more = dissipation({bed.width, bed.width}, body, mu, dt, last, state);
        heat += more.friction + more.bulk;
        work += (normal_force(bed, body, last) + normal_force(bed, body, state)) / 2 *
                    (state.indenter.indentation - last.indenter.indentation) +
                (tangential_force(bed, body, last) + tangential_force(bed, body, state)) / 2 *
                    (state.indenter.tangential - last.indenter.tangential);
      }
      const double imbalance = std::abs(work - heat - (stored_energy(bed, body, state) - start)) / heat;
      EXPECT_LT(imbalance, 200.0 / n / n + (body.viscosity > 0 ? 2.0 / n : 0)) << "n = " << n;
      if (before > 0 && body.viscosity == 0) {
        EXPECT_LT(imbalance, before);
      }
      before = imbalance;
    }
  }
}

// Mindlin and Deresiewicz at constant normal force, in MDR's terms: a spring slips twice a cycle by
// 2 (u_x0 - (3 mu/2)(d - g)), under mu q_z. Summed over the slip zone and exact for every number of steps.
TEST(SpringEnergy, MindlinDeresiewiczLoop) {
  const Profile sphere = parabola(1);
  const double d = 0.1, u_x = 0.02, G = 2;
  const SpringBed bed = spring_bed(sphere, std::sqrt(d), 4000);
  const SpringStep step(elastic(G), mu, 1);
  SpringState state = relaxed_state(bed, elastic(G), d);
  double heat = 0;
  for (int k = 1; k <= 30; ++k) {
    const SpringState last = state;
    step.advance(state, bed, {d, 0, u_x * std::sin(2 * pi * k / 20), 0});
    if (k > 10) heat += dissipation({bed.width, bed.width}, elastic(G), mu, 1, last, state).friction;
  }
  // int over the slip zone of 2 * 4 mu (4 G)(d - g)(u_x - 1.5 mu (d - g)) dx with g = x^2.
  const double a = std::sqrt(d), c = std::sqrt(d - u_x / (1.5 * mu));
  const auto primitive = [&](double x) {
    const double first = d * x - x * x * x / 3;
    const double second = d * d * x - 2 * d * x * x * x / 3 + std::pow(x, 5) / 5;
    return 2 * 4 * mu * 4 * G * (u_x * first - 1.5 * mu * second);
  };
  EXPECT_NEAR(heat / (primitive(a) - primitive(c)), 1, 1e-5);  // partial springs at both edges, width^2
}

// Relaxation damping, Popov, Popov and Pohrt (2015): with unlimited friction a spring loses what it stores under
// traction when contact opens. Stuck at u_x = s, pulled to s + e, then lifted: 2 (8/3) G e^2/2 per length.
TEST(SpringEnergy, RelaxationDampingReleasesTheTangentialEnergy) {
  const PronyBody body = elastic(3);
  const SpringBed bed = flat_bed(10);
  const SpringStep step(body, 1e9, 1);
  SpringState state = relaxed_state(bed, body, 0.1);
  step.advance(state, bed, {0.1, 0, 0.01, 0});
  const SpringState loaded = state;
  step.advance(state, bed, {-0.1, 0, 0.01, 0});
  EXPECT_NEAR(dissipation({bed.width, bed.width}, body, 1e9, 1, loaded, state).friction, 8.0 / 3 * 3 * 0.01 * 0.01,
              1e-12);
  EXPECT_EQ(stored_energy(bed, body, state), 0);
}

}  // namespace
}  // namespace fretval::mdr::spring_energy_test
