#include "fem/stick_zone/edge_near_largest_contact.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "fem/condensation/stencil.h"
#include "fem/support/constants.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

constexpr Index n_seen = 3;

/// Half of a cycle: the instants before or after the largest contact, from there outwards.
struct HalfCycle {
  double time_of_largest;
  Index next;  ///< column of the instant next to it
  int outwards;
  Index size;

  [[nodiscard]] Index column(Index i) const { return next + outwards * i; }
};

/// Instants, from the largest contact on, behind which the kinks are seen. At the largest contact itself there is none.
Index count_hidden(const NormalHistory& history, const HalfCycle& half) {
  Index n = 1;
  while (n < half.size && history.hidden_kink[half.column(n)]) ++n;
  return n;
}

/// Where the edge is at instants that see no kink, from the largest contact and three that do.
struct EdgeOverTime {
  Eigen::VectorXd time, radius;

  [[nodiscard]] double at(double t) const { return Stencil{time, radius, 0, n_seen + 1}(t); }
};

std::optional<EdgeOverTime> edge_over_time(const NormalHistory& history, const HalfCycle& half, Index n_hidden,
                                           double largest_radius) {
  const Index n_left = half.size - 1 - n_hidden,
              apart = std::min(std::max<Index>(1, n_hidden / 2), n_left / (n_seen - 1));
  if (apart < 1) return std::nullopt;
  EdgeOverTime edge{Eigen::VectorXd(n_seen + 1), Eigen::VectorXd(n_seen + 1)};
  edge.time[0] = half.time_of_largest;
  edge.radius[0] = largest_radius;
  for (Index i = 0; i < n_seen; ++i) {
    const Index column = half.column(n_hidden + i * apart);
    if (history.hidden_kink[column] || history.n_closed[column] == 0) return std::nullopt;
    edge.time[i + 1] = history.time[column];
    edge.radius[i + 1] = history.contact_radius[column];
  }
  return edge;
}

void read_instant(const PunchSeries& series, const std::optional<EdgeOverTime>& edge, Index column,
                  NormalHistory& history) {
  const Eigen::VectorXd depths = series.depths(history.pressure.col(column));
  const Index n_closed = history.n_closed[column];
  const std::vector<signed char> one_zone(static_cast<std::size_t>(n_closed), 0);
  const auto force = [&](double end) { return series.integral(depths, one_zone, end).value; };
  double& radius = history.contact_radius[column];
  if (!edge) {
    history.force_uncertainty[column] += std::abs(force(radius) - force(series.radii()[n_closed - 1]));
    return;
  }
  const double by_gap = std::exchange(radius, edge->at(history.time[column]));
  history.force[column] += force(radius) - force(by_gap);
}

void read_half(const PunchSeries& series, double largest_radius, const HalfCycle& half, NormalHistory& history) {
  const Index n_hidden = count_hidden(history, half);
  const auto edge = edge_over_time(history, half, n_hidden, largest_radius);
  for (Index i = 0; i < n_hidden; ++i)
    if (history.hidden_kink[half.column(i)]) read_instant(series, edge, half.column(i), history);
}

}  // namespace

void read_edges_near_largest_contact(const PunchSeries& series, double largest_radius, NormalHistory& history) {
  const Index n = history.time.size(), n_steps = history.steps_per_cycle;
  const double begin = 2 * pi * (history.n_cycles - 1), end = 2 * pi * history.n_cycles;
  read_half(series, largest_radius, {begin, n - n_steps, 1, n_steps / 2}, history);
  read_half(series, largest_radius, {end, n - 1, -1, n_steps / 2}, history);
}

}  // namespace fretval::fem
