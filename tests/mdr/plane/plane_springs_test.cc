#include "mdr/plane/plane_springs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mdr/motion/force_control.h"
#include "mdr/profiles/power_law.h"
#include "mdr/springs/spring_step.h"

namespace fretval::mdr::plane_springs_test {
namespace {

constexpr double pi = 3.14159265358979323846, mu = 0.5, G = 1e6, R = 1e-2, d = 1e-4;
const PronyBody elastic = prony(G, {}, {}, 0);

/// An ellipse of half axes a, b, turned by an angle.
PlaneMotion ellipse(double a, double b, double turned, int n) {
  PlaneMotion motion{{d, 0, 0}, {}, {}, true};
  for (int k = 0; k <= n; ++k) {
    const double t = 2 * pi * k / n, along = a * std::cos(t), across = b * std::sin(t);
    motion.time.push_back(t);
    motion.positions.push_back({d, along * std::cos(turned) - across * std::sin(turned),
                                along * std::sin(turned) + across * std::cos(turned)});
  }
  return motion;
}

// Mindlin and Deresiewicz: energy of friction in a cycle of an elastic sphere under a constant force (Johnson, Contact
// Mechanics, 7.61 in terms of the displacement): per spring 4 (8/3) G s (u - s) with s = 3 mu (d - g)/2.
TEST(PlaneSprings, OfOneDirectionLoseMindlinsEnergy) {
  const double u = 3e-5, depth = 2 * u / (3 * mu), c = std::sqrt(R * (d - depth)), a = std::sqrt(R * d);
  double energy = 0, force = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double x = (i + 0.5) * a / n, most = 1.5 * mu * (d - x * x / R);
    if (x > c) energy += 2 * a / n * 8.0 / 3 * G * 4 * most * (u - most);
    force += 2 * a / n * 8.0 / 3 * G * std::min(u, most);
  }
  const auto response = plane_response(parabola(R), elastic, mu, ellipse(u, 0, 0, 720), 400);
  EXPECT_NEAR(response.friction_work / energy, 1, 2e-4);
  EXPECT_NEAR(response.tangential_work / energy, 1, 2e-4);
  EXPECT_NEAR(response.force_x_max / force, 1, 1e-4);
  EXPECT_EQ(response.force_y_max, 0);
}

// Of first order in the step where slip turns: a circle whose springs beyond the stick radius slip all the time.
TEST(PlaneSprings, OfACircleConvergeAndKnowNoDirection) {
  const auto energy = [](double turned, int n) {
    return plane_response(parabola(R), elastic, mu, ellipse(3e-5, 3e-5, turned, n), 200).friction_work;
  };
  const double coarse = energy(0, 360), medium = energy(0, 720), fine = energy(0, 1440);
  EXPECT_NEAR((coarse - medium) / (medium - fine), 2, 0.3);
  EXPECT_NEAR(energy(0.7, 720) / medium, 1, 1e-3);
}

// A spring that slips round a circle lags behind it by an angle whose cosine is its limit over the radius, so that it
// loses 2 pi l sqrt(u^2 - l^2) per cycle.
TEST(PlaneSprings, OfACircleLoseWhatTheirLagSays) {
  const double u = 3e-5, a = std::sqrt(R * d);
  double energy = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double x = (i + 0.5) * a / n, most = 1.5 * mu * (d - x * x / R);
    if (most < u) energy += 2 * a / n * 8.0 / 3 * G * 2 * pi * most * std::sqrt(u * u - most * most);
  }
  const auto by_steps = [&](int steps) {
    return plane_response(parabola(R), elastic, mu, ellipse(u, u, 0, steps), 400).friction_work;
  };
  EXPECT_NEAR((2 * by_steps(1440) - by_steps(720)) / energy, 1, 2e-3);
}

/// Straight from the rest at the first position through the others, at instants of their own, in n steps each.
PlaneMotion pass(const std::vector<PlanePosition>& positions, const std::vector<double>& times, int n) {
  PlaneMotion motion{positions.front(), {0}, {positions.front()}, false};
  for (std::size_t piece = 0; piece + 1 < positions.size(); ++piece)
    for (int j = 1; j <= n; ++j) {
      const auto &from = positions[piece], &to = positions[piece + 1];
      const double share = static_cast<double>(j) / n;
      motion.time.push_back(times[piece] + share * (times[piece + 1] - times[piece]));
      motion.positions.push_back({from.depth + share * (to.depth - from.depth), from.x + share * (to.x - from.x),
                                  from.y + share * (to.y - from.y)});
    }
  return motion;
}

// Hertz: F_N = 16/3 G sqrt(R) d^(3/2), so that pressing from d/2 to d takes 32/15 G sqrt(R) (d^(5/2) - (d/2)^(5/2)).
TEST(PlaneSprings, TakeTheWorkOfPressingThemIn) {
  const auto response = plane_response(parabola(R), elastic, mu, pass({{d / 2, 0, 0}, {d, 0, 0}}, {0, 1}, 100), 400);
  const double work = 32.0 / 15 * G * std::sqrt(R) * (std::pow(d, 2.5) - std::pow(d / 2, 2.5));
  EXPECT_NEAR(response.normal_work / work, 1, 3e-4);
}

// Mindlin's force of a push, F_x = mu F_N (1 - (1 - u/s)^(3/2)) with s = 3 mu d/2, rising for a second and held for
// nine, in as many steps.
TEST(PlaneSprings, HaveTheMeanForceOverTime) {
  const double u = 3e-5, s = 1.5 * mu * d, most = mu * 16.0 / 3 * G * std::sqrt(R) * std::pow(d, 1.5),
               rising = most * (1 - 0.4 * s / u * (1 - std::pow(1 - u / s, 2.5))),
               held = most * (1 - std::pow(1 - u / s, 1.5));
  const auto response =
      plane_response(parabola(R), elastic, mu, pass({{d, 0, 0}, {d, u, 0}, {d, u, 0}}, {0, 1, 10}, 200), 400);
  EXPECT_NEAR(response.force_x_mean / ((rising + 9 * held) / 10), 1, 1e-3);
}

// All sticks under a large coefficient of friction: F_x = 16/3 a (G u + eta du/dt).
TEST(PlaneSprings, LoseInADashpotWhatItsRateSays) {
  const double u = 1e-6, eta = 0.3 * G, a = std::sqrt(R * d), duration = 3;  // s
  auto motion = ellipse(u, 0, 0, 720);
  for (double& t : motion.time) t *= duration / (2 * pi);
  const double omega = 2 * pi / duration, work = pi * 16.0 / 3 * a * eta * omega * u * u;
  const auto response = plane_response(parabola(R), prony(G, {}, {}, eta), 100, motion, 400);
  EXPECT_NEAR(response.tangential_work / work, 1, 2e-3);
  EXPECT_NEAR(response.force_x_max / (16.0 / 3 * a * u * std::hypot(G, eta * omega)), 1, 2e-3);
}

// A depth that rises and falls twice in a cycle, fastest where the indenter is: an elastic body keeps nothing.
TEST(PlaneSprings, LoseByFrictionWhatMovesAnElasticBody) {
  auto motion = ellipse(6e-5, 2e-5, 0.4, 180);
  for (std::size_t k = 0; k < motion.positions.size(); ++k)
    motion.positions[k].depth = d * (1 + 0.5 * std::sin(2 * motion.time[k] + 0.5));
  const auto response = plane_response(parabola(R), elastic, mu, motion, 200);
  EXPECT_NEAR(response.friction_work / response.tangential_work, 1, 1e-4);
}

TEST(PlaneSprings, DependOnTheWayFromRestAlone) {
  const auto there = ellipse(3e-5, 2e-5, 0.3, 360);
  auto elsewhere = there;
  elsewhere.rest.x += 1e-4;
  elsewhere.rest.y -= 2e-4;
  for (auto& position : elsewhere.positions) position.x += 1e-4, position.y -= 2e-4;
  const auto one = plane_response(parabola(R), elastic, mu, there, 200),
             other = plane_response(parabola(R), elastic, mu, elsewhere, 200);
  for (const auto value : {&PlaneResponse::force_x_max, &PlaneResponse::force_y_max, &PlaneResponse::friction_work,
                           &PlaneResponse::tangential_work, &PlaneResponse::way, &PlaneResponse::x_amplitude})
    EXPECT_NEAR(other.*value / one.*value, 1, 1e-9);
  EXPECT_NEAR(one.x_amplitude, std::hypot(3e-5 * std::cos(0.3), 2e-5 * std::sin(0.3)), 1e-8);
}

TEST(PlaneSprings, LoseInTheBodyWhatFrictionDoesNot) {
  const auto response = plane_response(parabola(R), prony(G, {G}, {0.2}, 0), mu, ellipse(2e-5, 1e-5, 0.3, 720), 200);
  EXPECT_GT(response.tangential_work + response.normal_work, response.friction_work);
}

TEST(PlaneSprings, HaveForcesAndWorksOfAPath) {
  auto motion = ellipse(2e-5, 1e-5, 0.3, 720);
  const PlaneResponse response{5, 4, 3, 2, 6, 1, 0.5, 1e-5, {0.1, 0.2}};
  const auto forces = forces_of(response, prony(G, {G}, {0.2}, 0), motion);
  EXPECT_EQ(forces.tangential_force_max, 5);
  EXPECT_EQ(forces.tangential_force_mean, 3);
  EXPECT_EQ(forces.bulk_work, 5);
  EXPECT_EQ(forces.largest_indentation, d);
  EXPECT_EQ(forces_of(response, elastic, motion).bulk_work, 0);
  motion.repeats = false;
  EXPECT_EQ(forces_of(response, elastic, motion).tangential_work, 0);
}

// Element depths of a circle: d0 - 2 u/(3 mu), at its first step on the circle and ever after.
TEST(PlaneSprings, KnowWhereElementsStick) {
  const double u = 3e-5;
  const auto response = plane_response(parabola(R), elastic, mu, ellipse(u, u, 0, 720), 200);
  EXPECT_NEAR(response.depths.shakedown, d - 2 * u / (3 * mu), 1e-4 * d);
  EXPECT_NEAR(response.depths.first_slip, d - 2 * u / (3 * mu), 1e-4 * d);
  EXPECT_NEAR(response.way, 2 * pi * u, 1e-3 * u);
  EXPECT_NEAR(response.x_amplitude, u, 1e-12);
}

/// F_x and F_y that go round an ellipse.
PlaneMotion by_force(PlaneMotion motion) {
  motion.by_force = true;
  return motion;
}

// The force that the displacement of a circle leads to leads to that displacement.
TEST(PlaneSprings, FollowForcesAround) {
  const double u = 3e-5;
  const auto displaced = plane_response(parabola(R), elastic, mu, ellipse(u, u, 0, 720), 200);
  const double force = displaced.force_x_max;
  const auto forced = plane_response(parabola(R), elastic, mu, by_force(ellipse(force, force, 0, 720)), 200);
  EXPECT_NEAR(forced.force_x_max / force, 1, 1e-9);
  EXPECT_NEAR(forced.force_y_max / force, 1, 1e-9);
  EXPECT_NEAR(forced.x_amplitude / u, 1, 1e-3);
  EXPECT_NEAR(forced.friction_work / displaced.friction_work, 1, 5e-3);
  EXPECT_NEAR(forced.depths.shakedown, displaced.depths.shakedown, 1e-3 * d);
}

// Along a line: Cattaneo and Mindlin, u_x = (3 mu/2)(d(F) - d(F - F_x/mu)).
TEST(PlaneSprings, FollowAForceAlongALine) {
  const double normal = 16.0 / 3 * G * std::sqrt(R * d) * d, force = 0.7 * mu * normal,
               u = tangential_displacement_for_force(parabola(R), G, mu, normal, force);
  const auto response = plane_response(parabola(R), elastic, mu, by_force(ellipse(force, 0, 0.6, 360)), 400);
  EXPECT_NEAR(response.way / 4, u, 1e-3 * u);
  EXPECT_NEAR(response.x_amplitude, u * std::cos(0.6), 1e-3 * u);
}

TEST(PlaneSprings, SlideWhereFrictionDoesNotBearTheForce) {
  const double most = mu * 16.0 / 3 * G * std::sqrt(R * d) * d;
  EXPECT_NO_THROW(plane_response(parabola(R), elastic, mu, by_force(ellipse(0.97 * most, 0.97 * most, 0, 90)), 100));
  try {
    plane_response(parabola(R), elastic, mu, by_force(ellipse(1.25 * most, 0, 0, 90)), 100);
    FAIL() << "it slides";
  } catch (const GrossSlip& slip) {
    const double force = 1.25 * slip.amplitude * std::abs(std::cos(slip.time));
    EXPECT_GE(force, 1 - 1e-3);
    EXPECT_LT(force, 1.1) << "in a step before it was borne";
    EXPECT_GT(slip.excess, 0);
  }
}

TEST(PlaneSprings, RefuseNoFriction) {
  EXPECT_THROW(plane_response(parabola(R), elastic, 0, ellipse(1e-5, 0, 0, 8), 10), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::plane_springs_test
