#include "fem/history/contact_force.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/condensation/stencil.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

/// Plain sum over the rings that are pressed beyond the first free one. At the ends of each of their zones it is
/// uncertain by half of what the last ring bears.
void add_detached(const PunchSeries& series, const Eigen::VectorXd& pressure, Index first, ContactForce& contact) {
  const Eigen::VectorXd forces = pressure.cwiseProduct(series.areas());
  for (Index i = first; i < forces.size(); ++i) {
    if (forces[i] <= 0) continue;
    contact.force += forces[i];
    const bool ends_inside = forces[i - 1] <= 0, ends_outside = i + 1 == forces.size() || forces[i + 1] <= 0;
    contact.uncertainty += (ends_inside + ends_outside) * forces[i] / 2;
  }
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
  const Index n_beyond = pressure.size() - n_pressed;
  if ((pressure.tail(n_beyond).array() <= 0).all()) return central_force(series, pressure, gap, n_pressed, past);
  Eigen::VectorXd central = pressure;
  central.tail(n_beyond).setZero();
  auto contact = central_force(series, central, gap, n_pressed, past);
  add_detached(series, pressure, n_pressed, contact);
  return contact;
}

}  // namespace fretval::fem
