#include "comparison/model_error/model_error.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace fretval {
namespace {

constexpr double no_volume_change = 0.5, half_turn = 180;

using Rows = std::map<double, std::vector<Node>>;

/// Nodes over the stick ratio, by the other coordinate of a map. seen: the coordinate and the node of a point; empty:
/// none.
template <class Seen>
Rows rows_of(const std::vector<MapPoint>& points, MapKind kind, Seen seen) {
  Rows rows;
  for (const auto& point : points) {
    if (point.map != name_of(kind)) continue;
    if (const std::optional<std::pair<double, Node>> one = seen(point)) rows[one->first].push_back(one->second);
  }
  for (auto& [value, nodes] : rows)
    std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.at < b.at; });
  if (kind == MapKind::phase && rows.count(0) > 0) rows[half_turn] = rows.at(0);
  return rows;
}

/// Slip takes a depth g ~ c² off the zone that sticks, so a share of c grows as c²/a² falls: what is interpolated is
/// the share times that.
Node node_at(double ratio, double value, double bar) {
  return {ratio, ratio * ratio * value, ratio * ratio * bar};
}

std::optional<Interpolated> interpolated_in(const Rows& rows, double ratio, double value) {
  std::vector<Node> across;  // without a row in between that does not reach the ratio
  for (const auto& [at, nodes] : rows)
    if (const auto one = interpolated(nodes, ratio))
      across.push_back({at, one->value, one->uncertainty});
    else if (at < value)
      across.clear();
    else
      break;
  auto result = interpolated(across, value);
  if (result) result = Interpolated{result->value / (ratio * ratio), result->uncertainty / (ratio * ratio)};
  return result;
}

/// Difference of a change on a map from that on its side of a half-space with nu = 1/2.
std::optional<Interpolated> added(const std::vector<MapPoint>& points, MapKind kind, double side, double value,
                                  Quantity quantity, double ratio) {
  const auto with = change_on_map(points, kind, quantity, ratio, value),
             without = change_on_map(points, kind, quantity, ratio, side);
  if (!with || !without) return std::nullopt;
  return Interpolated{with->value - without->value, with->uncertainty + without->uncertainty};
}

/// Why the maps do not have a case; empty: they may.
std::string outside_because_of(const Case& input) {
  const auto& motion = input.motion;
  const auto& body = input.body;
  if (input.contact.is_full()) return "finite elements have computed it";
  if (motion.path || !motion.phase || !motion.normal_harmonics.empty() || !motion.tangential_harmonics.empty() ||
      motion.normal_frequency != motion.tangential_frequency)
    return "the maps are of one harmonic in each direction, of one frequency";
  if (motion.tangential_amplitude == 0 || motion.tangential_force)
    return "the maps are of a prescribed tangential displacement";
  if (motion.normal_force && (!body.is_half_space() || input.elastomer.poisson_ratio != no_volume_change))
    return "under a normal force the maps do not have pressure and friction coupled";
  if (input.wear == Case::Wear::limiting) return "the maps are of an unworn indenter";
  if (input.indenter.flat_radius > 0) return "the maps are of an indenter without a flat face";
  if (body.shape != Case::Body::Shape::half_space && (body.shape != Case::Body::Shape::layer || !body.is_bonded))
    return "the maps are of half-spaces and bonded layers";
  if (!body.is_half_space() && input.elastomer.poisson_ratio != no_volume_change)
    return "the maps have no layer of a compressible elastomer";
  return "";
}

bool couples(const Coordinates& at) {
  return at.poisson_ratio != no_volume_change || at.radius_over_thickness > 0;
}

/// The spread over the maps of the program, which no case changes: found once.
double known_spread(Quantity quantity, const Elsewhere& where) {
  using Key = std::tuple<Quantity, bool, bool>;
  static const auto spreads = [] {
    std::map<Key, double> all;
    for (const auto one : mapped_quantities)
      for (const auto& [coupled, memory] : {Elsewhere{false, false}, {true, false}, {false, true}})
        all[{one, coupled, memory}] = spread_elsewhere(map_points(), one, {coupled, memory});
    return all;
  }();
  return spreads.at({quantity, where.coupled, where.memory});
}

}  // namespace

std::optional<double> stick_ratio_for(const Coordinates& at, Quantity quantity) {
  return quantity == Quantity::stick_radius_first_slip ? at.first_slip : at.shakedown;
}

double value_on(MapKind kind, const Coordinates& at) {
  switch (kind) {
    case MapKind::phase:
      return at.phase;
    case MapKind::poisson_ratio:
      return at.poisson_ratio;
    default:
      return at.radius_over_thickness;
  }
}

std::optional<Interpolated> change_on_map(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity,
                                          double stick_ratio, double value) {
  const auto rows = rows_of(points, kind, [&](const MapPoint& point) -> std::optional<std::pair<double, Node>> {
    const auto ratio = stick_ratio_for(point.at, quantity);
    const auto change = point.changes.find(quantity);
    if (!ratio || change == point.changes.end()) return std::nullopt;
    return std::pair(value_on(kind, point.at), node_at(*ratio, change->second.value, change->second.bar));
  });
  return interpolated_in(rows, stick_ratio, value);
}

std::optional<Interpolated> own_off_by_on_map(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity,
                                              double stick_ratio, double value) {
  const auto rows = rows_of(points, kind, [&](const MapPoint& point) -> std::optional<std::pair<double, Node>> {
    const auto ratio = stick_ratio_for(point.own, quantity);
    const auto off = point.own_off_by(quantity);
    if (!ratio || !off) return std::nullopt;
    const double truth = 1 / (1 + off->value);  // over MDR's value
    return std::pair(value_on(kind, point.own), node_at(*ratio, truth - 1, truth * truth * off->bar));
  });
  auto truth = interpolated_in(rows, stick_ratio, value);
  if (!truth || truth->value <= -1) return std::nullopt;
  const double mdr = 1 / (1 + truth->value);
  return Interpolated{mdr - 1, mdr * mdr * truth->uncertainty};
}

std::optional<Interpolated> change_at(const std::vector<MapPoint>& points, const Coordinates& at, Quantity quantity) {
  const auto ratio = stick_ratio_for(at, quantity);
  if (!ratio) return std::nullopt;
  auto change = change_on_map(points, MapKind::phase, quantity, *ratio, at.phase);
  if (!change) return std::nullopt;
  const auto add = [&](MapKind kind, double side) {
    const auto more = added(points, kind, side, value_on(kind, at), quantity, *ratio);
    if (!more) return change.reset();
    change->value += more->value;
    change->uncertainty += more->uncertainty;
  };
  if (at.poisson_ratio != no_volume_change) add(MapKind::poisson_ratio, no_volume_change);
  if (change && at.radius_over_thickness > 0) add(MapKind::layer, 0);
  return change;
}

double spread_elsewhere(const std::vector<MapPoint>& points, Quantity quantity, const Elsewhere& where) {
  double spread = 0;
  for (const auto& point : points) {
    const auto found = point.changes.find(quantity);
    if (point.map != "elsewhere" || point.coupled != where.coupled || point.memory != where.memory ||
        found == point.changes.end())
      continue;
    const auto expected = change_at(points, point.at, quantity);
    if (!expected) continue;
    const double beyond = std::abs(found->second.value - expected->value) - found->second.bar - expected->uncertainty;
    spread = std::max(spread, beyond / std::abs(expected->value));
  }
  return spread;
}

std::optional<double> ModelErrors::good_to() const {
  std::optional<double> largest;
  for (const auto quantity : {Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown})
    if (const auto found = off_by.find(quantity); found != off_by.end())
      largest = std::max(largest.value_or(0), std::abs(found->second.value) + found->second.uncertainty);
  return largest;
}

ModelErrors model_errors_of(const Case& input, const MdrAnswer& mdr) {
  ModelErrors errors{{}, outside_because_of(input)};
  if (!errors.outside.empty()) return errors;
  const auto at = coordinates_of(input, mdr);
  for (const auto quantity : mapped_quantities) {
    const auto change = change_at(map_points(), at, quantity);
    if (!change) continue;
    double spread = known_spread(quantity, {couples(at), false});
    if (input.elastomer.has_memory()) spread = std::max(spread, known_spread(quantity, {false, true}));
    spread *= std::abs(change->value);
    const double truth = 1 + change->value;
    errors.off_by[quantity] = {1 / truth - 1, (change->uncertainty + spread) / (truth * truth)};
  }
  if (!errors.good_to())
    errors.outside = "no stick radius lies between those of the maps, 0.2 to 0.95 of the contact radius";
  if (!errors.outside.empty()) errors.off_by.clear();
  return errors;
}

}  // namespace fretval
