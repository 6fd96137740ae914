#pragma once

#include <ostream>

#include "fem/condensation/meridian_section.h"

namespace fretval::fem {

/// What a ring does at an instant; the values are the numbers in the files.
enum class RingZone { open = 0, sticks = 1, slips_forward = 2, slips_backward = 3 };

/// Pressure and traction on the rings at an instant (n_rings), in the unit of the body, and what the rings do.
struct RingTractions {
  Eigen::VectorXd pressure, traction;
  std::vector<RingZone> zones;
};

/// Writes the contact line, revolved around the axis, as flat pieces, one for each ring and sector, in the VTU format,
/// in SI units:
///   displacement (m)                                        vector
///   traction (Pa)                                           vector, of the indenter on the body: (tau, 0, p)
///   contact pressure (Pa), shear traction (Pa)              p, tau
///   zone (0 open, 1 sticks, 2 slips forward, 3 backward)    forward: the indenter slips along x
/// The axes are those of write_meridian_section. Displacements are given at the corners of the rings; the other fields
/// are constant on a ring. The area of the pieces is sin(w)/w of that of the rings, w = 2 pi / n_sectors.
void write_revolved_surface(const BodyState& state, const RingTractions& rings, const FieldUnits& units,
                            unsigned n_sectors, std::ostream& stream);

}  // namespace fretval::fem
