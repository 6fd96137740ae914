#pragma once

#include <optional>

namespace fretval::mdr {

/// Oscillation of the rigid indenter about an indented rest position, paper equation (11):
///
///   d(t)   = d0   + Delta d cos(2 pi f_z t)
///   u_x(t) = u_x0 cos(2 pi f_x t + phi0)
struct Motion {
  double indentation;           ///< d0 in m, positive
  double normal_amplitude;      ///< Delta d in m, not negative
  double tangential_amplitude;  ///< u_x0 in m, not negative
  double normal_frequency;      ///< f_z in Hz, positive
  double tangential_frequency;  ///< f_x in Hz, positive
  std::optional<double> phase;  ///< phi0 in rad; empty: unlocked, it takes every value in the course of time
};

/// Throws std::invalid_argument unless the motion is as described above. Whether a phase fits the two frequencies is
/// judged by the functions that use it.
void validate(const Motion& motion);

/// d_max = d0 + Delta d in m, paper equation (12).
double maximum_indentation(const Motion& motion);

/// Angular frequency 2 pi f in rad/s of a frequency in Hz.
double angular_frequency(double frequency);

}  // namespace fretval::mdr
