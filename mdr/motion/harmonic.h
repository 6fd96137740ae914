#pragma once

#include <vector>

namespace fretval::mdr {

/// One oscillation a cos(2 pi f t + phase), of a tangential one along x or across, along y.
struct Harmonic {
  double amplitude;  ///< a, in the unit of what oscillates
  double frequency;  ///< f in Hz, positive
  double phase;      ///< rad
  bool across = false;
};

/// Least upper bound over all times of the sum of harmonics. Commensurate frequencies: the global maximum over the
/// common period, to 1e-13 of the sum of |a|. Incommensurate ones: the maxima of the commensurate groups added up,
/// which the sum comes as close to as one likes (see mdr/motion/commensurability.h for what counts as commensurate, and
/// for the relations among three or more groups that make this an upper bound). 0 for no harmonics. Amplitudes of any
/// sign. Throws std::invalid_argument for numbers that are not finite and for frequencies that are not positive.
double supremum(const std::vector<Harmonic>& harmonics);

}  // namespace fretval::mdr
