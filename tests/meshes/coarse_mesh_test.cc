#include "meshes/coarse_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/meshes/expect_error.h"

namespace fretval::meshes::coarse_mesh_test {
namespace {

const double far_radius = 8;
const std::vector<double> surface_nodes{0, 0.5, 1, 2};

CoarseMesh mesh_of(double strip_height, double size = 2) {
  return coarse_mesh(surface_nodes, strip_height, {far_radius}, [size](double, double) { return size; });
}

double area(const CoarseMesh& mesh, const std::vector<unsigned>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = mesh.nodes[polygon[i]], &b = mesh.nodes[polygon[(i + 1) % polygon.size()]];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

/// Radii of the nodes of the surface, each once, from the axis outwards.
std::vector<double> surface_radii(const CoarseMesh& mesh) {
  std::set<double> radii;
  for (const auto& edge : mesh.edges)
    if (edge.side == Side::surface)
      for (const unsigned node : edge.nodes) radii.insert(mesh.nodes[node][0]);
  return {radii.begin(), radii.end()};
}

TEST(CoarseMeshTest, HasTheGivenSurfaceNodesAndNoneBetweenThem) {
  for (const double strip : {0.0, 0.25}) {
    const auto radii = surface_radii(mesh_of(strip));
    ASSERT_GT(radii.size(), surface_nodes.size() + 1);
    for (std::size_t i = 0; i < surface_nodes.size(); ++i) EXPECT_NEAR(radii[i], surface_nodes[i], 1e-11) << strip;
    EXPECT_NEAR(radii.back(), far_radius, 1e-11);
  }
}

TEST(CoarseMeshTest, SidesLieWhereTheirNamesSay) {
  for (const double strip : {0.0, 0.25}) {
    const CoarseMesh mesh = mesh_of(strip);
    std::map<Side, double> length;
    for (const auto& edge : mesh.edges) {
      for (const unsigned node : edge.nodes) {
        const auto& [r, z] = mesh.nodes[node];
        if (edge.side == Side::surface) {
          EXPECT_NEAR(z, 0, 1e-11);
        }
        if (edge.side == Side::axis) {
          EXPECT_NEAR(r, 0, 1e-11);
        }
        if (edge.side == Side::arc) {
          EXPECT_NEAR(std::hypot(r, z), far_radius, 1e-11);
        }
      }
      const auto &a = mesh.nodes[edge.nodes[0]], &b = mesh.nodes[edge.nodes[1]];
      length[edge.side] += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
    EXPECT_NEAR(length[Side::surface], far_radius, 1e-11) << strip;
    EXPECT_NEAR(length[Side::axis], far_radius, 1e-11) << strip;
    EXPECT_NEAR(length[Side::arc], std::acos(-1.) / 2 * far_radius, 0.1)
        << strip;  // chords are shorter by 2^2/(24 R^2)
  }
}

// Every edge is that of two polygons, or of one and of one side, and all polygons are counter-clockwise.
TEST(CoarseMeshTest, PolygonsFillTheDiscOnce) {
  for (const double strip : {0.0, 0.25}) {
    const CoarseMesh mesh = mesh_of(strip);
    std::map<std::pair<unsigned, unsigned>, int> count;
    for (const auto& polygon : mesh.polygons) {
      EXPECT_GT(area(mesh, polygon), 0);
      for (std::size_t i = 0; i < polygon.size(); ++i)
        ++count[std::minmax(polygon[i], polygon[(i + 1) % polygon.size()])];
    }
    for (const auto& edge : mesh.edges) ++count[std::minmax(edge.nodes[0], edge.nodes[1])];
    for (const auto& [ends, n] : count) EXPECT_EQ(n, 2) << strip << ": " << ends.first << " to " << ends.second;
  }
}

TEST(CoarseMeshTest, StripIsARectangleUnderEachInterval) {
  const double height = 0.25;
  const CoarseMesh mesh = mesh_of(height);
  int n_rectangles = 0;
  for (const auto& polygon : mesh.polygons) {
    const auto in_strip = [&](unsigned node) { return mesh.nodes[node][1] > -height - 1e-9; };
    const auto at_surface_node = [&](unsigned node) { return mesh.nodes[node][0] < surface_nodes.back() + 1e-9; };
    if (!std::all_of(polygon.begin(), polygon.end(), in_strip)) continue;
    if (!std::all_of(polygon.begin(), polygon.end(), at_surface_node)) continue;
    ASSERT_EQ(polygon.size(), 4U);
    const double width = mesh.nodes[polygon[1]][0] - mesh.nodes[polygon[0]][0];
    EXPECT_NEAR(area(mesh, polygon), width * height, 1e-11);
    ++n_rectangles;
  }
  EXPECT_EQ(n_rectangles, 3);
}

// Polygons of half the size are four times as many, but for those at the surface nodes.
TEST(CoarseMeshTest, SizeIsTheOneAskedFor) {
  const auto n = [](double size) { return static_cast<double>(mesh_of(0, size).polygons.size()); };
  EXPECT_NEAR(n(0.5) / n(1), 4, 1);
  EXPECT_NEAR(n(0.5), std::acos(-1.) / 4 * 64 / 0.25, 80);
}

TEST(CoarseMeshTest, FailureOfGmshIsAnErrorAndLeavesItUsable) {
  expect_error(
      [] {
        coarse_mesh({0, 1, 1}, 0, {far_radius}, [](double, double) { return 1.; });
      },
      {"mesh of the body: gmsh failed: "});
  EXPECT_FALSE(mesh_of(0).polygons.empty());
}

}  // namespace
}  // namespace fretval::meshes::coarse_mesh_test
