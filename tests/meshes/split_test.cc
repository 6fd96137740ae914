#include "meshes/split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace fretval::meshes::split_test {
namespace {

using Point = std::array<double, 2>;

/// A square with a triangle to its right, which share the edge from node 1 to node 2.
///
///     3 --- 2 - 4
///     |     | /
///     0 --- 1
CoarseMesh square_and_triangle() {
  return {{{0, -2}, {2, -2}, {2, 0}, {0, 0}, {5, 0}},
          {{0, 1, 2, 3}, {2, 1, 4}},
          {{{3, 0}, Side::axis}, {{3, 2}, Side::surface}, {{4, 1}, Side::arc}}};
}

double area(const SplitMesh& mesh, const std::array<unsigned, 4>& cell) {
  double twice = 0;
  for (int i = 0; i < 4; ++i) {
    const Point &a = mesh.nodes[cell[i]], &b = mesh.nodes[cell[(i + 1) % 4]];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

TEST(Split, MakesACounterClockwiseQuadrilateralAtEachCorner) {
  const SplitMesh mesh = split(square_and_triangle());
  ASSERT_EQ(mesh.cells.size(), 7U);
  for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(area(mesh, mesh.cells[i]), 1);  // quarters of the square
  for (int i = 4; i < 7; ++i) EXPECT_DOUBLE_EQ(area(mesh, mesh.cells[i]), 1);  // the medians share out an area of 3
  const unsigned corners[] = {0, 1, 2, 3, 2, 1, 4};
  for (int i = 0; i < 7; ++i) EXPECT_EQ(mesh.cells[i][0], corners[i]);
}

TEST(Split, AddsOneNodeToEachEdgeAndEachPolygonInThatOrder) {
  const CoarseMesh coarse = square_and_triangle();
  const SplitMesh mesh = split(coarse);
  ASSERT_EQ(mesh.nodes.size(), 5U + 6U + 2U);
  EXPECT_TRUE(std::equal(coarse.nodes.begin(), coarse.nodes.end(), mesh.nodes.begin()));
  const std::set<Point> middles(mesh.nodes.begin() + 5, mesh.nodes.begin() + 11);
  EXPECT_EQ(middles, (std::set<Point>{{1, -2}, {2, -1}, {1, 0}, {0, -1}, {3.5, -1}, {3.5, 0}}));
  EXPECT_EQ(mesh.nodes[11], (Point{1, -1}));
  EXPECT_EQ(mesh.nodes[12], (Point{3, -2.0 / 3}));
  for (int i = 0; i < 7; ++i) EXPECT_EQ(mesh.cells[i][2], i < 4 ? 11U : 12U);
}

TEST(Split, HalvesEdgesOnTheirSide) {
  const SplitMesh mesh = split(square_and_triangle());
  ASSERT_EQ(mesh.edges.size(), 6U);
  const Side sides[] = {Side::axis, Side::axis, Side::surface, Side::surface, Side::arc, Side::arc};
  const Point points[][2] = {{{0, 0}, {0, -1}}, {{0, -1}, {0, -2}},  {{0, 0}, {1, 0}},
                             {{1, 0}, {2, 0}},  {{5, 0}, {3.5, -1}}, {{3.5, -1}, {2, -2}}};
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(mesh.edges[i].side, sides[i]) << i;
    for (int end = 0; end < 2; ++end) EXPECT_EQ(mesh.nodes[mesh.edges[i].nodes[end]], points[i][end]) << i;
  }
}

}  // namespace
}  // namespace fretval::meshes::split_test
