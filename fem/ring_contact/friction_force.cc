#include "fem/ring_contact/friction_force.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "fem/ring_contact/stencil.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

/// Number of rings at the end of a range that share a label.
Index size_of_last_zone(const std::vector<signed char>& zones) {
  return std::find_if(zones.rbegin(), zones.rend(), [&](auto z) { return z != zones.back(); }) - zones.rbegin();
}

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
  const Index n_last = size_of_last_zone(result.zones);
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

/// Depths interpolated at the radii of the series, from the radii at which the rings touched again.
Eigen::VectorXd at_own_radii(const PunchSeries& series, const TouchingRings& touching,
                             const std::vector<signed char>& labels, const Eigen::VectorXd& depths) {
  Eigen::VectorXd moved = depths;
  const Eigen::VectorXd& radii = touching.radii;
  const auto touched = [&](Index i) {
    return i >= 0 && i < depths.size() && labels[static_cast<std::size_t>(i)] == SlipZones::touched_again;
  };
  for (Index i = 0; i < depths.size(); ++i) {
    const Index inner = touched(i - 1) ? i - 1 : i, outer = touched(i + 1) ? i + 1 : i;
    if (touched(i) && inner < outer)
      moved[i] += (depths[outer] - depths[inner]) / (radii[outer] - radii[inner]) * (series.radii()[i] - radii[i]);
  }
  return moved;
}

FrictionForce force_of(const PunchSeries::Integral& integral) {
  return {integral.value, integral.unseen_kinks};
}

/// The force if less than three rings have touched since the contact turned and all of them stick; empty otherwise:
/// where slip begins outside the last ring, more of them show it better.
std::optional<FrictionForce> force_of_growing_contact(const PunchSeries& series, const SlipZones& zones,
                                                      const TouchingRings& touching,
                                                      const Eigen::VectorXd& limit_depths) {
  const double turning = touching.turning_radius, edge = touching.contact_radius;
  const Eigen::VectorXd& radii = touching.radii;
  const auto rings_within = [&](double r) {
    return std::upper_bound(radii.data(), radii.data() + radii.size(), r) - radii.data();
  };
  const Index n_before = rings_within(turning);
  if (!touching.from_zero || n_before < n_stencil || n_before == radii.size() || edge <= turning) return std::nullopt;
  // Rings too close to either end tell no more than that.
  const double apart = 0.25 * (radii[n_before] - radii[n_before - 1]);
  const Index first = rings_within(turning + apart), n_grown = rings_within(edge - apart);
  if (n_grown - n_before >= n_to_continue) return std::nullopt;
  const auto& depths = zones.depths();
  const auto& labels = zones.labels();
  for (Index i = n_before; i < radii.size() && labels[static_cast<std::size_t>(i)] != SlipZones::free; ++i)
    if (zones.slip()[static_cast<std::size_t>(i)] != 0 ||
        labels[static_cast<std::size_t>(i)] != SlipZones::touched_again)
      return std::nullopt;
  const std::vector<signed char> before(labels.begin(), labels.begin() + n_before);
  const Index n = std::min(size_of_last_zone(before), n_stencil), size = std::max<Index>(n_grown - first, 0) + 2;
  if (n < n_to_continue) return std::nullopt;
  Eigen::VectorXd x(size), y(size);
  x[0] = turning;
  y[0] = Stencil{series.radii(), depths, n_before - n, n}(turning);
  for (Index k = 1; k + 1 < size; ++k) {
    x[k] = radii[first + k - 1];
    y[k] = depths[first + k - 1];
  }
  x[size - 1] = edge;
  y[size - 1] = 0;
  const Stencil limit{series.radii(), limit_depths, n_grown - n_stencil, n_stencil};
  const Stencil growth{x, y, 0, size};
  for (Index k = 0; k + 1 < size; ++k) {
    const double middle = (x[k] + x[k + 1]) / 2;
    if (std::abs(growth(middle)) > limit(middle)) return std::nullopt;
  }
  const Eigen::VectorXd depths_before = depths.head(n_before);
  auto force = force_of(series.integral(depths_before, before, turning));
  force.value += series.force_per_radius() * growth.integral(turning, edge);
  return force;
}

}  // namespace

FrictionForce friction_force(const PunchSeries& series, const SlipZones& zones, const TouchingRings& touching,
                             const Eigen::VectorXd& limit_depths, double limit_force) {
  if (const auto force = force_of_growing_contact(series, zones, touching, limit_depths)) return *force;
  const auto& labels = zones.labels();
  const Index n_pressed = std::find(labels.begin(), labels.end(), SlipZones::free) - labels.begin();
  const auto slip = zones.slip().begin();
  if (n_pressed == 0 || n_pressed == series.radii().size()) return force_of(series.integral(zones.depths(), labels));
  const signed char outermost = slip[n_pressed - 1];
  Index n_stuck = n_pressed;
  while (n_stuck > 0 && outermost != 0 && slip[n_stuck - 1] == outermost) --n_stuck;
  if (n_stuck == 0) return {outermost * limit_force};
  const Eigen::VectorXd depths = at_own_radii(series, touching, labels, zones.depths());
  const Eigen::VectorXd held =
      at_own_radii(series, touching, zones.held_labels(), zones.held_depths()).array() + zones.depths()[0];
  const auto against = [&](int direction) {
    return held_reserve(series, zones, (limit_depths - direction * depths).head(n_pressed),
                        limit_depths - direction * held, n_stuck);
  };
  const auto force = [&](int direction, const HeldReserve& reserve, double end) {
    const auto left = force_of(series.integral(reserve.reserve, reserve.zones, end));
    return FrictionForce{direction * (limit_force - left.value), left.uncertainty};
  };
  if (outermost != 0) {
    const auto reserve = against(outermost);
    return reserve.end ? force(outermost, reserve, *reserve.end) : force_of(series.integral(depths, labels));
  }
  // Slip has begun outside the middle of the last ring, in one direction; beyond the edge of the contact there is none.
  const auto forward = against(1), backward = against(-1);
  const bool is_forward = forward.end && !(backward.end && *backward.end < *forward.end);
  const auto& slipping = is_forward ? forward : backward;
  if (slipping.end && *slipping.end < touching.contact_radius)
    return force(is_forward ? 1 : -1, slipping, *slipping.end);
  return force_of(series.integral(depths, labels));
}

}  // namespace fretval::fem
