#include "comparison/verification/tolerance/tolerance_grid.h"

#include <cmath>

#include "comparison/accuracy/compared_quantities.h"

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

/// What is to be timed for a case: the grid, and what its records came to.
std::vector<Resolution> settings_of(const PreparedCase& prepared, const std::vector<ToleranceRecord>& records) {
  auto settings = grid_of_settings(prepared.fem.relaxation.has_memory());
  for (const auto& record : records)
    if (record.name == prepared.scene.name)
      settings.insert(settings.end(), record.economised.resolutions.begin(), record.economised.resolutions.end());
  return settings;
}

std::vector<std::vector<GridPoint>> grid_points(const std::vector<PreparedCase>& cases,
                                                const std::vector<ToleranceRecord>& records) {
  std::vector<Probe> probes;
  std::vector<std::pair<std::size_t, std::size_t>> places;
  std::vector<std::vector<GridPoint>> points(cases.size());
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const auto settings = settings_of(cases[c], records);
    points[c].resize(settings.size());
    for (std::size_t s = 0; s < settings.size(); ++s) {
      probes.push_back({&cases[c].scene, at_resolution(cases[c].fem, settings[s])});
      places.emplace_back(c, s);
    }
  }
  run_probes(
      probes, [](const BodySpecification& s) { return condensed(make_timed_body(s)); },
      [&](std::size_t i, ProbeAnswer&& answer) {
        const auto [c, s] = places[i];
        points[c][s] = {probes[i].fem.resolution, seconds_alone(answer),
                        answer.failure.empty() ? measures_of(answer.fe, cases[c].fem.units) : Measures{}};
      },
      Schedule::exclusive);
  return points;
}

/// Of the resolutions that a record came to, in the order in which settings_of lists them.
double take_seconds(std::vector<GridPoint>::const_iterator& point, const Economised& economised) {
  double seconds = 0;
  for (std::size_t k = 0; k < economised.resolutions.size(); ++k) seconds += (point++)->seconds;
  return seconds;
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
  const auto points = grid_points(cases, records);
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const auto wanted = measures_of(exact[c], cases[c].fem.units, cases[c].fem.worn_edge.has_value());
    const auto end_of_grid =
        points[c].begin() + static_cast<std::ptrdiff_t>(grid_of_settings(cases[c].fem.relaxation.has_memory()).size());
    auto economised = end_of_grid;
    for (auto& record : records) {
      if (record.name != cases[c].scene.name) continue;
      record.in_grid = true;
      record.economised.seconds = take_seconds(economised, record.economised);
      for (auto point = points[c].begin(); point != end_of_grid; ++point)
        if (meets(point->measures, wanted, tolerances_of(record.tolerance)) &&
            (!record.cheapest || point->seconds < record.cheapest->seconds))
          record.cheapest = Cheapest{point->resolution, point->seconds};
    }
  }
}

}  // namespace fretval
