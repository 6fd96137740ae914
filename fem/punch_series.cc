#include "fem/punch_series.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fem/edge.h"

namespace fretval::fem {
namespace {

using Eigen::Index;

constexpr Index n_stencil = 4;
constexpr Index n_smallest = 2;
constexpr Index n_to_continue = 3;  // rings that tell where a zone ends

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

/// Where f changes its sign between two nodes, or hardly beyond: at the instant at which a ring changes its zone,
/// roundoff decides on which side of its node.
template <class Function>
std::optional<double> crossing(const Function& f, double node, double next) {
  constexpr double slack = 0.1;
  double low = node - slack * (next - node), high = next + slack * (next - node);
  const double at_low = f(low);
  if (!(at_low * f(high) < 0)) return std::nullopt;
  while (high - low > 1e-14 * high) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    ((f(middle) < 0) == (at_low < 0) ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Where the polynomials of two neighbouring zones meet.
std::optional<double> meeting_point(const Stencil& inner, const Stencil& outer) {
  return crossing([&](double r) { return inner(r) - outer(r); }, inner.x[inner.first + inner.n - 1],
                  outer.x[outer.first]);
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
                             std::optional<double> end_of_depths) const {
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
    if (z + 1 == zones.size())
      end = end_of_depths.value_or(end);
    else if (is_smooth(z) && is_smooth(z + 1))
      end = meeting_point({radii_, depths, last - n + 1, n},
                          {radii_, depths, last + 1, std::min(n_stencil, zones[z + 1].size())})
                .value_or(end);
    for (Index i = first; i <= last; ++i) {
      const double from = i == first ? begin : edges_[i], to = i == last ? end : std::min(edges_[i + 1], end);
      if (to <= from) continue;
      const bool singular_tip = !blunt && i < n_stencil;
      sum += is_smooth(z) && !singular_tip
                 ? Stencil{radii_, depths, std::clamp(i - 1, node, last - n + 1), n}.integral(from, to)
                 : (to - from) * depths[i];
    }
    begin = end;
  }
  return force_per_radius_ * sum;
}

double PunchSeries::edge_of_gap(const Eigen::VectorXd& gap, Index n_closed, Index n_pressed, double kink) const {
  const Eigen::VectorXd opening = displacements(gap);
  // Nodes inside the kink, and the kink itself if it is away from them, where what is outside of it ends.
  Index n_inside = 0;
  while (n_inside < n_stencil && n_pressed + n_inside < gap.size() && radii_[n_pressed + n_inside] < kink) ++n_inside;
  const Index first_outside = n_pressed + n_inside;
  const Stencil outside{radii_, opening, first_outside, std::min(n_stencil, gap.size() - first_outside)};
  const auto vanishing = [&](const Stencil& stencil) {
    return crossing(stencil, radii_[n_closed - 1], radii_[n_pressed]).value_or(edges_[n_pressed]);
  };
  if (n_inside == 0) return vanishing(outside);
  Eigen::VectorXd x(n_inside + 1), y(n_inside + 1);
  x << radii_.segment(n_pressed, n_inside), kink;
  y << opening.segment(n_pressed, n_inside), outside(kink);
  constexpr double far_enough = 0.25;
  const bool has_kink = n_inside < n_to_continue && outside.n == n_stencil &&
                        kink - x[n_inside - 1] > far_enough * (radii_[n_pressed] - radii_[n_pressed - 1]);
  return vanishing({x, y, 0, has_kink ? n_inside + 1 : n_inside});
}

std::optional<double> PunchSeries::edge_of_pressure(const Eigen::VectorXd& depths, Index n_pressed) const {
  const Index n = std::min(n_stencil, n_pressed);
  return crossing(Stencil{radii_, depths, n_pressed - n, n}, radii_[n_pressed - 1], radii_[n_pressed]);
}

ContactForce contact_force(const PunchSeries& series, const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap,
                           const ContactPast& past) {
  const Eigen::VectorXd depths = series.depths(pressure);
  Index n_pressed = 0;
  while (n_pressed < pressure.size() && pressure[n_pressed] > 0) ++n_pressed;
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
  const double radius = edge ? *edge : series.edge_of_gap(gap, n_inner, n_pressed, past.largest_radius);
  return {series.integral(depths, std::vector<signed char>(static_cast<std::size_t>(n_inner), 0), radius), radius};
}

namespace {

/// The reserve of the stuck rings and of the next ones as they were held, with their zones, and where it vanishes.
struct HeldReserve {
  Eigen::VectorXd reserve;
  std::vector<signed char> zones;
  std::optional<double> end;  ///< empty: not next to the last stuck ring
};

HeldReserve held_reserve(const PunchSeries& series, const SlipZones& zones, Eigen::VectorXd reserve,
                         const Eigen::VectorXd& held, Index n_stuck) {
  const auto& radii = series.radii();
  const auto n_pressed = reserve.size();
  HeldReserve result{reserve.head(n_stuck), {zones.labels().begin(), zones.labels().begin() + n_stuck}, std::nullopt};
  const auto last = result.zones.back();
  const Index n_last = std::find_if(result.zones.rbegin(), result.zones.rend(), [&](auto z) { return z != last; }) -
                       result.zones.rbegin();
  const auto next = n_stuck < n_pressed ? zones.held_labels()[static_cast<std::size_t>(n_stuck)] : last;
  Index n_held = 0;
  while (n_held < n_to_continue && n_stuck + n_held < n_pressed &&
         zones.held_labels()[static_cast<std::size_t>(n_stuck + n_held)] == next)
    ++n_held;
  reserve.segment(n_stuck, n_held) = held.segment(n_stuck, n_held);
  const auto vanishes = [&](const Stencil& stencil) { return crossing(stencil, radii[n_stuck - 1], radii[n_stuck]); };
  const auto extend = [&](Index n, double end) {
    result.reserve = reserve.head(n_stuck + n);
    result.zones.insert(result.zones.end(), static_cast<std::size_t>(n), next);
    result.end = end;
    return result;
  };
  const Stencil stuck{radii, reserve, n_stuck - std::min(n_last, n_stencil), std::min(n_last, n_stencil)};
  if (next != last && n_held > 1) {
    const Stencil gone{radii, reserve, n_stuck, n_held};
    const auto kink = meeting_point(stuck, gone), end = vanishes(gone);
    if (kink && end && *kink < *end) return extend(n_held, *end);
  }
  if (next == last && n_last < n_to_continue) {
    const Index n_more = std::min(n_held, n_to_continue - n_last);
    if (const auto end = vanishes({radii, reserve, n_stuck - n_last, n_last + n_more})) return extend(n_more, *end);
  }
  result.end = vanishes(stuck);
  return result;
}

}  // namespace

double friction_force(const PunchSeries& series, const SlipZones& zones, const Eigen::VectorXd& limit_depths,
                      double limit_force) {
  const auto& labels = zones.labels();
  const Index n_pressed = std::find(labels.begin(), labels.end(), SlipZones::free) - labels.begin();
  const auto slip = zones.slip().begin();
  if (n_pressed == 0 || n_pressed == series.radii().size()) return series.integral(zones.depths(), labels);
  const int outermost = slip[n_pressed - 1];
  Index n_stuck = n_pressed;
  while (n_stuck > 0 && outermost != 0 && slip[n_stuck - 1] == outermost) --n_stuck;
  if (n_stuck == 0) return outermost * limit_force;
  const Eigen::VectorXd held = zones.held_depths().array() + zones.depths()[0];
  const auto against = [&](int direction) {
    return held_reserve(series, zones, (limit_depths - direction * zones.depths()).head(n_pressed),
                        limit_depths - direction * held, n_stuck);
  };
  const auto force = [&](int direction, const HeldReserve& held, double end) {
    return direction * (limit_force - series.integral(held.reserve, held.zones, end));
  };
  if (outermost != 0) {
    const auto reserve = against(outermost);
    return force(outermost, reserve, reserve.end.value_or(series.edges()[n_stuck]));
  }
  // Slip has begun outside the middle of the last ring, in one direction.
  const auto forward = against(1), backward = against(-1);
  if (forward.end && !(backward.end && *backward.end < *forward.end)) return force(1, forward, *forward.end);
  if (backward.end) return force(-1, backward, *backward.end);
  return series.integral(zones.depths(), labels);
}

}  // namespace fretval::fem
