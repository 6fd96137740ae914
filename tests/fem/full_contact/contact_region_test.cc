#include "fem/full_contact/contact_region.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/ring_contact/static_contact.h"
#include "tests/fem/full_contact/bodies.h"

namespace fretval::fem::contact_region_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using full_contact_test::surface_half_space;

const ContactProblem& rings() {
  static const ContactProblem problem(ring_compliance(surface_half_space(0.5, 16), axisymmetric));
  return problem;
}

// Depths that fall in proportion to the distance from an edge, as those of a parabola next to it.
TEST(ContactRegion, ReadsTheEdgeOnEveryRay) {
  for (const auto mirrors : {Mirrors::none, Mirrors::x, Mirrors::x_and_y}) {
    const auto grid = angular_grid(16, mirrors);
    const VectorXd& radii = rings().series.radii();
    MatrixXd depths = MatrixXd::Zero(radii.size(), grid.n_kept());
    Eigen::VectorXi n_inside(grid.n_kept());
    for (Index j = 0; j < grid.n_kept(); ++j) {
      const double edge = 0.6 + 0.1 * std::cos(2 * grid.angles[j]);
      depths.col(j) = (edge - radii.array()).max(0);
      n_inside[j] = static_cast<int>((depths.col(j).array() > 0).count());
    }
    const auto region = region_of(rings(), grid, depths, n_inside);
    EXPECT_NEAR(region.area, pi * (0.36 + 0.005), 1e-10);
    EXPECT_NEAR(region.radius, std::sqrt(0.365), 1e-10);
    EXPECT_NEAR(region.along, 0.7, 1e-10);
    EXPECT_NEAR(region.across, 0.5, 1e-10);
    EXPECT_LT(region.uncertainty, 1e-3);
  }
}

// A coupled contact leaves no mirror across the motion: front and back reach out differently far.
TEST(ContactRegion, HasHalfItsExtentsWhereverItLies) {
  const auto grid = angular_grid(16, Mirrors::x);
  const double offset = 0.1, radius = 0.6;  // of a disc beside the centre
  VectorXd edges(grid.n_kept());
  for (Index j = 0; j < edges.size(); ++j) {
    const double across = offset * std::sin(grid.angles[j]);
    edges[j] = offset * std::cos(grid.angles[j]) + std::sqrt(radius * radius - across * across);
  }
  const auto region = region_within(grid, edges);
  EXPECT_NEAR(region.along, radius, 1e-4);
  EXPECT_NEAR(region.across, radius, 1e-4);
  EXPECT_NEAR(region.radius, radius, 1e-6);
}

TEST(ContactRegion, ReadsTheEdgeOfAHertzianContactToASmallShareOfARing) {
  const auto grid = angular_grid(4);
  for (const double radius : {0.7, 0.72, 0.75, 0.77}) {
    const VectorXd profile = ring_means(rings().compliance, [](double r) { return r * r; });
    const auto contact = static_contact(rings(), profile, 2 * radius * radius);
    const auto region = region_of(rings(), grid, contact.pressure.replicate(1, 4));
    EXPECT_NEAR(region.radius, radius, 2e-3 / 16);
    EXPECT_NEAR(region.along, region.across, 1e-12);
  }
}

TEST(ContactRegion, ToARingEndsWithTheLastRing) {
  const auto grid = angular_grid(4);
  const std::vector<double> radii{0, 0.1, 0.2, 0.4, 0.5};
  Eigen::VectorXi n_inside(4);
  n_inside << 3, 2, 2, 1;
  const auto region = region_to_a_ring(radii, grid, n_inside);
  EXPECT_EQ(region.edges[0], 0.4);
  EXPECT_EQ(region.edges[1], 0.2);
  EXPECT_EQ(region.edges[3], 0.1);
  EXPECT_DOUBLE_EQ(region.edge_uncertainty, 0.2) << "the widest ring beside an edge";
  // Of the disc whose area changes as if the edge moved by a ring at all angles, to first order in that.
  EXPECT_NEAR(region.uncertainty, (0.4 * 0.2 + 2 * 0.2 * 0.2 + 0.1 * 0.1) / 4 / std::sqrt((0.16 + 2 * 0.04 + 0.01) / 4),
              1e-12);
}

TEST(ContactRegion, OfNothingIsEmpty) {
  const auto region = region_of(rings(), angular_grid(4), MatrixXd::Zero(rings().n_rings(), 4));
  EXPECT_EQ(region.area, 0);
  EXPECT_EQ(region.along, 0);
}

}  // namespace
}  // namespace fretval::fem::contact_region_test
