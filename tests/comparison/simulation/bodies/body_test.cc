#include "comparison/simulation/bodies/body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshes/mesh_error.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/small_body.h"

namespace fretval {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Mean displacement of the whole contact line under a uniform load.
double mean_displacement(const fem::Compliance& compliance) {
  return compliance.matrix->sum() / compliance.areas.sum();
}

// Johnson, Contact Mechanics, 3.4: under a uniform pressure p on a circle of radius a of an incompressible half-space
// the mean displacement is 4 p a/(3 pi G).
TEST(Body, GivesWayToAPressureLikeAHalfSpace) {
  const auto body = contact_body(make_body(small_body()));
  EXPECT_NEAR(mean_displacement(body.normal.compliance), 4 / (3 * pi), 2e-2);  // four rings
  EXPECT_EQ(body.summary->radii, small_body().contact_nodes);
}

// A half-space has no length: what is scaled is what a larger mesh leads to, to roundoff.
TEST(Body, IsScaledLikeItsMesh) {
  auto larger = small_body();
  larger.scale = 1.3;
  const auto made = contact_body(make_body(larger)), from_smaller = scaled(contact_body(make_body(small_body())), 1.3);
  const auto expect_equal = [](const fem::Compliance& a, const fem::Compliance& b) {
    EXPECT_LT((*a.matrix - *b.matrix).norm(), 1e-9 * a.matrix->norm());
    EXPECT_LT((a.areas - b.areas).norm(), 1e-12 * a.areas.norm());
    EXPECT_NEAR(a.radii.back(), b.radii.back(), 1e-12);
  };
  expect_equal(made.normal.compliance, from_smaller.normal.compliance);
  expect_equal(made.tangential->compliance, from_smaller.tangential->compliance);
  EXPECT_EQ(count_of({from_smaller.summary, from_smaller.summary->original}).all, 1);
}

TEST(Body, HasATangentialHarmonicOnlyForTangentialMotion) {
  const auto both = make_body(small_body(true)), normal = make_body(small_body(false));
  EXPECT_FALSE(normal.tangential);
  EXPECT_EQ(normal.n_dofs(), normal.normal.space.n_dofs());
  EXPECT_GT(both.n_dofs(), 2 * normal.n_dofs());
  EXPECT_EQ(*normal.normal.contact.compliance.matrix, *both.normal.contact.compliance.matrix);
}

TEST(Body, HasSoManyDofsBeforeItIsMade) {
  for (const bool tangential : {false, true})
    for (const unsigned degree : {2U, 3U, 4U}) {
      auto specification = small_body(tangential);
      specification.degree = degree;
      EXPECT_EQ(n_dofs_on(mesh_of(specification), degree, tangential), make_body(specification).n_dofs());
    }
}

TEST(Body, HasOneCopyOfEachMatrix) {
  const auto whole = make_body(small_body());
  const auto body = contact_body(whole);
  EXPECT_EQ(&*body.normal.compliance.matrix, &*whole.normal.contact.compliance.matrix);
  EXPECT_EQ(&*body.normal.solver.factor(), &*whole.normal.contact.solver.factor());
}

TEST(Body, NamesTheMeshThatItCannotTrust) {
  auto mesh = mesh_of(small_body());
  std::swap(mesh.cells[0][0], mesh.cells[0][2]);
  std::swap(mesh.cells[0][0], mesh.cells[0][1]);
  try {
    assemble_operators(mesh, "broken.msh", small_body());
    FAIL();
  } catch (const meshes::MeshError& error) {
    expect_parts(error.what(), {"broken.msh: ", "cell 0"});
  }
}

}  // namespace
}  // namespace fretval
