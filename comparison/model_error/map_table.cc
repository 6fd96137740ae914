#include "comparison/model_error/map_table.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <utility>

#include "comparison/model_error/map_csv.h"

namespace fretval {
namespace {

constexpr std::size_t n_of_scene = 13, n_of_quantity = 3,
                      n_columns = n_of_scene + n_of_quantity * mapped_quantities.size();

std::string heads() {
  std::string text = "map,scene,friction coefficient,coupled,memory,phase [deg],Poisson ratio";
  for (const char* of_whom : {"", " own"}) text += fmt::format(",a/H{0},c/a first slip{0},c/a shakedown{0}", of_whom);
  for (const auto quantity : mapped_quantities) text += fmt::format(",{0},{0} bar,{0} own", name_of(quantity));
  return text + "\n";
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  if (!line.empty() && line.back() == ',') cells.emplace_back();
  if (cells.size() != n_columns)
    throw InputError(
        fmt::format("map of MDR's error: {} columns in \"{}\", expected {}", cells.size(), line, n_columns));
  return cells;
}

std::optional<double> number_of(const std::string& cell) {
  if (cell.empty()) return std::nullopt;
  std::size_t end = 0;
  double value = 0;
  try {
    value = std::stod(cell, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  if (end != cell.size() || !std::isfinite(value))
    throw InputError(fmt::format("map of MDR's error: \"{}\", expected a number", cell));
  return value;
}

MapPoint point_of(const std::vector<std::string>& cells) {
  const auto number = [&](std::size_t i) { return number_of(cells[i]).value_or(0); };
  MapPoint point{cells[0], {}, cells[1], number(2), number(3) != 0, number(4) != 0, {}};
  point.at.phase = number(5);
  point.at.poisson_ratio = number(6);
  point.at.radius_over_thickness = number(7);
  point.at.first_slip = number_of(cells[8]);
  point.at.shakedown = number_of(cells[9]);
  point.own = point.at;
  point.own.radius_over_thickness = number(10);
  point.own.first_slip = number_of(cells[11]);
  point.own.shakedown = number_of(cells[12]);
  for (std::size_t i = 0; i < mapped_quantities.size(); ++i) {
    const std::size_t column = n_of_scene + n_of_quantity * i;
    if (const auto value = number_of(cells[column])) point.changes[mapped_quantities[i]] = {*value, number(column + 1)};
    if (const auto own = number_of(cells[column + 2])) point.own_over_body[mapped_quantities[i]] = *own;
  }
  return point;
}

}  // namespace

const char* name_of(MapKind kind) {
  constexpr std::array names{"phase", "Poisson ratio", "layer", "layer by force"};
  return names[static_cast<std::size_t>(kind)];
}

std::optional<ModelChange> MapPoint::own_off_by(Quantity quantity) const {
  const auto change = changes.find(quantity);
  const auto ratio = own_over_body.find(quantity);
  if (change == changes.end() || ratio == own_over_body.end()) return std::nullopt;
  const double over_truth = ratio->second / (1 + change->second.value);
  return ModelChange{over_truth - 1, over_truth * change->second.bar / (1 + change->second.value)};
}

const std::vector<MapPoint>& map_points() {
  static const auto points = points_of_csv(std::string(map_csv));
  return points;
}

std::string csv_of(const std::vector<MapPoint>& points) {
  auto text = heads();
  for (const auto& point : points) {
    const auto& at = point.at;
    text += fmt::format("{},{},{:g},{:d},{:d},{:g},{:g},{:.6g},{},{},{:.6g},{},{}", point.map, point.scene,
                        point.friction_coefficient, point.coupled, point.memory, at.phase, at.poisson_ratio,
                        at.radius_over_thickness, cell(at.first_slip), cell(at.shakedown),
                        point.own.radius_over_thickness, cell(point.own.first_slip), cell(point.own.shakedown));
    for (const auto quantity : mapped_quantities) {
      const auto found = point.changes.find(quantity);
      const auto own = point.own_over_body.find(quantity);
      text +=
          found == point.changes.end() ? ",," : fmt::format(",{:.4g},{:.2g}", found->second.value, found->second.bar);
      text += own == point.own_over_body.end() ? "," : fmt::format(",{:.6g}", own->second);
    }
    text += "\n";
  }
  return text;
}

bool is_same_scene(MapPoint one, MapPoint other) {
  one.changes.clear();
  other.changes.clear();
  return csv_of({std::move(one)}) == csv_of({std::move(other)});
}

std::vector<MapPoint> points_of_csv(const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  if (!std::getline(stream, line) || line + "\n" != heads())
    throw InputError(fmt::format("map of MDR's error: heads \"{}\", expected \"{}\"", line, heads()));
  std::vector<MapPoint> points;
  while (std::getline(stream, line)) points.push_back(point_of(cells_of(line)));
  return points;
}

}  // namespace fretval
