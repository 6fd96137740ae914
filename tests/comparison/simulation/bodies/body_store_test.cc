#include "comparison/simulation/bodies/body_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>

#include "comparison/support/parallel.h"
#include "fem/support/solver_error.h"
#include "meshes/grading.h"
#include "tests/comparison/small_body.h"

namespace fretval {
namespace {

TEST(BodyStore, MakesABodyOnceForManyThreads) {
  BodyStore store;
  std::atomic<int> n_made{0};
  std::vector<std::shared_ptr<const ContactBody>> bodies(8);
  for_each_in_parallel(
      bodies.size(),
      [&](std::size_t i) {
        bodies[i] = store.find_or_make(small_body(i % 2 == 0), [&] {
          ++n_made;
          std::this_thread::sleep_for(std::chrono::milliseconds(20));  // so that the others ask meanwhile
          return contact_body(make_body(small_body(i % 2 == 0)));
        });
      },
      bodies.size());
  EXPECT_EQ(n_made, 2);
  EXPECT_EQ((std::set<std::shared_ptr<const ContactBody>>(bodies.begin(), bodies.end()).size()), 2U);
  EXPECT_TRUE(bodies[0]->tangential);
  EXPECT_FALSE(bodies[1]->tangential);
}

/// Layer of half a contact radius or two, with rings of 1/16 or coarser.
BodyDescription layer_with(int n_rings, double thickness, double poisson_ratio) {
  BodyDescription layer{meshes::uniform_nodes(1.25, static_cast<unsigned>(n_rings)), 0.5, 1.25 + 8 * thickness, 3};
  layer.poisson_ratio = poisson_ratio;
  layer.thickness = thickness;
  return layer;
}

/// Force of a flat punch of so many rings.
double punch_force(const fem::Compliance& compliance, Eigen::Index n) {
  const Eigen::VectorXd areas = compliance.areas.head(n);
  return areas.dot(compliance.matrix->topLeftCorner(n, n).llt().solve(areas));
}

// What moved rings are told of is the same body: its force is that on a mesh of these rings, of which the force has
// changed by some percent, and nothing is made for it but the coarse body.
TEST(BodyStore, MovesTheRingsOfABody) {
  for (const auto& [thickness, poisson_ratio] : {std::pair(2.0, 0.5), {2.0, 0.3}, {0.6, 0.5}}) {
    const auto usual = layer_with(40, thickness, poisson_ratio), coarse = layer_with(20, thickness, poisson_ratio);
    auto moved = usual, own = usual;
    moved.moved = {1.03, coarse.contact_nodes, coarse.far_radius};
    for (double& node : own.contact_nodes) node *= moved.moved.factor;
    BodyStore bodies;
    for (const auto& known : {usual, coarse}) find_or_make_body(known, bodies);
    const int n_made = bodies.n_made;
    const auto body = find_or_make_body(moved, bodies), unmoved = find_or_make_body(usual, bodies);
    EXPECT_EQ(bodies.n_made, n_made);
    EXPECT_EQ(body->summary->original, unmoved->summary);
    const auto on_own_mesh = contact_body(make_body(own));
    const auto expect_force = [&](const fem::Compliance& of, const fem::Compliance& exact,
                                  const fem::Compliance& known) {
      constexpr Eigen::Index n = 32;
      const double force = punch_force(exact, n);
      EXPECT_NEAR(punch_force(of, n) / force, 1, 2e-6) << usual.thickness << " " << usual.poisson_ratio;
      EXPECT_GT(std::abs(1.03 * punch_force(known, n) / force - 1), 4e-3);
    };
    expect_force(body->normal.compliance, on_own_mesh.normal.compliance, unmoved->normal.compliance);
    expect_force(body->tangential->compliance, on_own_mesh.tangential->compliance, unmoved->tangential->compliance);
  }
}

TEST(BodyStore, ThrowsToWhoeverAsksForWhatCouldNotBeMade) {
  BodyStore store;
  int n_tried = 0;
  const auto ask = [&] {
    store.find_or_make(small_body(), [&]() -> ContactBody {
      ++n_tried;
      throw fem::SolverError("singular");
    });
  };
  EXPECT_THROW(ask(), fem::SolverError);
  EXPECT_THROW(ask(), fem::SolverError);
  EXPECT_EQ(n_tried, 1);
}

}  // namespace
}  // namespace fretval
