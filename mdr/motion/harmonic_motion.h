#pragma once

#include <vector>

#include "mdr/motion/harmonic.h"
#include "mdr/motion/motion.h"

namespace fretval::mdr {

/// Motion of the rigid indenter about an indented rest position, each direction a sum of harmonics of any frequencies:
///
///   d(t)   = d0 + sum_j a_j cos(2 pi f_j t + phi_j)        normal
///   u_x(t) =      sum_k b_k cos(2 pi f_k t + psi_k)        tangential
///
/// The paper has one harmonic each, equation (11), and leaves unequal frequencies open.
struct HarmonicMotion {
  double indentation;                ///< d0 in m, positive
  std::vector<Harmonic> normal;      ///< amplitudes in m, not negative; may be empty
  std::vector<Harmonic> tangential;  ///< amplitudes in m, not negative; may be empty
  bool phase_locked = true;          ///< false: the tangential motion as a whole creeps against the normal one, so that
                                     ///< in the course of time every lag between the two occurs
};

/// Throws std::invalid_argument unless the motion is as described above.
void validate(const HarmonicMotion& motion);

/// The same motion, one harmonic each.
HarmonicMotion harmonic_motion(const Motion& motion);

/// Least upper bound of d(t) in m, see supremum() in mdr/harmonic.h: d_max of the limiting profile.
double maximum_indentation(const HarmonicMotion& motion);

/// Greatest lower bound of d(t) in m; negative when the indenter leaves the surface.
double minimum_indentation(const HarmonicMotion& motion);

}  // namespace fretval::mdr
