#include "fem/ring_contact/punch_series.h"

#include <algorithm>
#include <cmath>

#include "fem/ring_contact/effective_radii.h"
#include "fem/ring_contact/stencil.h"
#include "fem/support/dense.h"

namespace fretval::fem {
namespace {

using Eigen::Index;

constexpr Index n_smallest = 2;

/// Rings first..last share a label, of n.
struct Zone {
  Index first, last, n;
  [[nodiscard]] Index size() const { return last - first + 1; }
  [[nodiscard]] bool is_outermost() const { return last + 1 >= n; }
  [[nodiscard]] bool is_smooth() const { return size() >= n_smallest || is_outermost(); }
};

template <class Label>
Zone zone_from(Index first, const Label& label, Index n) {
  Zone zone{first, first, n};
  while (!zone.is_outermost() && label(zone.last + 1) == label(first)) ++zone.last;
  return zone;
}

/// Where the depths of a zone and of the next one meet; empty where that cannot be told. node: the first of the zone.
std::optional<double> border(const Zone& zone, const Zone& next, Index node, const Eigen::VectorXd& radii,
                             const Eigen::VectorXd& depths) {
  if (!zone.is_smooth() || !next.is_smooth()) return std::nullopt;
  const Index n = std::min<Index>(n_stencil, zone.last - node + 1);
  return meeting_point({radii, depths, zone.last - n + 1, n},
                       {radii, depths, next.first, std::min(n_stencil, next.size())});
}

}  // namespace

PunchSeries::PunchSeries(const Compliance& compliance, SharedMatrix factor, SharedMatrix inverse)
    : factor_(std::move(factor)),
      inverse_(std::move(inverse)),
      areas_(compliance.areas),
      by_load_(factor_->triangularView<Eigen::Lower>().solve(areas_)),
      per_load_(by_load_.cwiseInverse()),
      half_space_(!compliance.half_space) {
  auto radii = effective_radii(compliance);
  edges_ = std::move(radii.radius);
  const Index n = areas_.size();
  const Index n_small = half_space_ ? n : std::min(n, n_stencil);  // rings of the punch whose force per radius counts
  force_per_radius_ = by_load_.head(n_small).squaredNorm() / edges_[n_small];
  places_.edges = edges_;
  if (!half_space_)
    for (Index m = 0; m < n; ++m)
      places_.edges[m + 1] = places_.edges[m] + by_load_[m] * by_load_[m] / force_per_radius_;
  put_depths_at(std::move(radii.of_rings));
}

PunchSeries PunchSeries::with_depths_at(Eigen::VectorXd radii) const {
  PunchSeries moved = *this;
  moved.put_depths_at(std::move(radii));
  return moved;
}

void PunchSeries::put_depths_at(Eigen::VectorXd radii) {
  radii_ = std::move(radii);
  const Index n = radii_.size();
  places_.depths = radii_;
  if (!half_space_)
    for (double& place : places_.depths) place = interpolated(edges_, places_.edges, place);
  whole_rings_.setZero(n_stencil, n);
  for (Index i = 1; i + 2 < n; ++i)
    for (Index k = 0; k < n_stencil; ++k)
      whole_rings_(k, i) =
          Stencil{places_.depths.segment(i - 1, n_stencil), Eigen::Vector4d::Unit(k), 0, n_stencil}.integral(
              places_.edges[i], places_.edges[i + 1]);
}

void PunchSeries::to_depths(Eigen::VectorXd& traction) const {
  multiply_transposed(factor_, traction);
  traction.array() *= per_load_.array();
}

Eigen::VectorXd PunchSeries::depths(Eigen::VectorXd traction) const {
  to_depths(traction);
  return traction;
}

Eigen::MatrixXd PunchSeries::depths_of_instants(Eigen::MatrixXd tractions) const {
  for (auto column : tractions.colwise()) column = depths(column);
  return tractions;
}

Eigen::VectorXd PunchSeries::tractions(const Eigen::VectorXd& depths) const {
  Eigen::VectorXd tractions = loads_of_depths(depths);
  multiply_transposed(inverse_, tractions);
  return tractions;
}

void PunchSeries::to_displacements(Eigen::Ref<Eigen::VectorXd> rings) const {
  Index n_still = 0;
  while (n_still < rings.size() && rings[n_still] == 0) ++n_still;
  rings.array() *= areas_.array();
  multiply_trailing(inverse_, rings.tail(rings.size() - n_still));
  rings.array() *= per_load_.array();
}

Eigen::VectorXd PunchSeries::displacements(Eigen::VectorXd rings) const {
  to_displacements(rings);
  return rings;
}

void PunchSeries::to_rings(Eigen::Ref<Eigen::VectorXd> displacements, Index first) const {
  const Index n = displacements.size();
  displacements.array() *= by_load_.segment(first, n).array();
  multiply_block(factor_, first, displacements);
  displacements.array() /= areas_.segment(first, n).array();
}

double PunchSeries::place_of(double radius) const {
  return half_space_ ? radius : interpolated(edges_, places_.edges, radius);
}

template <class Label>
PunchSeries::Integral PunchSeries::integral_of(const Eigen::VectorXd& depths, const Label& label, Index n_rings,
                                               std::optional<double> end_of_depths) const {
  const Eigen::VectorXd &edges = places_.edges, &places = places_.depths;
  if (end_of_depths) end_of_depths = place_of(*end_of_depths);
  auto zone = zone_from(0, label, n_rings);
  // The innermost depth is off by the shape of the tip (its ring stands for 4/(3 pi) of its radius under a cone, for
  // 1/2 under a parabola): where the next ones continue smoothly to it, they are continued to the centre instead.
  const bool blunt =
      zone.size() > n_stencil && std::abs(Stencil{places, depths, 1, n_stencil}(places[0]) - depths[0]) <=
                                     0.1 * std::abs(depths[1] - depths[0]) + 1e-6 * std::abs(depths[0]);
  const auto kink = [&](Index i) {
    if (i == 0 || i + 1 >= depths.size()) return 0.0;
    return (edges[i + 1] - edges[i]) * std::abs(depths[i - 1] - 2 * depths[i] + depths[i + 1]);
  };
  constexpr double share_of_kink = 0.125;
  double sum = 0, begin = 0, unseen = 0;
  while (true) {
    const Index first = zone.first, last = zone.last;
    const Index node = std::max<Index>(first, blunt ? 1 : 0);
    const Index n = std::min<Index>(n_stencil, last - node + 1);
    const bool is_outermost = zone.is_outermost();
    const auto next = is_outermost ? zone : zone_from(last + 1, label, n_rings);
    const auto meets_next = is_outermost ? end_of_depths : border(zone, next, node, places, depths);
    const double end = meets_next.value_or(edges[last + 1]);
    if (!is_outermost && !meets_next) unseen += share_of_kink * std::max(kink(last), kink(last + 1));
    for (Index i = first; i <= last; ++i) {
      const double from = i == first ? begin : edges[i], to = i == last ? end : std::min(edges[i + 1], end);
      if (to <= from) continue;
      const bool singular_tip = !blunt && i < n_stencil;
      const bool is_inside = i > node && i + 1 < last && edges[i + 1] <= end;
      if (!zone.is_smooth() || singular_tip)
        sum += (to - from) * depths[i];
      else if (is_inside)
        sum += whole_rings_.col(i).dot(depths.segment<n_stencil>(i - 1));
      else
        sum += Stencil{places, depths, std::clamp(i - 1, node, last - n + 1), n}.integral(from, to);
    }
    if (is_outermost) break;
    begin = end;
    zone = next;
  }
  return {force_per_radius_ * sum, force_per_radius_ * unseen};
}

PunchSeries::Integral PunchSeries::integral(const Eigen::VectorXd& depths, const std::vector<signed char>& labels,
                                            std::optional<double> end) const {
  const auto label = [&labels](Index ring) { return labels[static_cast<std::size_t>(ring)]; };
  return integral_of(depths, label, static_cast<Index>(labels.size()), end);
}

PunchSeries::Integral PunchSeries::integral(const Eigen::VectorXd& depths, Index n_inner, Index n,
                                            std::optional<double> end) const {
  return integral_of(
      depths, [n_inner](Index ring) { return ring < n_inner; }, n, end);
}

std::optional<double> PunchSeries::edge_of_pressure(const Eigen::VectorXd& depths, Index n_pressed) const {
  const Index n = std::min(n_stencil, n_pressed);
  return crossing(Stencil{radii_, depths, n_pressed - n, n}, radii_[n_pressed - 1], radii_[n_pressed]);
}

}  // namespace fretval::fem
