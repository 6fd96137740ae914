#include "comparison/verification/exact/exact_rows.h"

#include <map>
#include <string>

#include "comparison/support/progress.h"

namespace fretval {
namespace {

/// Rows that belong together, and about how long they take.
struct Theme {
  const char* name;
  Rows (*rows)(const Meshes&, const ExactScene&);
  double seconds;
};
constexpr Theme themes[] = {{"indentation", indentation_rows, 0.3}, {"sliding", sliding_rows, 7},
                            {"oblique loading", oblique_rows, 0.3}, {"worn edge", worn_edge_rows, 0.3},
                            {"relaxation", relaxation_rows, 1},     {"pressing", pressing_rows, 1},
                            {"periodic states", periodic_rows, 26}};
constexpr double seconds_of_meshes = 5, seconds_of_poisson_ratios = 20, seconds_of_layers = 12, seconds_of_bulk = 6;

}  // namespace

Rows exact_rows() {
  std::map<std::string, double> expected{{"meshes", seconds_of_meshes},
                                         {"Poisson's ratios", seconds_of_poisson_ratios},
                                         {"layers", seconds_of_layers},
                                         {"bulk", seconds_of_bulk}};
  for (const auto& theme : themes) expected[theme.name] = theme.seconds;
  Progress progress(expected.size(), expected);
  const auto done = [&](const std::string& part) { progress.done(part, true, part); };
  const std::vector<int> resolutions{16, 32, 64, 128};
  Rows rows;
  const auto meshes = half_space_meshes(resolutions);
  done("meshes");
  for (const auto& theme : themes) {
    append(rows, theme.rows(meshes, {}));
    done(theme.name);
  }
  append(rows, poisson_rows(resolutions, {}));
  done("Poisson's ratios");
  append(rows, layer_rows(resolutions, {}));
  done("layers");
  append(rows, bulk_rows(bulk_meshes(4), 1));
  done("bulk");
  return rows;
}

}  // namespace fretval
