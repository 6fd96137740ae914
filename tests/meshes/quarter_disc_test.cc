#include "meshes/quarter_disc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "meshes/audit.h"
#include "meshes/body_mesh.h"
#include "meshes/grading.h"
#include "meshes/mesh_error.h"
#include "tests/meshes/expect_error.h"

namespace fretval::meshes::quarter_disc_test {
namespace {

const double pi = std::acos(-1.);

/// Area of the disc less the segments between the arc and the chords of the far edges.
double area_within_chords(const Mesh& mesh, double far_radius) {
  double area = pi * far_radius * far_radius / 4.;
  for (const auto& edge : mesh.edges) {
    if (edge.boundary != Boundary::far) continue;
    const auto& a = mesh.nodes[edge.nodes[0]];
    const auto& b = mesh.nodes[edge.nodes[1]];
    const double angle = 2. * std::asin(std::hypot(b[0] - a[0], b[1] - a[1]) / (2. * far_radius));
    area -= far_radius * far_radius / 2. * (angle - std::sin(angle));
  }
  return area;
}

/// The given contact nodes exactly, all lengths and the area to roundoff, cells fit for computing.
void expect_good(const Mesh& mesh, const QuarterDisc& disc, double min_scaled_jacobian) {
  const double R = disc.far_radius;
  const double contact_length = disc.contact_nodes.back();
  EXPECT_NO_THROW(audit(mesh, "quarter disc"));
  EXPECT_EQ(contact_radii(mesh), disc.contact_nodes);
  EXPECT_NEAR(boundary_length(mesh, Boundary::contact), contact_length, 1e-13 * R);
  EXPECT_NEAR(boundary_length(mesh, Boundary::axis), R, 1e-13 * R);
  EXPECT_NEAR(boundary_length(mesh, Boundary::free), R - contact_length, 1e-13 * R);
  const auto q = quality(mesh);
  EXPECT_NEAR(q.area, area_within_chords(mesh, R), 1e-12 * R * R);
  EXPECT_GT(q.min_scaled_jacobian, min_scaled_jacobian);
  EXPECT_GT(q.mean_scaled_jacobian, 0.85);
  EXPECT_LT(q.max_aspect_ratio, 10.);
}

TEST(QuarterDisc, OfAUniformContactLineIsGood) {
  for (const unsigned n : {1U, 2U, 3U, 24U, 51U, 128U}) {
    SCOPED_TRACE(n);
    const QuarterDisc disc{uniform_nodes(1.2, n), 30.};
    expect_good(quarter_disc(disc), disc, 0.3);
  }
}

TEST(QuarterDisc, OfAGradedContactLineIsGood) {
  for (const double ratio : {1e-1, 1e-3, 1e-5}) {
    SCOPED_TRACE(ratio);
    const QuarterDisc disc{graded_nodes({0.5, 0.5, 0.02 * ratio}, 1.2, 0.02, 0.15), 25.};
    expect_good(quarter_disc(disc), disc, 0.2);
  }
}

TEST(QuarterDiscSlow, OfRandomGradedContactLinesIsGood) {
  std::mt19937 random(1);
  const auto between = [&random](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const double coarse = std::pow(10., between(-2.6, -1.2));
    const double fine = coarse * std::pow(10., between(-5., 0.));
    const double edge = between(0.01, 0.99);
    const QuarterDisc disc{graded_nodes({edge, edge, fine}, 1., coarse, between(0.1, 0.25)), between(5., 30.)};
    expect_good(quarter_disc(disc), disc, 0.05);
  }
}

TEST(QuarterDiscSlow, OfManyElementsIsGood) {
  const QuarterDisc disc{uniform_nodes(1.2, 800), 30.};
  expect_good(quarter_disc(disc), disc, 0.3);
}

TEST(QuarterDisc, HasTheExpectedNumberOfCells) {
  const Mesh mesh = quarter_disc({uniform_nodes(1., 128), 25.});
  EXPECT_GT(mesh.cells.size(), 2000U);
  EXPECT_LT(mesh.cells.size(), 5000U);
}

// The polygon misses h^2/(12 R^2) of the area of the disc, h the size of the far edges.
TEST(QuarterDisc, TendsToTheDisc) {
  double previous = 1.;
  for (const double growth : {0.4, 0.2, 0.1}) {
    const double area = quality(quarter_disc({uniform_nodes(1., 8), 10., growth})).area;
    const double missing = 1. - area / (pi * 100. / 4.);
    EXPECT_GT(missing, 0.);
    EXPECT_LT(missing, 2. * growth * growth / 12.);
    EXPECT_LT(missing, previous / 2.);
    previous = missing;
  }
}

TEST(QuarterDisc, PutsFarNodesOnTheArc) {
  const Mesh mesh = quarter_disc({uniform_nodes(1., 16), 20.});
  for (const auto& edge : mesh.edges) {
    if (edge.boundary != Boundary::far) continue;
    for (const unsigned node : edge.nodes)
      EXPECT_NEAR(std::hypot(mesh.nodes[node][0], mesh.nodes[node][1]), 20., 1e-13);
  }
}

// Cells follow the size wanted in their middle, within the factor that merging triangles leaves.
TEST(QuarterDisc, HasTheWantedSizes) {
  const QuarterDisc disc{graded_nodes({0.5, 0.5, 1e-4}, 1., 0.02, 0.15), 25.};
  const Mesh mesh = quarter_disc(disc);
  double sum = 0.;
  for (const auto& cell : mesh.cells) {
    std::array<double, 2> middle{0., 0.};
    for (const unsigned node : cell)
      for (const int i : {0, 1}) middle[i] += mesh.nodes[node][i] / 4.;
    const double ratio =
        std::sqrt(signed_area(mesh, cell)) / element_size(disc.contact_nodes, disc.growth, middle[0], middle[1]);
    EXPECT_GT(ratio, 0.25);
    EXPECT_LT(ratio, 2.5);
    sum += ratio / mesh.cells.size();
  }
  EXPECT_NEAR(sum, 1., 0.2);
}

TEST(QuarterDisc, GrowthCoarsensTheMesh) {
  const auto fine = quarter_disc({uniform_nodes(1., 32), 25., 0.1}).cells.size();
  const auto coarse = quarter_disc({uniform_nodes(1., 32), 25., 0.2}).cells.size();
  EXPECT_GT(fine, 2 * coarse);
}

TEST(QuarterDisc, IsTheSameEveryTime) {
  const QuarterDisc disc{graded_nodes({0.5, 0.5, 1e-4}, 1., 0.02, 0.15), 25.};
  const Mesh first = quarter_disc(disc);
  const Mesh second = quarter_disc(disc);
  EXPECT_EQ(first.nodes, second.nodes);
  EXPECT_EQ(first.cells, second.cells);
}

TEST(QuarterDisc, ScalesWithTheUnitOfLength) {
  const Mesh metres = quarter_disc({uniform_nodes(1., 32), 25.});
  const double nano = std::pow(2., -30);
  const Mesh scaled = quarter_disc({uniform_nodes(nano, 32), 25. * nano});
  ASSERT_EQ(metres.cells, scaled.cells);
  for (std::size_t i = 0; i < metres.nodes.size(); ++i)
    for (const int k : {0, 1}) EXPECT_NEAR(scaled.nodes[i][k] / nano, metres.nodes[i][k], 1e-13);
}

TEST(QuarterDisc, RefusesBadInput) {
  expect_error([] { quarter_disc({{0.}, 25.}); }, {"1 contact nodes", "at least 2"});
  expect_error([] { quarter_disc({{0.1, 1.}, 25.}); }, {"contact node 0", "r = 0.1", "must be 0"});
  expect_error([] { quarter_disc({{0., 1., 1.}, 25.}); }, {"contact node 2", "r = 1", "larger than 1"});
  expect_error([] { quarter_disc({{0., std::nan("")}, 25.}); }, {"contact node 1", "nan"});
  expect_error([] { quarter_disc({{0., 1.}, 1.}); }, {"far radius is 1", "larger than the last contact node 1"});
  expect_error([] { quarter_disc({{0., 1.}, 25., 0.}); }, {"growth is 0", "between 0.02 and 1"});
}

TEST(QuarterDisc, TakesTheFinestGrowth) {
  const QuarterDisc disc{uniform_nodes(1., 4), 4., 0.02};
  expect_good(quarter_disc(disc), disc, 0.3);
}

// An odd number of elements: the last edge of the coarse mesh ends half-way to the arc.
TEST(QuarterDisc, MayEndHardlyBeyondItsContactLine) {
  const QuarterDisc disc{uniform_nodes(1., 15), 1.05, 0.3};
  expect_good(quarter_disc(disc), disc, 0.3);
}

// Elements of 1e-13 are beyond the tolerances of gmsh. Whatever happens, the next mesh must not suffer.
TEST(QuarterDisc, RecoversFromAFailureOfGmsh) {
  const QuarterDisc impossible{{0., 0.5, 0.5 + 1e-13, 0.5 + 2e-13, 0.5 + 3e-13, 0.6, 1.}, 25.};
  EXPECT_THROW(quarter_disc(impossible), MeshError);
  const QuarterDisc disc{uniform_nodes(1., 16), 25.};
  expect_good(quarter_disc(disc), disc, 0.3);
}

TEST(QuarterDisc, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  quarter_disc({uniform_nodes(1., 16), 25.});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace fretval::meshes::quarter_disc_test
