#pragma once

#include <filesystem>

#include "comparison/simulation/fe_answer.h"

namespace fretval {

/// Files of the contact on rings and angles, of its last cycle, SI units:
///   history.csv   t, d, u_x, u_y at the ends of the steps; F_N, F_x, F_y and the torque about the axis at their balance
///   surface.csv   a row for each point: ring and angle, pressures and tractions at the end, whether it sticks
///   surface.vtu   the same as pieces of rings, for ParaView: the traction of the indenter on the body as a vector with p
///                 along z, the pressure, and the zone
///   zones.csv     edges of the zones over the angle
void write_surface_files(const FeAnswer& fe, const FemCase& fem, const std::filesystem::path& folder);

}  // namespace fretval
