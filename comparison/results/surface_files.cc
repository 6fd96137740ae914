#include "comparison/results/surface_files.h"

#include "comparison/support/files.h"
#include "fem/full_contact/angular_grid.h"
#include "fem/motion/motion.h"

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
  if (!fem.motion.normal_force) columns.push_back({"d [m]", depth});
  columns.push_back({"u_x [m]", history.displacement.row(0).transpose() * units.depth});
  columns.push_back({"u_y [m]", history.displacement.row(1).transpose() * units.depth});
  columns.push_back({"F_N [N]", history.normal_force * units.force()});
  columns.push_back({"F_x [N]", history.forces.row(0).transpose() * units.force()});
  columns.push_back({"F_y [N]", history.forces.row(1).transpose() * units.force()});
  columns.push_back({"M_z [N m]", history.forces.row(2).transpose() * units.force() * units.length});
  write_csv(file, columns);
}

/// All points of the whole circle, ring by ring.
void write_points(const FeAnswer& fe, const FemCase& fem, const fs::path& file) {
  const auto& surface = *fe.surface;
  const auto& pressure = surface.history.pressure.back();
  const auto& traction = surface.history.traction.back();
  const auto circle = fem::whole_circle(surface.grid);
  const Index n_rings = pressure.rows(), n_kept = pressure.cols(), n = n_rings * static_cast<Index>(circle.size());
  const double unit = fem.units.pressure(), length = fem.units.length;
  VectorXd inner(n), outer(n), angle(n), p(n), x(n), y(n), never(n), sticks(n);
  Index row = 0;
  for (Index i = 0; i < n_rings; ++i)
    for (const auto& [theta, kept, sign] : circle) {
      const auto ring = static_cast<std::size_t>(i);
      inner[row] = fe.body->radii[ring] * length;
      outer[row] = fe.body->radii[ring + 1] * length;
      angle[row] = theta;
      p[row] = pressure(i, kept) * unit;
      x[row] = traction(i, kept) * unit;
      y[row] = sign * traction(i, n_kept + kept) * unit;
      const double middle = (inner[row] + outer[row]) / 2;
      never[row] = middle <= surface.never_slipped.edges[static_cast<std::size_t>(kept)] ? 1 : 0;
      sticks[row] = middle <= surface.sticks_in_a_cycle.edges[static_cast<std::size_t>(kept)] ? 1 : 0;
      ++row;
    }
  write_csv(file, {{"r inner [m]", inner},
                   {"r outer [m]", outer},
                   {"angle [rad]", angle},
                   {"p [Pa]", p},
                   {"t_x [Pa]", x},
                   {"t_y [Pa]", y},
                   {"never slipped [1]", never},
                   {"sticks in a cycle [1]", sticks}});
}

void write_zones(const SurfaceAnswer& surface, const fs::path& file) {
  const auto circle = fem::whole_circle(surface.grid);
  const auto n = static_cast<Index>(circle.size());
  VectorXd angle(n);
  for (Index j = 0; j < n; ++j) angle[j] = circle[static_cast<std::size_t>(j)].angle;
  std::vector<Column> columns{{"angle [rad]", angle}};
  const auto add = [&](const char* name, const PlaneZone& zone) {
    VectorXd edge(n);
    for (Index j = 0; j < n; ++j)
      edge[j] = zone.edges[static_cast<std::size_t>(circle[static_cast<std::size_t>(j)].kept)];
    columns.push_back({name, edge});
  };
  add("contact [m]", surface.contact);
  add("never slipped [m]", surface.never_slipped);
  add("sticks in a cycle [m]", surface.sticks_in_a_cycle);
  write_csv(file, columns);
}

}  // namespace

void write_surface_files(const FeAnswer& fe, const FemCase& fem, const fs::path& folder) {
  write_history(*fe.surface, fem, folder / "history.csv");
  write_points(fe, fem, folder / "surface.csv");
  write_zones(*fe.surface, folder / "zones.csv");
}

}  // namespace fretval
