#include "comparison/tolerance_grid.h"

#include <cmath>

#include "comparison/measures.h"

namespace fretval {
namespace {

struct GridPoint {
  Resolution resolution;
  double seconds;
  Measures measures;  ///< empty: the numerics failed
};

Resolution setting(unsigned rings, unsigned degree, double growth, double far_radius, int steps, bool memory) {
  Resolution r = resolution_for(steps <= 24 ? 1e-2 : steps <= 48 ? 1e-3 : 1e-4, memory);
  r.elements_per_radius = rings;
  r.degree = degree;
  r.growth = growth;
  r.far_radius = far_radius;
  r.steps_per_cycle = steps;
  return r;
}

/// Time steps that go with a number of rings: neither should be much finer than the other.
std::vector<int> steps_for(unsigned rings) {
  if (rings <= 16) return {12, 24};
  if (rings <= 32) return {24, 48};
  return {48, 96};
}

bool meets(const Measures& measures, const Measures& exact, const Tolerances& tolerances) {
  for (const auto& [quantity, value] : exact) {
    const auto found = measures.find(quantity);
    if (found == measures.end() || !(std::abs(found->second - value) <= tolerance_of(tolerances, quantity)))
      return false;
  }
  return true;
}

std::vector<std::vector<GridPoint>> grid_points(const std::vector<PreparedCase>& cases) {
  const std::size_t n_settings = grid_of_settings().size();
  std::vector<Probe> probes;
  for (const auto& prepared : cases)
    for (const auto& resolution : grid_of_settings(prepared.fem.relaxation.has_memory()))
      probes.push_back({&prepared.scene, at_resolution(prepared.fem, resolution)});
  std::vector<std::vector<GridPoint>> points(cases.size(), std::vector<GridPoint>(n_settings));
  run_probes(
      probes, make_timed_body,
      [&](std::size_t i, ProbeAnswer&& answer) {
        const std::size_t c = i / n_settings;
        points[c][i % n_settings] = {probes[i].fem.resolution, seconds_alone(answer),
                                     answer.failure.empty() ? measures_of(answer.fe, cases[c].fem.units) : Measures{}};
      },
      Schedule::exclusive);
  return points;
}

}  // namespace

std::vector<Resolution> grid_of_settings(bool memory) {
  std::vector<Resolution> settings;
  for (const unsigned rings : {8U, 12U, 16U, 24U, 32U, 48U, 64U, 96U})
    for (const int steps : steps_for(rings)) {
      if (rings <= 16) settings.push_back(setting(rings, 2, 0.6, 6, steps, memory));
      if (rings <= 48) settings.push_back(setting(rings, 2, 0.3, 12, steps, memory));
      settings.push_back(setting(rings, 3, 0.6, 12, steps, memory));
      if (rings >= 24) settings.push_back(setting(rings, 3, 0.3, 25, steps, memory));
    }
  return settings;
}

void search_grid(const std::vector<PreparedCase>& cases, const std::vector<MdrAnswer>& exact,
                 std::vector<ToleranceRecord>& records) {
  const auto points = grid_points(cases);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const auto wanted = measures_of(exact[c], cases[c].fem.units, cases[c].fem.worn_edge.has_value());
    for (auto& record : records) {
      if (record.name != cases[c].scene.name) continue;
      record.in_grid = true;
      for (const auto& point : points[c])
        if (meets(point.measures, wanted, tolerances_of(record.tolerance)) &&
            (!record.cheapest || point.seconds < record.cheapest->seconds))
          record.cheapest = Cheapest{point.resolution, point.seconds};
    }
  }
}

}  // namespace fretval
