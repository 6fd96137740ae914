#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "comparison/results/case_result.h"
#include "comparison/simulation/fem_case/resolution.h"
#include "comparison/support/files.h"
#include "comparison/support/json.h"
#include "fem/support/constants.h"

namespace fretval {

using nlohmann::ordered_json;

namespace {

ordered_json bar_of(const ProvedSurfaceWear& wear, const ErrorBar& bar, double unit) {
  return wear.is_proved ? ordered_json(bar.total() * unit) : ordered_json(nullptr);
}

std::vector<double> list(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

/// What each ring does in each step, as a text for each step: o open, s sticks, f slips forward, b slips backward.
ordered_json zones_json(const fem::WearingContact::Period& period) {
  auto steps = ordered_json::array();
  for (Eigen::Index k = 0; k < period.slip.cols(); ++k) {
    std::string text;
    for (Eigen::Index i = 0; i < period.slip.rows(); ++i) text += period.zone(i, k);
    steps.push_back(text);
  }
  return steps;
}

/// The first point at which a share of the volume is worn off.
std::size_t point_with(const fem::WearCourse& course, double share) {
  const auto& curve = course.curve;
  const double volume = share * curve.back().volume;
  const auto found = std::find_if(curve.begin(), curve.end(), [&](const auto& p) { return p.volume >= volume; });
  return static_cast<std::size_t>(std::min(found, curve.end() - 1) - curve.begin());
}

/// Some states of the course, evenly spread over the worn volume.
std::vector<std::size_t> snapshots_of(const fem::WearCourse& course) {
  constexpr int n = 8;
  std::vector<std::size_t> chosen;
  for (int i = 0; i <= n; ++i) {
    const auto k = point_with(course, static_cast<double>(i) / n);
    if (chosen.empty() || chosen.back() != k) chosen.push_back(k);
  }
  if (chosen.back() + 1 != course.curve.size()) chosen.push_back(course.curve.size() - 1);
  return chosen;
}

}  // namespace

const char* name_of(fem::WearEnd end) {
  // In the order of the enumeration.
  static constexpr std::array names{"cycles asked for", "rate fallen", "nothing left", "progressive", "contact slides"};
  return names[static_cast<std::size_t>(end)];
}

ordered_json course_json(const fem::WearCourse& course, const Units& units) {
  ordered_json json;
  for (const auto& point : course.curve) {
    json["cycles"].push_back(point.cycles);
    json["volume"].push_back(point.volume * units.volume());
    json["volume_rate"].push_back(point.volume_rate * units.volume());
    json["deepest"].push_back(point.deepest * units.depth);
    json["friction_work"].push_back(point.friction_work * units.force() * units.depth);
    json["contact_radius"].push_back(point.contact_radius * units.length);
    json["stick_radius"].push_back(point.stick_radius * units.length);
  }
  return json;
}

ordered_json to_json(const ProvedWear& wear, const Units& units) {
  const auto& course = wear.fe.course;
  auto json = course_json(course, units);
  json["distance_to_shakedown_limit"] = wear.distance_shakedown;
  json["distance_to_first_slip_limit"] = wear.distance_first_slip;
  json["r"] = list(units.length * wear.fe.centre);
  json["worn_depth"] = list(units.depth * course.worn.back());
  json["end"] = name_of(course.end);
  json["ends_in_limit"] = wear.ends_in_limit();
  json["limit_is_reached"] = wear.limits.reached;
  json["distance_to_limit"] = {{"shakedown", wear.distance_shakedown.back()},
                               {"first_slip", wear.distance_first_slip.back()}};
  json["volume_of_limit"] = wear.limits.shakedown.volume;
  json["springs_difference"] = or_null(wear.largest_springs_difference);
  json["springs_error"] = or_null(wear.springs_error);
  json["slip_is_proved"] = wear.slip_is_proved;
  json["sticks_throughout"] = wear.sticks_throughout;
  json["rate_error"] = or_null(wear.rate_error);
  json["pressed_outside"] = wear.pressed_outside;
  json["zones"] = {{"start", zones_json(course.first)}, {"end", zones_json(course.last)}};
  json["resolution"] = resolution_json(wear.resolution);
  json["cost"] = {{"seconds", wear.fe.seconds},
                  {"rings", wear.fe.centre.size()},
                  {"jumps", course.n_jumps},
                  {"largest_jump_error", course.largest_jump_error * units.depth},
                  {"cycles_stepped", course.n_cycles_stepped},
                  {"computations", wear.cost.computations},
                  {"bodies", wear.cost.bodies.all},
                  {"bodies_from_store", wear.cost.bodies.from_store}};
  return json;
}

void write_wear(const ProvedWear& wear, const Case& input, const Units& units, const std::filesystem::path& folder) {
  const auto& course = wear.fe.course;
  const Eigen::Index n = wear.fe.centre.size();
  const auto height = [&](const Eigen::VectorXd& worn) { return units.depth * (wear.fe.unworn + worn); };
  // The table of an indenter begins on the axis, where the apex has worn like the ring around it.
  const auto from_axis = [n](double at_axis, const Eigen::VectorXd& values) {
    Eigen::VectorXd all(n + 1);
    all << at_axis, values;
    return all;
  };
  const Eigen::VectorXd& worn = course.worn.back();
  constexpr int every_digit = 17;
  write_csv(folder / "worn_profile.csv", {{"r [m]", from_axis(0, units.length * wear.fe.centre)},
                                          {"f [m]", from_axis(units.depth * worn[0], height(worn))}});
  write_csv(folder / "worn_rings.csv",
            {{"r outer [m]", units.length * Eigen::Map<const Eigen::VectorXd>(wear.fe.radii.data() + 1, n)},
             {"worn depth [m]", units.depth * worn}},
            every_digit);
  std::vector<Column> columns{
      {"r [m]", units.length * wear.fe.centre},
      {"p largest at start [Pa]", units.pressure() * course.largest_pressure.front()},
      {"p largest in the middle [Pa]", units.pressure() * course.largest_pressure[point_with(course, 0.5)]},
      {"p largest at end [Pa]", units.pressure() * course.largest_pressure.back()}};
  for (const auto k : snapshots_of(course))
    columns.push_back({fmt::format("f after {:.6g} cycles [m]", course.curve[k].cycles), height(course.worn[k])});
  write_csv(folder / "wear.csv", columns);
  const auto file = std::filesystem::absolute(input.file);
  const bool began_on_heights = input.wear_kinetics && !input.wear_kinetics->profile.empty();
  if (!input.sweep && file.extension() == ".prm")
    write_file(folder / (input.name + "-worn.prm"),
               fmt::format("# {} as far as it has worn; fretval run goes on from there.\n"
                           "include {}\nsubsection Wear\n{}  set Worn rings = worn_rings.csv\nend\n",
                           input.name, file.string(), began_on_heights ? "  set Profile =\n" : ""));
}

ordered_json to_json(const ProvedSurfaceWear& wear, const Units& units) {
  const auto& course = wear.fe.course;
  const auto& sticks = wear.fe.sticks;
  const double length = units.length, volume = course.curve.back().volume * units.volume();
  auto json = course_json(course, units);
  json["end"] = name_of(course.end);
  json["sticks"] = {{"area", sticks.area * length * length},
                    {"area_bar", bar_of(wear, wear.radius, 2 * fem::pi * sticks.radius * length * length)},
                    {"radius", sticks.radius * length},
                    {"radius_bar", bar_of(wear, wear.radius, length)},
                    {"along", sticks.along * length},
                    {"along_bar", bar_of(wear, wear.along, length)},
                    {"across", sticks.across * length},
                    {"across_bar", bar_of(wear, wear.across, length)}};
  json["volume_bar"] = bar_of(wear, wear.volume, volume);
  json["limit_of_mdr"] = {{"stick_radius", wear.limit.stick_radius}, {"volume", wear.limit.volume}};
  json["resolution"] = resolution_json(wear.resolution);
  json["cost"] = {{"seconds", wear.fe.seconds},
                  {"jumps", course.n_jumps},
                  {"cycles_stepped", course.n_cycles_stepped},
                  {"computations", wear.cost.computations}};
  return json;
}

void write_surface_wear(const ProvedSurfaceWear& wear, const Units& units, const std::filesystem::path& folder) {
  const auto& fe = wear.fe;
  const Eigen::MatrixXd worn = fe.field(fe.course.worn.back()), pressure = fe.field(fe.course.last.largest_pressure);
  const auto circle = fem::whole_circle(fe.grid);
  const auto n = worn.rows() * static_cast<Eigen::Index>(circle.size());
  Eigen::VectorXd inner(n), outer(n), angle(n), before(n), after(n), largest(n);
  Eigen::Index k = 0;
  for (Eigen::Index i = 0; i < worn.rows(); ++i)
    for (const auto& [theta, kept, sign] : circle) {
      const auto ring = static_cast<std::size_t>(i);
      inner[k] = fe.radii[ring] * units.length;
      outer[k] = fe.radii[ring + 1] * units.length;
      angle[k] = theta;
      before[k] = fe.unworn[i] * units.depth;
      after[k] = (fe.unworn[i] + worn(i, kept)) * units.depth;
      largest[k++] = pressure(i, kept) * units.pressure();
    }
  write_csv(folder / "worn_surface.csv", {{"r inner [m]", inner},
                                          {"r outer [m]", outer},
                                          {"angle [rad]", angle},
                                          {"f unworn [m]", before},
                                          {"f worn [m]", after},
                                          {"p largest at end [Pa]", largest}});
}

}  // namespace fretval
