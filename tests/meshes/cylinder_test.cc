#include "meshes/cylinder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshes/audit.h"
#include "meshes/grading.h"
#include "meshes/quality.h"
#include "tests/meshes/expect_error.h"

namespace fretval::meshes::cylinder_test {
namespace {

/// The given contact nodes and all lengths exactly, the area to roundoff, cells fit for computing.
void expect_good(const Cylinder& body) {
  const Mesh mesh = cylinder(body);
  const double H = body.thickness, R = body.radius, contact_length = body.contact_nodes.back();
  EXPECT_NO_THROW(audit(mesh, "cylinder"));
  EXPECT_EQ(contact_radii(mesh), body.contact_nodes);
  EXPECT_NEAR(boundary_length(mesh, Boundary::axis), H, 1e-13 * H);
  EXPECT_NEAR(boundary_length(mesh, Boundary::base), R, 1e-13 * R);
  EXPECT_NEAR(boundary_length(mesh, Boundary::free), R - contact_length + H, 1e-13 * (R + H));
  EXPECT_EQ(boundary_length(mesh, Boundary::far), 0);
  const auto q = quality(mesh);
  EXPECT_NEAR(q.area, R * H, 1e-12 * R * H);
  EXPECT_GT(q.min_scaled_jacobian, 0.25);
  EXPECT_GT(q.mean_scaled_jacobian, 0.8);
}

TEST(Cylinder, OfAnyThicknessIsGood) {
  for (const double thickness : {0.1, 0.3, 1., 3., 30., 1000.}) {
    SCOPED_TRACE(thickness);
    expect_good({uniform_nodes(1.2, 38), thickness, 1.2 + 12 * thickness, 0.3});
  }
}

TEST(Cylinder, OfAGradedContactLineIsGood) {
  expect_good({graded_nodes({0.5, 0.5, 1e-4}, 1.2, 0.03, 0.3), 0.5, 5, 0.3});
}

TEST(Cylinder, MayEndHardlyBeyondItsContactLine) {
  expect_good({uniform_nodes(1., 15), 1, 1.05, 0.3});
  expect_good({uniform_nodes(1., 16), 2, 1.3, 0.3});
}

// Bottom corners of the base belong to the base, the top one of the side to the free surface.
TEST(Cylinder, StandsOnItsBase) {
  const Mesh mesh = cylinder({uniform_nodes(1., 16), 0.7, 3.});
  for (const auto& edge : mesh.edges) {
    if (edge.boundary != Boundary::base) continue;
    for (const unsigned node : edge.nodes) EXPECT_EQ(mesh.nodes[node][1], -0.7);
  }
}

TEST(Cylinder, RefusesBadInput) {
  expect_error(
      [] {
        cylinder({{0., 1.}, 1., 0.9});
      },
      {"cylinder: radius is 0.9", "larger than the last contact node 1"});
  expect_error([] { cylinder({{0., 1.}, 0., 2.}); }, {"cylinder: thickness is 0", "positive"});
  expect_error([] { cylinder({{0., 1.}, std::nan(""), 2.}); }, {"thickness is nan", "positive"});
}

}  // namespace
}  // namespace fretval::meshes::cylinder_test
