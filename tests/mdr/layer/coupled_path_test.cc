#include "mdr/layer/coupled_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/layer/coupled_response.h"
#include "mdr/layer/layer_contact.h"
#include "mdr/layer/layer_slip.h"
#include "mdr/springs/force_balance.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::coupled_path_test {
namespace {

const double mu = 0.5;
const PronyBody solid{1, {1}, {0.1}, 0};
const PathFineness coarse{60, 90, 8, 1e-7};

TEST(CoupledPath, OfAThickLayerIsThatOfTheHalfSpace) {
  const SampledPath displaced{{0, 0.4, 1, 1.2, 2}, {1, 1.1, 0.9, 1, 1}, {0, 0.1, -0.12, 0.05, 0}, true};
  SampledPath forced{{0, 1, 2}, {4, 6, 5}, {0, 0.8, -0.3}, false};
  forced.normal_force = forced.tangential_force = true;
  for (const auto& path : {displaced, forced}) {
    const auto layered = coupled_path_forces(parabola(1), {1e6, 0.5}, solid, mu, path, coarse),
               half_space = path_forces(parabola(1), solid, mu, path, coarse);
    for (const auto part : {&PathForces::normal_force_max, &PathForces::tangential_force_max,
                            &PathForces::friction_work, &PathForces::bulk_work, &PathForces::largest_indentation,
                            &PathForces::tangential_amplitude, &PathForces::first_slip, &PathForces::shakedown})
      EXPECT_NEAR(layered.forces.*part, half_space.forces.*part,
                  2e-5 * std::abs(half_space.forces.*part) + 2 * (layered.error.*part + half_space.error.*part));
    EXPECT_GT(half_space.forces.friction_work, 10 * half_space.error.friction_work);
  }
}

// A push at a depth, once as a path, once as partial slip of the layer.
TEST(CoupledPath, IsThePushOfAnElasticLayer) {
  for (const Layer& layer : {Layer{1, 0.5}, Layer{0.5, 0.3}}) {
    const auto contact = layer_contact(parabola(1), layer, 1);
    const auto push = layer_push_to_radius(contact, mu, 1, 0.6);
    const SampledPath path{
        {0, 1}, {contact.indentation, contact.indentation}, {0, push.tangential_displacement}, false};
    const auto [forces, error, course] = coupled_path_forces(parabola(1), layer, {1, {}, {}, 0}, mu, path, coarse);
    EXPECT_NEAR(forces.normal_force_max / normal_force(contact, 1), 1, 1e-4);
    EXPECT_NEAR(forces.tangential_force_max / push.tangential_force, 1, 1e-3);
    EXPECT_NEAR(std::sqrt(course.history.depths.first_slip / transform(parabola(1), 1)), 0.6, 5e-3);
  }
}

// Many rows on cosines against the springs of the oscillation; rows cut the crests of the cosines.
TEST(CoupledPath, OfSampledCosinesIsThatOfTheOscillation) {
  constexpr int n = 90;
  const Layer layer{1, 0.45};
  SampledPath path{{}, {}, {}, true};
  for (int k = 0; k <= n; ++k) {
    const double t = 2 * pi * (k % n) / n;
    path.time.push_back(static_cast<double>(k) / n);
    path.normal.push_back(1 + 0.2 * std::cos(t));
    path.tangential.push_back(0.15 * std::cos(t + 0.8));
  }
  const auto sampled = coupled_path_forces(parabola(1), layer, solid, mu, path, coarse).forces;
  const auto exact = coupled_response(parabola(1), layer, solid, mu,
                                      {{1, {{0.2, 1, 0}}, {{0.15, 1, 0.8}}}, false, false}, {60, 90, 8, 1e-7})
                         .response;
  const double rows = 4 * std::pow(2 * pi / n, 2) / 12;
  EXPECT_NEAR(sampled.normal_force_max / exact.normal.normal_force_max, 1, rows);
  EXPECT_NEAR(sampled.tangential_force_max / exact.tangential_force_max, 1, rows);
  EXPECT_NEAR(sampled.first_slip, exact.depths.first_slip, rows);
  EXPECT_NEAR(sampled.bulk_work / exact.bulk_work, 1, 4 * rows);
}

TEST(CoupledPath, SaysWhenTheWholeContactSlides) {
  SampledPath pull{{0, 1}, {3, 3}, {0, 2}, false};
  pull.normal_force = pull.tangential_force = true;
  EXPECT_THROW(coupled_path_forces(parabola(1), {1, 0.5}, solid, mu, pull, coarse), GrossSlip);
}

}  // namespace
}  // namespace fretval::mdr::coupled_path_test
