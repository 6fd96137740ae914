#include "fem/unseen_kink.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/stencil.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

constexpr double pi = 3.14159265358979323846;
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
  while (n < half.size && history.kink_uncertainty[half.column(n)] > 0) ++n;
  return n;
}

void judge(const PunchSeries& series, double largest_radius, const HalfCycle& half, NormalHistory& history) {
  constexpr double safety = 2;
  const Index n_hidden = count_hidden(history, half), apart = std::max<Index>(1, n_hidden / 2);
  if (n_hidden + (n_seen - 1) * apart >= half.size) return;
  Eigen::VectorXd time(n_seen + 1), radius(n_seen + 1);
  time[0] = half.time_of_largest;
  radius[0] = largest_radius;
  for (Index i = 0; i < n_seen; ++i) {
    const Index column = half.column(n_hidden + i * apart);
    if (history.kink_uncertainty[column] > 0 || history.n_closed[column] == 0) return;
    time[i + 1] = history.time[column];
    radius[i + 1] = history.contact_radius[column];
  }
  const Stencil edge{time, radius, 0, n_seen + 1};
  for (Index i = 0; i < n_hidden; ++i) {
    const Index column = half.column(i);
    double& kink = history.kink_uncertainty[column];
    if (kink == 0) continue;
    const Eigen::VectorXd depths = series.depths(history.pressure.col(column));
    const std::vector<signed char> one_zone(static_cast<std::size_t>(history.n_closed[column]), 0);
    const auto force = [&](double end) { return series.integral(depths, one_zone, end); };
    const double difference = force(edge(history.time[column])) - force(history.contact_radius[column]);
    const double mended = std::min(kink, safety * std::abs(difference));
    history.force_uncertainty[column] += mended - kink;
    kink = mended;
  }
}

}  // namespace

void judge_unseen_kinks(const PunchSeries& series, double largest_radius, NormalHistory& history) {
  const Index n = history.time.size(), n_steps = history.steps_per_cycle;
  const double begin = 2 * pi * (history.n_cycles - 1), end = 2 * pi * history.n_cycles;
  judge(series, largest_radius, {begin, n - n_steps, 1, n_steps / 2}, history);
  judge(series, largest_radius, {end, n - 1, -1, n_steps / 2}, history);
}

}  // namespace fretval::fem
