#include "comparison/accuracy/computations.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "comparison/support/stopwatch.h"
#include "fem/support/solver_error.h"
#include "meshes/mesh_error.h"
#include "tests/comparison/fake_numerics.h"
#include "tests/comparison/suite_case.h"

namespace fretval {
namespace {

TEST(Computations, AreMadeOnceForAResolution) {
  const auto prepared = prepare({suite_case("parabola-elastic-90", 1e-3)}).front();
  const auto coarse = prepared.fem.resolution, fine = with_rings(coarse, 2), finer = with_rings(coarse, 4);
  std::atomic<int> n{0};
  Computations computed(
      prepared.fem.units,
      [&](const Resolution& r) {
        ++n;
        return FakeNumerics{100, 0}(prepared.fem, r);
      },
      2);
  computed.compute({coarse, fine, coarse});
  computed.compute({fine, finer});
  EXPECT_EQ(n, 3);
  EXPECT_EQ(computed.size(), 3);
  EXPECT_EQ(computed.quantities().at(fine).at(Quantity::contact_radius_max), 1);
  EXPECT_GT(computed.quantities().at(coarse).at(Quantity::stick_radius_shakedown),
            computed.quantities().at(finer).at(Quantity::stick_radius_shakedown));
}

// 10 cycles of steps each, see FakeNumerics; every one has a body of its own there.
TEST(Computations, AddUpWhatAllOfThemCost) {
  const auto prepared = prepare({suite_case("parabola-elastic-90", 1e-3)}).front();
  const auto coarse = with_steps(resolution_for(1e-3), 1), fine = with_steps(coarse, 2);
  std::vector<std::pair<int, int>> told;
  Computations computed(
      prepared.fem.units,
      [&](const Resolution& r) {
        const double start = processor_seconds();
        while (processor_seconds() < start + 0.01) {
        }
        auto answer = FakeNumerics{100, 0}(prepared.fem, r);
        answer.n_cycles = 7;
        return answer;
      },
      1, [&](int n_done, int n_known) { told.emplace_back(n_done, n_known); });
  computed.compute({coarse});
  computed.compute({coarse, fine, with_rings(fine, 2)});
  const auto cost = computed.cost() + ProofCost{1, 10, 2, 0.5, {2, 1}};
  EXPECT_EQ(cost.computations, 4);
  EXPECT_EQ(cost.time_steps, 10L * (coarse.steps_per_cycle + 2L * fine.steps_per_cycle) + 10);
  EXPECT_EQ(cost.cycles, 23);
  EXPECT_GE(cost.seconds, 0.53);
  EXPECT_LT(cost.seconds, 5);
  EXPECT_EQ(cost.bodies.all, 5);
  EXPECT_EQ(cost.bodies.from_store, 1);
  EXPECT_EQ(told, (std::vector<std::pair<int, int>>{{1, 1}, {2, 3}, {3, 3}}));
}

TEST(Computations, KeepFailuresOfTheNumericsAndThrowAnythingElse) {
  const auto resolution = resolution_for(1e-3);
  const auto failing = [](auto error) {
    return Computations(
        {1, 1, 1, 1}, [=](const Resolution&) -> FeAnswer { throw error; }, 1);
  };
  Computations singular = failing(fem::SolverError("singular")), flat = failing(meshes::MeshError("flat")),
               mistaken = failing(std::logic_error("a mistake"));
  singular.compute({resolution});
  EXPECT_TRUE(singular.failed(resolution));
  EXPECT_EQ(singular.at(resolution).failure, "singular");
  EXPECT_TRUE(singular.quantities().at(resolution).empty());
  flat.compute({resolution});
  EXPECT_EQ(flat.at(resolution).failure, "flat");
  EXPECT_THROW(mistaken.compute({resolution}), std::logic_error);
}

}  // namespace
}  // namespace fretval
