#include "mdr/profiles/profile_csv.h"

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mdr/support/checks.h"
#include "mdr/support/csv_units.h"

namespace fretval::mdr {

namespace {

void require_scan(const CsvColumns& csv, const std::string& source_name, double noise) {
  const std::vector<double>& r = csv.columns[0];
  for (std::size_t i = 0; i < r.size(); ++i) {
    const std::string radius = source_name + ", line " + std::to_string(csv.line_of_row[i]) + ": radius";
    const bool is_first = r[i] >= 0 && (i == 0 || r[i - 1] < 0);
    if (is_first && noise == 0 && r[i] != 0) reject(radius, r[i], "must be 0, the axis, if no noise is stated");
    if (i > 0 && r[i] == r[i - 1]) reject(radius, r[i], "must not be that of the row before");
    if (i > 0 && r[i] < r[i - 1])
      reject(radius, r[i], "must be greater than that of the row before, a scan outwards, or through the apex");
  }
}

ProfileRows mean_rows(const ProfileRows& scan, const std::string& source_name, double noise) {
  try {
    const MeanOfHalves mean = mean_of_halves(scan.r, scan.f);
    require_axisymmetric(mean, noise);
    return {mean.r, mean.f, mean};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(source_name + ": " + error.what());
  }
}

}  // namespace

const std::vector<WantedColumn>& profile_columns() {
  static const std::vector<WantedColumn> wanted{
      {{{"radius",
         {"r", "x", "radius", "router", "position", "pos", "distance", "abstand", "lateral*", "weg", "abszisse"},
         length_units()}}},
      {{{"height",
         {"f", "z", "h", "height*", "hoehe", "h\u00f6he", "wornd*", "profile*", "profil", "depth", "tiefe", "signal"},
         length_units()}}}};
  return wanted;
}

ProfileRows read_profile_rows(std::istream& stream, const std::string& source_name, double noise) {
  require_non_negative("noise of the profile table in m", noise);
  CsvColumns csv = read_columns(stream, source_name, profile_columns(), InOrder::yes).csv;
  require_scan(csv, source_name, noise);
  for (std::size_t column = 0; column < 2; ++column) {
    const double size = unit_of_column(csv, column, length_units(), source_name);
    for (double& length : csv.columns[column]) length *= size;
  }
  ProfileRows rows{std::move(csv.columns[0]), std::move(csv.columns[1])};
  return rows.r.front() < 0 ? mean_rows(rows, source_name, noise) : rows;
}

Profile read_profile_table(std::istream& stream, const std::string& source_name, double noise) {
  const auto rows = read_profile_rows(stream, source_name, noise);
  try {
    return tabulated(rows.r, rows.f, noise);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(source_name + ": " + error.what());
  }
}

}  // namespace fretval::mdr
