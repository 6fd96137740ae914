#pragma once

#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// Reads a raw trace across an indenter and aligns it (mdr/profiles/trace_alignment.h). table_noise: standard deviation
/// of the heights in m; 0: that of the residuals. Throws InputError with the file's name.
Case::AlignedTrace read_aligned_trace(const std::string& file, double table_noise);

/// The trace aligned with its apex one standard deviation off, and the tilt that belongs to that apex. deviations: -1
/// or 1, the direction.
Case::AlignedTrace neighbour_of(const Case::AlignedTrace& trace, int deviations);

}  // namespace fretval
