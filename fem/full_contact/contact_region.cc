#include "fem/full_contact/contact_region.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/ring_contact/stick_zone/stick_radius.h"
#include "fem/support/constants.h"

namespace fretval::fem {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Values on all angles around the axis, of what is even about the mirrors.
VectorXd all_around(const AngularGrid& grid, const VectorXd& kept) {
  VectorXd all(static_cast<Index>(grid.n_around));
  Index j = 0;
  for (const auto& point : whole_circle(grid)) all[j++] = kept[point.kept];
  return all;
}

/// The trigonometric polynomial through values on all angles, by Dirichlet's kernel.
double between_angles(const VectorXd& all, double angle) {
  const auto n = static_cast<double>(all.size());
  double sum = 0;
  for (Index j = 0; j < all.size(); ++j) {
    const double distance = angle - (static_cast<double>(j) + 0.5) * 2 * pi / n, sine = std::sin(distance / 2);
    if (std::abs(sine) < 1e-12) return all[j];
    const double kernel = std::sin(n * distance / 2) / (n * sine);
    sum += all[j] * (all.size() % 2 == 0 ? kernel * std::cos(distance / 2) : kernel);
  }
  return sum;
}

/// The region whose edges are known to within their uncertainties. A mean over the angles of edge times uncertainty is
/// what the area is off by at most, over 2 pi.
ContactRegion region_within(const AngularGrid& grid, VectorXd edges, const VectorXd& uncertainties) {
  auto region = region_within(grid, std::move(edges));
  region.edge_uncertainty = uncertainties.maxCoeff();
  region.uncertainty =
      region.radius > 0 ? region.edges.dot(uncertainties) / (static_cast<double>(uncertainties.size()) * region.radius)
                        : region.edge_uncertainty;
  return region;
}

}  // namespace

Eigen::VectorXi rings_inside(const Eigen::MatrixXd& margin) {
  Eigen::VectorXi n_inside = Eigen::VectorXi::Zero(margin.cols());
  for (Index j = 0; j < margin.cols(); ++j)
    while (n_inside[j] < margin.rows() && margin(n_inside[j], j) > 0) ++n_inside[j];
  return n_inside;
}

ContactRegion region_within(const AngularGrid& grid, VectorXd edges) {
  ContactRegion region;
  region.edges = std::move(edges);
  region.area = pi * region.edges.squaredNorm() / static_cast<double>(region.edges.size());
  region.radius = std::sqrt(region.area / pi);
  const VectorXd all = all_around(grid, region.edges);
  constexpr int n_looks = 360;
  Eigen::ArrayXd x(n_looks), y(n_looks);
  for (int i = 0; i < n_looks; ++i) {
    const double angle = 2 * pi * i / n_looks, edge = between_angles(all, angle);
    x[i] = edge * std::cos(angle);
    y[i] = edge * std::sin(angle);
  }
  region.along = (x.maxCoeff() - x.minCoeff()) / 2;
  region.across = (y.maxCoeff() - y.minCoeff()) / 2;
  return region;
}

ContactRegion region_of(const ContactProblem& rings, const AngularGrid& grid, const Eigen::MatrixXd& depths,
                        const Eigen::VectorXi& n_inside) {
  const auto radii = effective_radii(rings.compliance);
  VectorXd edges(depths.cols()), uncertainties(depths.cols());
  for (Index j = 0; j < depths.cols(); ++j) {
    const auto edge = stick_radius(rings.compliance, radii, depths.col(j), n_inside[j]);
    edges[j] = edge.radius;
    uncertainties[j] = edge.uncertainty;
  }
  return region_within(grid, std::move(edges), uncertainties);
}

ContactRegion region_of(const ContactProblem& rings, const AngularGrid& grid, const Eigen::MatrixXd& margin) {
  return region_of(rings, grid, rings.series.depths_of_instants(margin), rings_inside(margin));
}

ContactRegion region_to_a_ring(const std::vector<double>& radii, const AngularGrid& grid,
                               const Eigen::VectorXi& n_inside) {
  VectorXd edges(n_inside.size()), uncertainties = VectorXd::Zero(n_inside.size());
  for (Index j = 0; j < edges.size(); ++j) {
    const auto n = static_cast<std::size_t>(n_inside[j]);
    edges[j] = radii[n];
    if (n > 0) uncertainties[j] = radii[n] - radii[n - 1];
    if (n + 1 < radii.size()) uncertainties[j] = std::max(uncertainties[j], radii[n + 1] - radii[n]);
  }
  return region_within(grid, std::move(edges), uncertainties);
}

}  // namespace fretval::fem
