#include "comparison/accuracy/computations.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

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
