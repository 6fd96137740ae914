#include "comparison/simulation/fem_case/worn_before.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "comparison/data/table_units.h"
#include "mdr/profiles/profile_csv.h"
#include "mdr/support/csv.h"

namespace fretval {
namespace {

void require_rings(const std::string& table, const mdr::CsvColumns& csv) {
  const auto &radii = csv.columns[0], &depths = csv.columns[1];
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double before = i == 0 ? 0 : radii[i - 1];
    if (!(radii[i] > before))
      throw InputError(fmt::format("{}, line {}: the outer radius {:g}; must be greater than that before, {:g}", table,
                                   csv.line_of_row[i], radii[i], before));
    if (depths[i] < 0)
      throw InputError(
          fmt::format("{}, line {}: the worn depth {:g}; must not be negative", table, csv.line_of_row[i], depths[i]));
  }
}

}  // namespace

WornBefore worn_by_heights(const std::string& table, const Units& units, const std::function<double(double)>& profile,
                           double tolerance) {
  constexpr double nothing = 1e-6;  // of the largest indentation, as in the course of wear
  std::ifstream stream(table);
  std::vector<double> radii, depths, kinks;
  input_from(table, [&] {
    const auto rows = mdr::read_profile_rows(stream, table);
    for (std::size_t i = 0; i < rows.r.size(); ++i) {
      const double r = rows.r[i] / units.length, depth = rows.f[i] / units.depth - profile(r);
      if (depth < -tolerance)
        throw InputError(
            fmt::format("{}: the height {:g} m at r = {:g} m is {:.2g} m below that of the indenter; "
                        "must be that of the same indenter, worn",
                        table, rows.f[i], rows.r[i], -depth * units.depth));
      radii.push_back(r);
      depths.push_back(depth > nothing ? depth : 0);
    }
  });
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (i > 0 && depths[i - 1] == 0) kinks.push_back((radii[i - 1] + radii[i]) / 2);
    kinks.push_back(radii[i]);
  }
  return {[radii, depths](double r) {
            const auto outer = std::upper_bound(radii.begin(), radii.end(), r) - radii.begin();
            if (outer == static_cast<std::ptrdiff_t>(radii.size())) return 0.0;
            const auto k = static_cast<std::size_t>(outer);
            if (depths[k - 1] == 0) return r < (radii[k - 1] + radii[k]) / 2 ? 0 : depths[k];
            return depths[k - 1] + (depths[k] - depths[k - 1]) * (r - radii[k - 1]) / (radii[k] - radii[k - 1]);
          },
          std::move(kinks)};
}

WornBefore worn_by_rings(const std::string& table, const Units& units) {
  std::ifstream stream(table);
  std::vector<double> radii, depths;
  input_from(table, [&] {
    auto chosen = mdr::read_columns(stream, table, mdr::profile_columns(), mdr::InOrder::yes);
    require_rings(table, chosen.csv);
    take_into_si(table, mdr::profile_columns(), chosen);
    for (const double r : chosen.csv.columns[0]) radii.push_back(r / units.length);
    for (const double depth : chosen.csv.columns[1]) depths.push_back(depth / units.depth);
  });
  return {[radii, depths](double r) {
            const auto ring = std::upper_bound(radii.begin(), radii.end(), r) - radii.begin();
            return ring == static_cast<std::ptrdiff_t>(radii.size()) ? 0.0 : depths[static_cast<std::size_t>(ring)];
          },
          radii};
}

}  // namespace fretval
