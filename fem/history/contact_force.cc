#include "fem/history/contact_force.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/condensation/stencil.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

/// Force of the depths beyond the edge of the contact around the centre, a plain sum: uncertain by half of what the
/// last ring of each zone bears.
ForceBeyond force_beyond(const PunchSeries& series, const Eigen::VectorXd& pressure, Index n_pressed, double radius) {
  ForceBeyond beyond;
  const Index n = pressure.size() - n_pressed;
  if ((pressure.tail(n).array() <= 0).all()) return beyond;
  const Eigen::VectorXd depths = series.depths(pressure).col(0).tail(n), &edges = series.edges();
  beyond.force = series.force_per_radius() *
                 (depths.dot(edges.tail(n) - edges.segment(n_pressed, n)) + depths[0] * (edges[n_pressed] - radius));
  const Eigen::VectorXd forces = pressure.cwiseProduct(series.areas());
  for (Index i = n_pressed; i < forces.size(); ++i) {
    const bool ends_inside = forces[i - 1] <= 0, ends_outside = i + 1 == forces.size() || forces[i + 1] <= 0;
    beyond.uncertainty += (ends_inside + ends_outside) * forces[i] / 2;
  }
  return beyond;
}

/// Of the n_pressed rings around the centre.
ContactForce central_force(const PunchSeries& series, const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap,
                           Index n_pressed, const ContactPast& past) {
  const Eigen::VectorXd depths = series.depths(pressure);
  const bool has_edge = n_pressed > n_stencil && n_pressed + 2 < pressure.size();
  if (!has_edge) {
    std::vector<signed char> zones(static_cast<std::size_t>(pressure.size()), 0);
    std::fill(zones.begin() + n_pressed, zones.end(), 1);
    return {series.integral(depths, zones), series.edges()[n_pressed]};
  }
  const Index n_inner = std::clamp(past.n_closed.value_or(n_pressed), n_stencil, n_pressed);
  // Next to the largest contact so far, pressures that do not jump know the edge better.
  const auto& radii = series.radii();
  const bool smooth_pressure = !past.n_closed && past.largest_radius > radii[n_pressed] &&
                               past.largest_radius < radii[std::min(n_pressed + n_to_continue, radii.size()) - 1];
  std::optional<double> edge;
  if (smooth_pressure) edge = series.edge_of_pressure(depths, n_pressed);
  if (!edge) edge = series.edge_of_gap(gap, n_inner, n_pressed, past.largest_radius);
  const double radius = edge.value_or(series.edges()[n_pressed]);
  const std::vector<signed char> one_zone(static_cast<std::size_t>(n_inner), 0);
  const double force = series.integral(depths, one_zone, radius);
  double kink = 0, uncertainty = 0, too_much = 0;
  if (past.edge != PressureAtEdge::vanishes) {
    constexpr double share_of_kink = 0.25;
    const bool unseen_kink = past.largest_radius > radius && past.largest_radius <= radii[n_pressed];
    if (unseen_kink) kink = share_of_kink * std::abs(series.integral(depths, one_zone, past.largest_radius) - force);
  }
  // Not at a sharp edge of the indenter.
  if (edge && past.edge != PressureAtEdge::jumps) {
    const double at_edge = Stencil{radii, depths, n_inner - n_stencil, n_stencil}(radius);
    too_much = series.force_per_radius() * at_edge * (radius - radii[n_pressed - 1]) / 2;
    uncertainty += std::abs(too_much);
  }
  if (past.edge != PressureAtEdge::vanishes) return {force, radius, uncertainty + kink, kink, n_inner};
  return {force - too_much / 2, radius, uncertainty / 2};
}

}  // namespace

ContactForce contact_force(const PunchSeries& series, const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap,
                           const ContactPast& past) {
  Index n_pressed = 0;
  while (n_pressed < pressure.size() && pressure[n_pressed] > 0) ++n_pressed;
  auto contact = central_force(series, pressure, gap, n_pressed, past);
  contact.beyond = force_beyond(series, pressure, n_pressed, contact.radius);
  return contact;
}

}  // namespace fretval::fem
