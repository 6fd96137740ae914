#include <cmath>
#include <sstream>

#include "comparison/results/case_result.h"
#include "comparison/support/files.h"
#include "fem/condensation/vtu_file.h"
#include "fem/full_contact/angular_grid.h"
#include "fem/motion/motion.h"
#include "fem/support/constants.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::VectorXd;

void write_history(const SurfaceAnswer& surface, const FemCase& fem, const fs::path& file) {
  const auto& history = surface.history;
  const auto& units = fem.units;
  const Index n = history.forces.cols();
  const fem::StepTimes times(fem.motion, fem.steps_per_cycle());
  const long first = static_cast<long>(history.n_cycles - 1) * n;
  VectorXd time(n), depth(n);
  for (Index k = 0; k < n; ++k) {
    const double begin = times.begin(first + k), end = times.begin(first + k + 1);
    time[k] = fem.first_row + end / units.angular_frequency;
    depth[k] = fem::normal_motion_inside(fem.motion, end, (begin + end) / 2).value * units.depth;
  }
  std::vector<Column> columns{{"t [s]", time}};
  if (history.depth.size() > 0)
    columns.push_back({"d [m]", history.depth * units.depth});
  else if (!fem.motion.normal_force)
    columns.push_back({"d [m]", depth});
  columns.push_back({"u_x [m]", history.displacement.row(0).transpose() * units.depth});
  columns.push_back({"u_y [m]", history.displacement.row(1).transpose() * units.depth});
  columns.push_back({"F_N [N]", history.normal_force * units.force()});
  columns.push_back({"F_x [N]", history.forces.row(0).transpose() * units.force()});
  columns.push_back({"F_y [N]", history.forces.row(1).transpose() * units.force()});
  columns.push_back({"M_z [N m]", history.forces.row(2).transpose() * units.force() * units.length});
  write_csv(file, columns);
}

/// What a point of the whole circle has at the end of the cycle, SI units.
struct SurfacePoint {
  double inner, outer;  ///< radii of its ring
  double angle;
  double p, t_x, t_y;
  bool never_slipped, sticks_in_a_cycle;
};

/// All points of the whole circle, ring by ring.
std::vector<SurfacePoint> points_of(const FeAnswer& fe, const FemCase& fem) {
  const auto& surface = std::get<SurfaceAnswer>(fe.of_kind);
  const auto& pressure = surface.history.pressure.back();
  const auto& traction = surface.history.traction.back();
  const double unit = fem.units.pressure(), length = fem.units.length;
  std::vector<SurfacePoint> points;
  for (Index i = 0; i < pressure.rows(); ++i)
    for (const auto& [theta, kept, sign] : fem::whole_circle(surface.grid)) {
      const auto ring = static_cast<std::size_t>(i), angle = static_cast<std::size_t>(kept);
      const double inner = fe.body->radii[ring] * length, outer = fe.body->radii[ring + 1] * length,
                   middle = (inner + outer) / 2;
      points.push_back({inner, outer, theta, pressure(i, kept) * unit, traction(i, kept) * unit,
                        sign * traction(i, pressure.cols() + kept) * unit, middle <= surface.never_slipped.edges[angle],
                        middle <= surface.sticks_in_a_cycle.edges[angle]});
    }
  return points;
}

void write_points(const std::vector<SurfacePoint>& points, const fs::path& file) {
  const auto column = [&](const char* name, auto SurfacePoint::*value) {
    VectorXd values(static_cast<Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) values[static_cast<Index>(i)] = points[i].*value;
    return Column{name, values};
  };
  write_csv(file, {column("r inner [m]", &SurfacePoint::inner), column("r outer [m]", &SurfacePoint::outer),
                   column("angle [rad]", &SurfacePoint::angle), column("p [Pa]", &SurfacePoint::p),
                   column("t_x [Pa]", &SurfacePoint::t_x), column("t_y [Pa]", &SurfacePoint::t_y),
                   column("never slipped [1]", &SurfacePoint::never_slipped),
                   column("sticks in a cycle [1]", &SurfacePoint::sticks_in_a_cycle)});
}

/// Number of the zone of a point, as the name of the field explains it.
double zone_number(const SurfacePoint& point) {
  if (point.never_slipped) return 3;
  if (point.sticks_in_a_cycle) return 2;
  return point.p > 0 ? 1 : 0;
}

/// The surface around each point is the piece of its ring around its angle, flat, in straight pieces.
void write_surface(const std::vector<SurfacePoint>& points, unsigned n_around, const fs::path& file) {
  constexpr unsigned n_pieces = 6;
  const std::vector<fem::Field> fields{{"traction (Pa)", 3},
                                       {"contact pressure (Pa)", 1},
                                       {"zone (0 open, 1 slips, 2 sticks in a cycle, 3 has never slipped)", 1}};
  std::vector<fem::Patch> patches;
  for (const auto& point : points)
    for (unsigned piece = 0; piece < n_pieces; ++piece) {
      auto patch = fem::new_patch(1, 5);
      patch.patch_index = static_cast<unsigned>(patches.size());
      const double zone = zone_number(point);
      for (unsigned v = 0; v < 4; ++v) {
        const double share = static_cast<double>(piece + v / 2) / n_pieces - 0.5,
                     angle = point.angle + share * 2 * fem::pi / n_around,
                     radius = v % 2 == 0 ? point.inner : point.outer;
        patch.vertices[v] = {radius * std::cos(angle), radius * std::sin(angle), 0};
        unsigned k = 0;
        for (const double value : {point.t_x, point.t_y, point.p, point.p, zone})
          patch.data(k++, v) = static_cast<float>(value);
      }
      patches.push_back(std::move(patch));
    }
  std::ostringstream text;
  fem::write_vtu(patches, fields, text);
  write_file(file, text.str());
}

void write_zones(const SurfaceAnswer& surface, const fs::path& file) {
  const auto edges = edges_of(surface);
  std::vector<Column> columns;
  const auto add = [&](const char* name, const std::vector<double>& values) {
    columns.push_back({name, VectorXd::Map(values.data(), static_cast<Index>(values.size()))});
  };
  add("angle [rad]", edges.angle);
  add("contact [m]", edges.contact);
  add("never slipped [m]", edges.never_slipped);
  add("sticks in a cycle [m]", edges.sticks_in_a_cycle);
  write_csv(file, columns);
}

}  // namespace

void write_surface_files(const FeAnswer& fe, const FemCase& fem, const fs::path& folder) {
  const auto& surface = std::get<SurfaceAnswer>(fe.of_kind);
  write_history(surface, fem, folder / "history.csv");
  const auto points = points_of(fe, fem);
  write_points(points, folder / "surface.csv");
  write_surface(points, surface.grid.n_around, folder / "surface.vtu");
  write_zones(surface, folder / "zones.csv");
}

}  // namespace fretval
