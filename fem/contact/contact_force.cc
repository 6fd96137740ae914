#include "fem/contact/contact_force.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/condensation/stencil.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

/// What the edges of the zones beyond the first free ring leave open: half of what the last ring of each bears.
double uncertainty_beyond(const PunchSeries& series, const Eigen::VectorXd& pressure, Index n_pressed) {
  const Eigen::VectorXd forces = pressure.cwiseProduct(series.areas());
  double uncertainty = 0;
  for (Index i = n_pressed + 1; i < forces.size(); ++i) {
    const bool ends_inside = forces[i - 1] <= 0, ends_outside = i + 1 == forces.size() || forces[i + 1] <= 0;
    uncertainty += (ends_inside + ends_outside) * forces[i] / 2;
  }
  return uncertainty;
}

/// Of the depths beyond the edge of the contact around the centre, a plain sum.
double force_beyond(const PunchSeries& series, const Eigen::VectorXd& depths, Index n_pressed, double radius) {
  const Index n = depths.size() - n_pressed;
  const auto& edges = series.edges();
  return series.force_per_radius() * (depths.tail(n).dot(edges.tail(n) - edges.segment(n_pressed, n)) +
                                      depths[n_pressed] * (edges[n_pressed] - radius));
}

/// Too few rings around the centre to tell where they end, or no free ring: of all rings.
ContactForce force_of_all(const PunchSeries& series, const Eigen::VectorXd& depths, Index n_pressed) {
  std::vector<signed char> zones(static_cast<std::size_t>(depths.size()), 0);
  std::fill(zones.begin() + n_pressed, zones.end(), 1);
  return {series.integral(depths, zones).value, series.edges()[n_pressed]};
}

/// Of a body without memory, whose rings in contact tell nothing of the gap.
Opening opening_outside(const PunchSeries& series, const Eigen::VectorXd& gap, Index n_pressed) {
  Opening opening{series.displacements(gap), Eigen::VectorXi::Constant(gap.size(), FreeSurface::never_touched),
                  Eigen::VectorXd::Zero(gap.size())};
  opening.value.head(n_pressed).setZero();
  opening.retreat.head(n_pressed).setConstant(FreeSurface::never_lifted);
  return opening;
}

/// Between the last ring in contact and the next one; empty where the gap jumps (a flat punch).
std::optional<double> edge_of_contact(const PunchSeries& series, const Eigen::VectorXd& depths,
                                      const Eigen::VectorXd& gap, Index n_pressed, const ContactPast& past) {
  if (!past.opening) return edge_of(opening_outside(series, gap, n_pressed), series.radii(), n_pressed);
  const auto by_gap = edge_of(*past.opening, series.radii(), n_pressed);
  // A contact that goes back ends where its pressure vanishes, before its gap would.
  const auto by_pressure = series.edge_of_pressure(depths, n_pressed);
  return by_gap && by_pressure ? std::min(*by_gap, *by_pressure) : by_gap ? by_gap : by_pressure;
}

/// Of the n_pressed rings around the centre.
ContactForce central_force(const PunchSeries& series, const Eigen::VectorXd& depths, const Eigen::VectorXd& gap,
                           Index n_pressed, const ContactPast& past) {
  const auto& radii = series.radii();
  const auto edge = edge_of_contact(series, depths, gap, n_pressed, past);
  const double radius = edge.value_or(series.edges()[n_pressed]);
  const std::vector<signed char> one_zone(static_cast<std::size_t>(n_pressed), 0);
  const double force = series.integral(depths, one_zone, radius).value;
  double too_much = 0;
  // Not at a sharp edge of the indenter.
  if (edge && past.edge != PressureAtEdge::jumps) {
    const double at_edge = Stencil{radii, depths, n_pressed - n_stencil, n_stencil}(radius);
    too_much = series.force_per_radius() * at_edge * (radius - radii[n_pressed - 1]) / 2;
  }
  const double uncertainty = std::abs(too_much);
  if (past.edge == PressureAtEdge::vanishes) return {force - too_much / 2, radius, uncertainty / 2};
  return {force, radius, uncertainty};
}

}  // namespace

ContactForce contact_force(const PunchSeries& series, const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap,
                           const ContactPast& past) {
  Eigen::VectorXd depths = series.depths(pressure);
  if (past.passing_depths) depths = (depths + *past.passing_depths).cwiseMax(0);
  Index n_pressed = 0;
  while (n_pressed < pressure.size() && pressure[n_pressed] > 0 && depths[n_pressed] > 0) ++n_pressed;
  const bool has_edge = n_pressed > n_stencil && n_pressed + 2 < pressure.size();
  auto contact =
      has_edge ? central_force(series, depths, gap, n_pressed, past) : force_of_all(series, depths, n_pressed);
  contact.beyond.uncertainty = uncertainty_beyond(series, pressure, n_pressed);
  if (has_edge && contact.beyond.uncertainty > 0)
    contact.beyond.force = force_beyond(series, depths, n_pressed, contact.radius);
  return contact;
}

ContactForce sum_of_rings(const std::vector<double>& radii, const Eigen::VectorXd& areas,
                          const Eigen::VectorXd& pressure) {
  std::size_t n_pressed = static_cast<std::size_t>(pressure.size());
  while (n_pressed > 0 && !(pressure[static_cast<Eigen::Index>(n_pressed - 1)] > 0)) --n_pressed;
  return {areas.dot(pressure), radii[n_pressed]};
}

ContactForce sum_inside_flank(const Compliance& compliance, const Eigen::VectorXd& pressure,
                              Eigen::Index n_inside_flank) {
  Index n_pressed = n_inside_flank;
  while (n_pressed < pressure.size() && pressure[n_pressed] > 0) ++n_pressed;
  const Eigen::VectorXd forces = pressure.cwiseProduct(compliance.areas);
  ContactForce contact{forces.head(n_pressed).sum(), compliance.radii[static_cast<std::size_t>(n_inside_flank)]};
  contact.beyond.force = forces.tail(forces.size() - n_pressed).sum();
  return contact;
}

}  // namespace fretval::fem
