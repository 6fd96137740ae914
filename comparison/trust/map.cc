#include "comparison/trust/map.h"

#include <fmt/format.h>

#include <cmath>
#include <mutex>
#include <stdexcept>

#include "comparison/accuracy/error_bars.h"
#include "comparison/accuracy/error_budget.h"
#include "comparison/accuracy/fe_readings.h"
#include "comparison/accuracy/prepared_case.h"
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

/// Few rings where pressure and friction are coupled, whose steps take longest. Micro-slip moves an edge by so little
/// that it has to die out further than a single case asks for.
Resolution resolution_of(const PreparedCase& prepared, bool coupled) {
  auto resolution = prepared.fem.resolution;
  resolution.elements_per_radius = coupled ? 48 : 96;
  resolution.steps_per_cycle = coupled ? 72 : 144;
  resolution.n_angles = 8;
  resolution.periodicity /= 10;
  return resolution;
}

/// A case with the full contact, and the same with the ring contact.
struct Pair {
  PreparedCase full, on_rings;
};

Pair pair_of(const Case& input) {
  auto of_one_direction = input;
  of_one_direction.contact = {};
  return {prepare({input}).front(), prepare({of_one_direction}).front()};
}

Quantities changes_at(const Pair& pair, const Resolution& resolution, BodyStore& bodies) {
  const auto readings = [&](const PreparedCase& prepared) {
    return readings_of(compute_case(prepared.fem, resolution, bodies), prepared.fem.units);
  };
  const auto full = readings(pair.full), on_rings = readings(pair.on_rings);
  Quantities changes;
  for (const auto quantity : mapped_quantities) {
    const auto more = full.find(quantity), less = on_rings.find(quantity);
    if (more == full.end() || less == on_rings.end()) continue;
    if (const auto& of_full = more->second.value, &of_rings = less->second.value; of_full && of_rings && *of_rings > 0)
      changes[quantity] = *of_full / *of_rings - 1;
  }
  return changes;
}

/// Bars of the changes. Of the radius of a zone that has few of the fewest rings, these say nothing.
ErrorBudget bars_of(std::vector<Variant> variants, const Resolution& finest,
                    const std::map<Resolution, Quantities>& known, const FemCase& fem, const Coordinates& at) {
  constexpr double enough_rings_of_a_zone = 4;
  const int fewest_rings = variants.back().resolution.elements_per_radius;
  const auto has_few = [&](const std::optional<double>& c) { return c && *c * fewest_rings < enough_rings_of_a_zone; };
  auto bars = error_budget(finest, variants, known, {}, needs_of(fem));
  variants.pop_back();
  auto without_fewest = error_budget(finest, variants, known, {}, needs_of(fem));
  for (const auto& [quantity, c] : {std::pair(Quantity::stick_radius_first_slip, at.first_slip),
                                    std::pair(Quantity::stick_radius_shakedown, at.shakedown)})
    if (has_few(c) && bars.count(quantity) > 0) bars[quantity] = without_fewest.at(quantity);
  return bars;
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
  const auto& scene = planned.scene;
  const auto input = case_of(scene);
  auto point = point_by_mdr(planned, input);
  const auto pair = pair_of(input);
  const auto finest = with_steps(with_rings(resolution_of(pair.full, scene.coupled), fineness), fineness),
             quick = with_steps(finest, 0.5), both = with_rings(quick, 0.5), more_angles = with_angles(both, 4);
  auto less_settled = both;
  less_settled.periodicity *= 10;
  const std::vector<Variant> variants{{ErrorSource::time_step, quick, finest},
                                      {ErrorSource::time_step, with_steps(finest, 0.25), finest},
                                      {ErrorSource::angles, with_angles(both, 2), more_angles},
                                      {ErrorSource::angles, both, more_angles},
                                      {ErrorSource::rings, both, quick},
                                      {ErrorSource::rings, with_rings(quick, 0.25), quick}};
  std::map<Resolution, Quantities> known;
  for (const auto& variant : variants)
    for (const auto& resolution : {variant.reference, variant.resolution})
      if (known.count(resolution) == 0) known[resolution] = changes_at(pair, resolution, bodies);
  const auto loose = changes_at(pair, less_settled, bodies);
  auto bars = bars_of(variants, finest, known, pair.full.fem, point.at);
  for (auto& [quantity, bar] : bars) {
    constexpr double all_of_it = 1;  // a bar of what MDR has: nothing is known then
    if (!(bar.total() < all_of_it) || loose.count(quantity) == 0) continue;
    const double unsettled = known.at(both).at(quantity) - loose.at(quantity),
                 by_angles = known.at(more_angles).at(quantity) - known.at(both).at(quantity);
    // What is left of settling is in proportion to what still changes in a cycle: a ninth of the effect of ten times
    // that change, times three for safety.
    bar.add(ErrorSource::cycles, std::abs(unsettled) / 3);
    point.changes[quantity] = {known.at(finest).at(quantity) + by_angles, bar.total()};
  }
  return point;
}

std::vector<MapPoint> computed_map(const std::vector<PlannedPoint>& planned, BodyStore& bodies,
                                   const std::function<void(const MapPoint&, std::size_t)>& done) {
  std::vector<MapPoint> points(planned.size());
  std::mutex mutex;
  std::size_t n_done = 0;
  for_each_in_parallel(planned.size(), [&](std::size_t i) {
    try {
      points[i] = computed_point(planned[i], bodies);
    } catch (const std::runtime_error& error) {  // the others are known all the same
      log::warn(fmt::format("{}, c/a = {}: {}", planned[i].map, planned[i].scene.stick_ratio, error.what()));
      points[i] = point_by_mdr(planned[i], case_of(planned[i].scene));
    }
    const std::lock_guard<std::mutex> lock(mutex);
    done(points[i], ++n_done);
  });
  return points;
}

}  // namespace fretval
