#include "fem/ring_contact/contact_force.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/ring_contact/stencil.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

/// What the edges of the zones beyond the first free ring leave open: half of what the last ring of each bears.
double uncertainty_beyond(const PunchSeries& series, const Eigen::VectorXd& pressure, Index n_pressed) {
  const Index n = pressure.size();
  double uncertainty = 0;
  for (Index i = n_pressed + 1; i < n; ++i) {
    const bool ends_inside = pressure[i - 1] <= 0, ends_outside = i + 1 == n || pressure[i + 1] <= 0;
    uncertainty += (ends_inside + ends_outside) * pressure[i] * series.areas()[i] / 2;
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
  return {series.integral(depths, n_pressed, depths.size()).value, series.edges()[n_pressed]};
}

/// Between the last ring in contact and the next one; empty where the gap jumps (a flat punch).
std::optional<double> edge_of_contact(const PunchSeries& series, const ContactInstant& instant, Index n_pressed) {
  const auto by_gap = edge_of(instant.opening, series.radii(), n_pressed);
  if (instant.opening.retreat.size() == 0) return by_gap;
  // A contact that goes back ends where its pressure vanishes, before its gap would.
  const auto by_pressure = series.edge_of_pressure(instant.depths, n_pressed);
  return by_gap && by_pressure ? std::min(*by_gap, *by_pressure) : by_gap ? by_gap : by_pressure;
}

/// The force on the n_pressed rings around the centre.
ContactForce central_force(const PunchSeries& series, const ContactInstant& instant, Index n_pressed) {
  const auto edge = edge_of_contact(series, instant, n_pressed);
  const double radius = edge.value_or(series.edges()[n_pressed]);
  const double force = series.integral(instant.depths, n_pressed, n_pressed, radius).value;
  if (!edge || !instant.times) return {force, radius};
  const auto missed = force_missed_at_edge(series, instant.depths, n_pressed, radius, *instant.times);
  return {force + missed.force, radius, missed.uncertainty};
}

}  // namespace

ContactForce contact_force(const PunchSeries& series, const ContactInstant& instant) {
  const auto& pressure = instant.pressure;
  const auto& depths = instant.depths;
  Index n_pressed = 0;
  while (n_pressed < pressure.size() && pressure[n_pressed] > 0 && depths[n_pressed] > 0) ++n_pressed;
  const bool has_edge = n_pressed > n_stencil && n_pressed + 2 < pressure.size();
  auto contact = has_edge ? central_force(series, instant, n_pressed) : force_of_all(series, depths, n_pressed);
  contact.beyond.uncertainty = uncertainty_beyond(series, pressure, n_pressed);
  if (has_edge && contact.beyond.uncertainty > 0)
    contact.beyond.force = force_beyond(series, depths, n_pressed, contact.radius);
  return contact;
}

ContactForce contact_force(const PunchSeries& series, const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) {
  const Eigen::VectorXd depths = series.depths(pressure);
  const Opening opening{series.displacements(gap)};
  return contact_force(series, {pressure, depths, opening});
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
