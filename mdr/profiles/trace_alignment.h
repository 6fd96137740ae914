#pragma once

#include <array>
#include <vector>

namespace fretval::mdr {

/// Where the axis of an indenter is in a trace across it, and how the stage is tilted: all in m, and as a slope.
struct TraceAlignment {
  double apex, apex_uncertainty;
  double tilt, tilt_uncertainty;  ///< slope of the stage, z = ... + tilt (x - apex)
  double noise;                   ///< standard deviation of the heights
  bool heights_upwards;           ///< the tip is the highest point; false: the lowest
};

/// Fits
///
///   z(x) = s h(|x - apex|) + tilt (x - apex),   h any even course, s = 1 or -1,
///
/// to a trace by least squares: h by up to 40 cubic B-splines, tilt beside them, and the apex where the sum of squares
/// is least. s is the sign of the curvature of the parabola that is closest to the trace. What the trace does not tell
/// is held by a tilt of 0 with a standard deviation of 2 degrees: in a parabola any apex fits with the tilt that
/// belongs to it, and the profile is the same. Uncertainties are standard deviations by the linearised fit and the
/// noise of the residuals, that of the tilt including what the apex leaves open.
///
/// x and z in m, as many, at least 32 rows, x increasing. Throws std::invalid_argument for other rows, or for a trace
/// whose apex is not inside it, with at least an eighth of its length on either side.
TraceAlignment align_trace(const std::vector<double>& x, const std::vector<double>& z);

/// The best alignments with the apex one standard deviation off to either side.
std::array<TraceAlignment, 2> neighbours_of(const TraceAlignment& alignment, const std::vector<double>& x,
                                            const std::vector<double>& z);

/// Profile of an aligned trace, heights counted upwards from the tip.
struct AlignedProfile {
  std::vector<double> r, f;  ///< m, r rising; means of neighbouring rows of both halves, where there are both
  double noise;              ///< standard deviation of f
};
AlignedProfile aligned_profile(const TraceAlignment& alignment, const std::vector<double>& x,
                               const std::vector<double>& z);

}  // namespace fretval::mdr
