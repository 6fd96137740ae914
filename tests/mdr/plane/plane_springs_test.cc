#include "mdr/plane/plane_springs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/profiles/power_law.h"

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

TEST(PlaneSprings, LoseInTheBodyWhatFrictionDoesNot) {
  const auto response = plane_response(parabola(R), prony(G, {G}, {0.2}, 0), mu, ellipse(2e-5, 1e-5, 0.3, 720), 200);
  EXPECT_GT(response.tangential_work + response.normal_work, response.friction_work);
}

TEST(PlaneSprings, RefuseNoFriction) {
  EXPECT_THROW(plane_response(parabola(R), elastic, 0, ellipse(1e-5, 0, 0, 8), 10), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::plane_springs_test
