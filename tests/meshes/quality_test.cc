#include "meshes/quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/meshes/block.h"

namespace fretval::meshes::quality_test {
namespace {

TEST(Quality, OfSquaresIsPerfect) {
  const auto q = quality(block());
  EXPECT_EQ(q.n_cells, 4U);
  EXPECT_EQ(q.n_nodes, 9U);
  EXPECT_DOUBLE_EQ(q.min_scaled_jacobian, 1.);
  EXPECT_DOUBLE_EQ(q.mean_scaled_jacobian, 1.);
  EXPECT_DOUBLE_EQ(q.max_aspect_ratio, 1.);
  EXPECT_DOUBLE_EQ(q.area, 4.);
  EXPECT_DOUBLE_EQ(q.smallest_edge, 1.);
  EXPECT_DOUBLE_EQ(q.largest_edge, 1.);
}

TEST(Quality, FollowsAMovedNode) {
  Mesh mesh = block();
  mesh.nodes[4] = {1.5, -1.};
  const auto q = quality(mesh);
  // The smallest angle is atan 2, at nodes 1 and 7.
  EXPECT_DOUBLE_EQ(q.min_scaled_jacobian, std::sin(std::atan(2.)));
  EXPECT_DOUBLE_EQ(q.max_aspect_ratio, std::hypot(1., 0.5) / 0.5);
  EXPECT_DOUBLE_EQ(q.area, 4.);
  EXPECT_DOUBLE_EQ(q.smallest_edge, 0.5);
  EXPECT_DOUBLE_EQ(q.largest_edge, 1.5);
}

TEST(ScaledJacobian, TellsBadCells) {
  const Mesh mesh = block();
  EXPECT_DOUBLE_EQ(scaled_jacobian(mesh, {0, 1, 4, 3}), 1.);
  EXPECT_DOUBLE_EQ(scaled_jacobian(mesh, {0, 3, 4, 1}), -1.);
  EXPECT_LT(scaled_jacobian(mesh, {0, 1, 3, 4}), 0.);
  EXPECT_DOUBLE_EQ(scaled_jacobian(mesh, {0, 1, 2, 4}), 0.);
  EXPECT_TRUE(std::isnan(scaled_jacobian(mesh, {0, 1, 1, 3})));
}

TEST(SignedArea, HasTheSignOfTheSense) {
  const Mesh mesh = block();
  EXPECT_DOUBLE_EQ(signed_area(mesh, {0, 2, 8, 6}), 4.);
  EXPECT_DOUBLE_EQ(signed_area(mesh, {0, 6, 8, 2}), -4.);
}

TEST(BoundaryLength, AddsUpTheEdgesOfOnePart) {
  const Mesh mesh = block();
  EXPECT_DOUBLE_EQ(boundary_length(mesh, Boundary::axis), 2.);
  EXPECT_DOUBLE_EQ(boundary_length(mesh, Boundary::contact), 1.);
  EXPECT_DOUBLE_EQ(boundary_length(mesh, Boundary::far), 4.);
  EXPECT_EQ(contact_radii(mesh), (std::vector<double>{0., 1.}));
}

}  // namespace
}  // namespace fretval::meshes::quality_test
