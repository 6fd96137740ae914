#include "fem/punch_series.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fem/edge.h"

namespace fretval::fem {
namespace {

using Eigen::Index;

constexpr Index n_stencil = 4;
constexpr Index n_smallest = 3;

/// The polynomial through nodes first..first+n-1.
struct Stencil {
  const Eigen::VectorXd& x;
  const Eigen::VectorXd& y;
  Index first, n;

  double operator()(double at) const {
    double value = 0;
    for (Index i = first; i < first + n; ++i) {
      double weight = 1;
      for (Index j = first; j < first + n; ++j)
        if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
      value += weight * y[i];
    }
    return value;
  }

  /// Exact: the polynomial is a cubic at most.
  [[nodiscard]] double integral(double from, double to) const {
    const double middle = (from + to) / 2, offset = (to - from) / (2 * std::sqrt(3.0));
    return (to - from) / 2 * ((*this)(middle - offset) + (*this)(middle + offset));
  }
};

/// Rings first..last share a label.
struct Zone {
  Index first, last;
  [[nodiscard]] Index size() const { return last - first + 1; }
};

std::vector<Zone> zones_of(const std::vector<signed char>& labels) {
  std::vector<Zone> zones{{0, 0}};
  for (std::size_t i = 1; i < labels.size(); ++i) {
    if (labels[i] == labels[i - 1])
      ++zones.back().last;
    else
      zones.push_back({static_cast<Index>(i), static_cast<Index>(i)});
  }
  return zones;
}

/// Where the polynomials of two neighbouring zones meet between their nodes, or hardly beyond: at the instant at which
/// a ring changes its zone, roundoff decides on which side of its node. Otherwise between the last ring of the one and
/// the first of the other.
double meeting_point(const Stencil& inner, const Stencil& outer, double between) {
  constexpr double slack = 0.1;
  const double last = inner.x[inner.first + inner.n - 1], next = outer.x[outer.first];
  double low = last - slack * (next - last), high = next + slack * (next - last);
  const double difference = inner(low) - outer(low);
  if (!(difference * (inner(high) - outer(high)) < 0)) return between;
  while (high - low > 1e-14 * high) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    ((inner(middle) - outer(middle) < 0) == (difference < 0) ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

PunchSeries::PunchSeries(const Compliance& compliance, const Eigen::MatrixXd& factor)
    : factor_(factor),
      areas_(compliance.areas),
      by_load_(factor.triangularView<Eigen::Lower>().solve(areas_)),
      edges_(effective_radii(compliance).radius),
      radii_((edges_.head(areas_.size()) + edges_.tail(areas_.size())) / 2),
      force_per_radius_(by_load_.squaredNorm() / edges_[areas_.size()]) {}

Eigen::MatrixXd PunchSeries::depths(const Eigen::MatrixXd& tractions) const {
  const Eigen::MatrixXd half = factor_.transpose().triangularView<Eigen::Upper>() * tractions;
  return by_load_.cwiseInverse().asDiagonal() * half;
}

Eigen::VectorXd PunchSeries::displacements(const Eigen::VectorXd& rings) const {
  return factor_.triangularView<Eigen::Lower>().solve(areas_.cwiseProduct(rings)).cwiseQuotient(by_load_);
}

double PunchSeries::integral(const Eigen::VectorXd& depths, const std::vector<signed char>& labels,
                             std::optional<double> edge) const {
  const auto zones = zones_of(labels);
  const auto is_smooth = [&](std::size_t z) { return zones[z].size() >= n_smallest || z + 1 == zones.size(); };
  // The innermost depth is off by the shape of the tip (its ring stands for 4/(3 pi) of its radius under a cone, for
  // 1/2 under a parabola): where the next ones continue smoothly to it, they are continued to the centre instead.
  const bool blunt =
      zones[0].size() > n_stencil && std::abs(Stencil{radii_, depths, 1, n_stencil}(radii_[0]) - depths[0]) <=
                                         0.1 * std::abs(depths[1] - depths[0]) + 1e-6 * std::abs(depths[0]);
  double sum = 0, begin = 0;
  for (std::size_t z = 0; z < zones.size(); ++z) {
    const auto [first, last] = zones[z];
    const Index node = std::max<Index>(first, blunt ? 1 : 0);
    const Index n = std::min<Index>(n_stencil, last - node + 1);
    double end = edges_[last + 1];
    if (z == 0 && edge)
      end = *edge;
    else if (z + 1 < zones.size() && is_smooth(z) && is_smooth(z + 1))
      end = meeting_point({radii_, depths, last - n + 1, n},
                          {radii_, depths, last + 1, std::min(n_stencil, zones[z + 1].size())}, end);
    for (Index i = first; i <= last; ++i) {
      const double from = i == first ? begin : edges_[i], to = i == last ? end : edges_[i + 1];
      const bool singular_tip = !blunt && i < n_stencil;
      sum += is_smooth(z) && !singular_tip
                 ? Stencil{radii_, depths, std::clamp(i - 1, node, last - n + 1), n}.integral(from, to)
                 : (to - from) * depths[i];
    }
    begin = end;
  }
  return force_per_radius_ * sum;
}

double PunchSeries::edge_of_gap(const Eigen::VectorXd& gap, Index n_closed, Index n_pressed) const {
  const Eigen::VectorXd opening = displacements(gap);
  const Stencil outside{radii_, opening, n_pressed, std::min(n_stencil, gap.size() - n_pressed)};
  double low = radii_[n_closed - 1], high = radii_[n_pressed];
  if (outside(low) >= 0) return edges_[n_pressed];
  while (high - low > 1e-14 * high) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    (outside(middle) < 0 ? low : high) = middle;
  }
  return high;
}

double contact_force(const PunchSeries& series, const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap,
                     std::optional<Index> n_closed) {
  std::vector<signed char> zones(static_cast<std::size_t>(pressure.size()));
  for (Index i = 0; i < pressure.size(); ++i) zones[static_cast<std::size_t>(i)] = pressure[i] > 0 ? 0 : 1;
  Eigen::VectorXd depths = series.depths(pressure);
  const auto n_pressed = static_cast<Index>(std::find(zones.begin(), zones.end(), 1) - zones.begin());
  const bool has_edge = n_pressed > n_stencil && n_pressed + 2 < pressure.size();
  if (!has_edge) return series.integral(depths, zones);
  const Index n_inner = std::clamp(n_closed.value_or(n_pressed), n_stencil, n_pressed);
  const double edge = series.edge_of_gap(gap, n_inner, n_pressed);
  for (Index i = n_inner; i < n_pressed; ++i) {
    zones[static_cast<std::size_t>(i)] = 1;
    depths[i] = 0;
  }
  return series.integral(depths, zones, edge);
}

double friction_force(const PunchSeries& series, const FrictionState& state) {
  const auto n = static_cast<Index>(state.zones.size());
  const Eigen::VectorXd depths = series.depths(state.traction);
  Index n_pressed = 0;
  while (n_pressed < n && state.limit[n_pressed] > 0) ++n_pressed;
  const double sign = n_pressed > 0 && state.traction[n_pressed - 1] < 0 ? -1 : 1;
  const auto slips = [&](Index ring) { return sign * state.traction[ring] >= (1 - 1e-12) * state.limit[ring]; };
  auto zones = state.zones;
  Index first_slipping = n_pressed;
  while (first_slipping > 0 && slips(first_slipping - 1)) --first_slipping;
  if (first_slipping == n_pressed) return series.integral(depths, zones);
  // The reserve of slipping rings is zero as outside the contact.
  std::fill(zones.begin() + first_slipping, zones.end(), SlipZones::free);
  return sign * (state.limit_force - series.integral(series.depths(state.limit) - sign * depths, zones));
}

}  // namespace fretval::fem
