#include "comparison/reference/gross_slip.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace fretval {

std::optional<double> steady_sliding_share(const MdrCase& mdr) {
  const auto& motion = mdr.motion;
  const bool one_each = motion.normal.size() == 1 && motion.tangential.size() == 1;
  if (mdr.path || !mdr.normal_force || !mdr.tangential_force || !one_each) return std::nullopt;
  const auto &normal = motion.normal.front(), &tangential = motion.tangential.front();
  const double carried = mdr.friction_coefficient * normal.amplitude;
  double demanded = tangential.amplitude + carried;
  if (motion.phase_locked && normal.amplitude > 0) {
    if (normal.frequency != tangential.frequency) return std::nullopt;
    const auto force = std::polar(tangential.amplitude, tangential.phase - normal.phase);
    demanded = std::max(std::abs(force + carried), std::abs(force - carried));
  }
  if (demanded == 0) return std::nullopt;
  return mdr.friction_coefficient * motion.indentation / demanded;
}

}  // namespace fretval
