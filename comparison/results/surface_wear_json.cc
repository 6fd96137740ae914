#include "comparison/results/surface_wear_json.h"

#include <nlohmann/json.hpp>

#include "comparison/results/wear_json.h"
#include "comparison/simulation/fem_case/resolution_json.h"
#include "comparison/support/files.h"
#include "fem/support/constants.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

ordered_json bar_of(const ProvedSurfaceWear& wear, const ErrorBar& bar, double unit) {
  return wear.is_proved ? ordered_json(bar.total() * unit) : ordered_json(nullptr);
}

}  // namespace

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
