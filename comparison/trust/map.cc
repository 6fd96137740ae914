#include "comparison/trust/map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "comparison/accuracy/error_bars.h"
#include "comparison/accuracy/error_budget.h"
#include "comparison/accuracy/fe_readings.h"
#include "comparison/accuracy/prepared_case.h"
#include "comparison/accuracy/refinement.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/simulation/compute_case.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"
#include "comparison/trust/ladder.h"

namespace fretval {
namespace {

void plan_grid(MapKind kind, const std::vector<double>& ratios, const std::vector<double>& values,
               void (*set)(MapScene&, double), std::vector<PlannedPoint>& planned) {
  for (const double value : values)
    for (const double ratio : ratios) {
      MapScene scene{ratio};
      set(scene, value);
      planned.push_back({name_of(kind), "parabola; elastic; k = 0.5", scene});
    }
}

/// Plans points of what the maps do not show, one at a time and some at once.
void plan_elsewhere(std::vector<PlannedPoint>& planned) {
  const auto add = [&](const char* title, const MapScene& scene) { planned.push_back({"elsewhere", title, scene}); };
  constexpr double between = 0.58, larger = 0.75, of_cone = 5;
  MapScene scene{between, 75};
  add("parabola; elastic; k = 0.5; between the points", scene);
  scene.cone_angle = of_cone;
  add("cone; elastic; k = 0.5", scene);
  scene = {larger, 75};
  scene.viscoelastic = true;
  add("parabola; standard solid; k = 0.5", scene);
  for (const double ratio : {0.1, 1.5}) {
    scene = {between, 75};
    scene.amplitude_ratio = ratio;
    add(ratio < 1 ? "parabola; elastic; k = 0.1" : "parabola; elastic; k = 1.5", scene);
  }
  const auto add_coupled = [&](const MapScene& of_body) {
    for (const double mu : {0.2, 1.0}) {
      scene = of_body;
      scene.friction_coefficient = mu;
      add("parabola; elastic; k = 0.5", scene);
    }
    scene = of_body;
    scene.phase = 0;
    add("parabola; elastic; k = 0.5; another phase", scene);
    scene = of_body;
    scene.amplitude_ratio = 0.1;
    add("parabola; elastic; k = 0.1", scene);
    scene = of_body;
    scene.cone_angle = of_cone;
    add("cone; elastic; k = 0.5", scene);
  };
  MapScene coupled{between};
  coupled.coupled = true;
  coupled.poisson_ratio = 0.35;
  add_coupled(coupled);
  coupled = {larger};
  coupled.coupled = true;
  coupled.radius_over_thickness = 0.7;
  add_coupled(coupled);
}

/// Rings that a zone of which a radius is read, or the annulus that slips around it, has at least: four of the fewest
/// rings of a bar.
constexpr double rings_of_a_zone = 16;

/// Rings graded to the slip annulus or to the smaller stick zone that MDR has, if equal rings resolve one of them by
/// fewer. Coupling moves the ends of both, so that the fine rings go on beyond them.
std::optional<Focus> focus_on_zone(const Coordinates& at, double rings) {
  if (!at.shakedown) return {};
  const double annulus = 1 - *at.shakedown, zone = std::min(*at.shakedown, at.first_slip.value_or(1));
  if (annulus * rings < rings_of_a_zone) return Focus{std::max(0.0, 1 - 2 * annulus), 1, annulus / rings_of_a_zone};
  if (zone * rings < rings_of_a_zone) return Focus{0, 1.5 * zone, zone / rings_of_a_zone};
  return {};
}

/// Where a point is computed first: in few steps where pressure and friction are coupled, which take longest.
/// Micro-slip moves an edge by so little that it has to die out further than a single case asks for.
Resolution first_resolution(const FemCase& fem, const PlannedPoint& planned, const Coordinates& at, double fineness) {
  auto resolution = fem.resolution;
  resolution.elements_per_radius = 48;
  resolution.steps_per_cycle = planned.scene.coupled ? 72 : 144;
  resolution.n_angles = 8;
  resolution.periodicity /= 10;
  resolution = with_steps(with_rings(resolution, fineness), fineness);
  resolution.focus = focus_on_zone(at, resolution.elements_per_radius);
  return resolution;
}

Case without_full_contact(Case input) {
  input.contact = {};
  return input;
}

/// The changes of a scene from the ring contact to the full contact, at each resolution computed once. They are means
/// over places of the edges of the zones in their rings: with the place all that is read goes to and fro, by an error
/// that falls with no order of the rings.
class SceneChanges {
 public:
  SceneChanges(const Case& input, const Coordinates& at, BodyStore& bodies)
      : full_(prepare({input}).front()),
        on_rings_(prepare({without_full_contact(input)}).front()),
        at_(at),
        bodies_(bodies) {}

  [[nodiscard]] const FemCase& fem() const { return full_.fem; }
  [[nodiscard]] const std::map<Resolution, Quantities>& known() const { return known_; }

  const Quantities& at(const Resolution& resolution) {
    const auto [place, is_new] = known_.try_emplace(resolution);
    if (is_new) place->second = mean_over_places(resolution);
    return place->second;
  }

 private:
  /// Only of what is known at all places.
  [[nodiscard]] Quantities mean_over_places(const Resolution& resolution) const {
    // A coupled contact is computed at two places each time (half_a_ring_away).
    const unsigned n_places = full_.fem.full.coupled ? 1 : 8;
    auto elsewhere = resolution;
    std::map<Quantity, unsigned> n_known;
    Quantities means;
    for (unsigned k = 0; k < n_places; ++k) {
      for (const auto& [quantity, change] : computed(elsewhere)) {
        means[quantity] += change / n_places;
        ++n_known[quantity];
      }
      elsewhere.edge_before_node += rings_per_ring_of_zones(resolution) / n_places;
    }
    for (const auto& [quantity, n] : n_known)
      if (n < n_places) means.erase(quantity);
    return means;
  }

  /// By how many rings the edge that lies at its place in a ring (Resolution::edge_before_node) moves while the edges
  /// of the zones move by one.
  [[nodiscard]] double rings_per_ring_of_zones(const Resolution& resolution) const {
    const double outer = resolution.focus ? resolution.focus->outer : 1, shakedown = at_.shakedown.value_or(outer);
    return outer / ((shakedown + at_.first_slip.value_or(shakedown)) / 2);
  }

  [[nodiscard]] Quantities computed(const Resolution& resolution) const {
    const auto readings = [&](const PreparedCase& prepared) {
      return readings_of(compute_case(prepared.fem, resolution, bodies_), prepared.fem.units);
    };
    const auto full = readings(full_), on_rings = readings(on_rings_);
    Quantities changes;
    for (const auto quantity : mapped_quantities) {
      const auto more = full.find(quantity), less = on_rings.find(quantity);
      if (more == full.end() || less == on_rings.end()) continue;
      if (const auto& of_full = more->second.value, &of_rings = less->second.value;
          of_full && of_rings && *of_rings > 0)
        changes[quantity] = *of_full / *of_rings - 1;
    }
    return changes;
  }

  PreparedCase full_, on_rings_;
  Coordinates at_;
  BodyStore& bodies_;
  std::map<Resolution, Quantities> known_;
};

struct ChangesWithBars {
  std::map<Quantity, ModelChange> changes;
  ErrorBudget bars;
};

ChangesWithBars with_bars(SceneChanges& changes, const Resolution& finest) {
  const auto quick = with_steps(finest, 0.5), both = with_rings(quick, 0.5), more_angles = with_angles(both, 4);
  auto less_settled = both;
  less_settled.periodicity *= 10;
  const std::vector<Variant> variants{{ErrorSource::time_step, quick, finest},
                                      {ErrorSource::time_step, with_steps(finest, 0.25), finest},
                                      {ErrorSource::angles, with_angles(both, 2), more_angles},
                                      {ErrorSource::angles, both, more_angles},
                                      {ErrorSource::rings, both, quick},
                                      {ErrorSource::rings, with_rings(quick, 0.25), quick}};
  for (const auto& variant : variants)
    for (const auto& resolution : {variant.reference, variant.resolution}) changes.at(resolution);
  const auto &loose = changes.at(less_settled), &settled = changes.at(both);
  ChangesWithBars found{{}, error_budget(finest, variants, changes.known(), {}, needs_of(changes.fem()))};
  for (auto& [quantity, bar] : found.bars) {
    constexpr double all_of_it = 1;  // a bar of what MDR has: nothing is known then
    if (!(bar.total() < all_of_it) || loose.count(quantity) == 0) continue;
    const double unsettled = settled.at(quantity) - loose.at(quantity),
                 by_angles = changes.at(more_angles).at(quantity) - settled.at(quantity);
    // What is left of settling is in proportion to what still changes in a cycle: a ninth of the effect of ten times
    // that change, times three for safety.
    bar.add(ErrorSource::cycles, std::abs(unsettled) / 3);
    found.changes[quantity] = {changes.at(finest).at(quantity) + by_angles, bar.total()};
  }
  return found;
}

constexpr int most_refinements = 4;

/// How far MDR over a half-space is off or, where that has no such quantity, MDR over the body; by everything where
/// nothing is known.
ModelChange off_by(const MapPoint& point, Quantity quantity) {
  if (const auto own = point.own_off_by(quantity)) return *own;
  const auto change = point.changes.find(quantity);
  return change == point.changes.end() ? ModelChange{1, 1} : change->second;
}

/// What adds most to the bars that are wider than a tenth of how far MDR is off; empty: none is. Errors of MDR that
/// nobody would notice may have wide bars.
std::optional<ErrorSource> what_widens(const MapPoint& point, const ErrorBudget& bars) {
  constexpr double least_error = 1e-3, narrow = 0.1;
  std::map<ErrorSource, double> widened;
  for (const auto& [quantity, bar] : bars) {
    const auto [value, width] = off_by(point, quantity);
    const double error = std::abs(value);
    if (error < least_error || width <= narrow * error) continue;
    for (const auto& share : bar.shares) widened[share.source] += share.estimate / error;
  }
  const auto most = std::max_element(widened.begin(), widened.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == widened.end() ? std::nullopt : std::optional(most->first);
}

}  // namespace

std::vector<PlannedPoint> planned_points() {
  std::vector<PlannedPoint> planned;
  plan_grid(
      MapKind::phase, {0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.95}, {0, 30, 60, 90, 120, 150},
      [](MapScene& scene, double value) { scene.phase = value; }, planned);
  plan_grid(
      MapKind::poisson_ratio, {0.2, 0.4, 0.6, 0.8, 0.95}, {0, 0.15, 0.3, 0.4, 0.5},
      [](MapScene& scene, double value) {
        scene.poisson_ratio = value;
        scene.coupled = value < 0.5;
      },
      planned);
  plan_grid(
      MapKind::layer, {0.2, 0.4, 0.6, 0.8, 0.95}, {0, 0.25, 0.5, 1, 2},
      [](MapScene& scene, double value) {
        scene.radius_over_thickness = value;
        scene.coupled = value > 0;
      },
      planned);
  plan_grid(
      MapKind::layer_by_force, {0.2, 0.4, 0.6, 0.8, 0.95}, {0, 0.5, 1, 2},
      [](MapScene& scene, double value) {
        scene.radius_over_thickness = value;
        scene.by_normal_force = true;
        scene.coupled = value > 0;
      },
      planned);
  plan_elsewhere(planned);
  return planned;
}

MapPoint point_by_mdr(const PlannedPoint& planned, const Case& input) {
  auto of_one_direction = input;
  of_one_direction.contact = {};
  const auto over_body = mdr_case(of_one_direction), over_half_space = mdr_case(case_for_mdr(input));
  const auto answer = mdr_answer_with_cycle(over_body, mdr_normal_response(over_body)),
             own = mdr_answer_with_cycle(over_half_space, mdr_normal_response(over_half_space));
  const auto& scene = planned.scene;
  MapPoint point{planned.map,
                 coordinates_of(input, answer),
                 planned.title,
                 scene.friction_coefficient,
                 scene.coupled,
                 scene.viscoelastic,
                 {}};
  point.own = coordinates_of(input, own);
  const auto values = readings_of(answer), own_values = readings_of(own);
  for (const auto quantity : mapped_quantities) {
    const auto one = values.find(quantity), other = own_values.find(quantity);
    if (one == values.end() || other == own_values.end()) continue;
    if (const auto& here = one->second.value, &there = other->second.value; here && there && *here > 0)
      point.own_over_body[quantity] = *there / *here;
  }
  return point;
}

MapPoint computed_point(const PlannedPoint& planned, BodyStore& bodies, double fineness) {
  const auto input = case_of(planned.scene);
  auto point = point_by_mdr(planned, input);
  SceneChanges changes(input, point.at, bodies);
  auto resolution = first_resolution(changes.fem(), planned, point.at, fineness);
  auto found = with_bars(changes, resolution);
  point.changes = found.changes;
  for (int n = 0; n < most_refinements && fineness >= 1; ++n) {
    const auto source = what_widens(point, found.bars);
    const auto finer = source ? refined(resolution, *source) : std::nullopt;
    if (!finer) break;
    try {
      found = with_bars(changes, *finer);
    } catch (const std::runtime_error& error) {
      log::warn(fmt::format("{}, c/a = {}: a refinement is taken back: {}", planned.map, planned.scene.stick_ratio,
                            error.what()));
      break;
    }
    point.changes = found.changes;
    resolution = *finer;
  }
  return point;
}

std::vector<MapPoint> computed_map(const std::vector<PlannedPoint>& planned, const std::vector<MapPoint>& known,
                                   BodyStore& bodies,
                                   const std::function<void(const std::vector<MapPoint>&, std::size_t)>& done) {
  std::vector<MapPoint> points(planned.size());
  for_each_in_parallel(planned.size(), [&](std::size_t i) {
    points[i] = point_by_mdr(planned[i], case_of(planned[i].scene));
    for (const auto& point : known)
      if (is_same_scene(point, points[i])) points[i].changes = point.changes;
  });
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].changes.empty()) missing.push_back(i);
  std::mutex mutex;
  for_each_in_parallel(missing.size(), [&](std::size_t n) {
    const auto i = missing[n];
    MapPoint point;
    try {
      point = computed_point(planned[i], bodies);
    } catch (const std::runtime_error& error) {  // the others are known all the same
      log::warn(fmt::format("{}, c/a = {}: {}", planned[i].map, planned[i].scene.stick_ratio, error.what()));
    }
    const std::lock_guard<std::mutex> lock(mutex);
    points[i].changes = std::move(point.changes);
    done(points, i);
  });
  return points;
}

}  // namespace fretval
