#pragma once

#include <ostream>

#include "fem/condensation/meridian_section.h"

namespace fretval::fem {

/// What a ring does at an instant; the numbers are those of the files.
enum class RingZone { open = 0, sticks = 1, slips_forward = 2, slips_backward = 3 };

/// What acts on the rings at an instant.
struct RingTractions {
  Eigen::VectorXd pressure, traction;
  std::vector<RingZone> zones;
};

/// Writes the contact line, revolved around the axis, as flat pieces, one a ring and sector, in the VTU format, in SI
/// units:
///   displacement (m)                                        vector
///   traction (Pa)                                           vector, of the indenter on the body: (tau, 0, p)
///   contact pressure (Pa), shear traction (Pa)              p, tau
///   zone (0 open, 1 sticks, 2 slips forward, 3 backward)    forward: the indenter slips along x
/// Axes as of write_meridian_section. Displacements are at the corners of the rings, the others are constant on a ring.
/// The area of the pieces is sin(w)/w of that of the rings, w = 2 pi / n_sectors.
void write_revolved_surface(const BodyState& state, const RingTractions& rings, const FieldUnits& units,
                            unsigned n_sectors, std::ostream& stream);

}  // namespace fretval::fem
