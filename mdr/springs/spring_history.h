#pragma once

#include "mdr/motion/harmonic_motion.h"
#include "mdr/motion/repeating_motion.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/springs/history_data.h"
#include "mdr/springs/spring_bed.h"

namespace fretval::mdr {

/// Share of the amplitudes at a time in s, while they rise from rest over ramp_duration in s, and its rate per second:
/// x^3 (10 - 15 x + 6 x^2), whose slope and curvature are 0 at both ends.
double amplitude_share(double time, double ramp_duration);
double amplitude_share_rate(double time, double ramp_duration);

/// Oscillation that starts from rest at d0: all amplitudes rise together and smoothly over ramp_duration in s. The
/// phase of a motion is taken as locked, that of a repeating one creeps as it says.
IndenterPath ramped_path(const HarmonicMotion& motion, double ramp_duration);
IndenterPath ramped_path(const RepeatingMotion& repeating, double ramp_duration);

/// Periods in ten creep times, after which creep is over: a ramp under forces has as many.
int periods_of_creep(const PronyBody& body, double period);

/// How many periods to step at most for a state that repeats, after so many of a ramp or of creep. Throws
/// std::runtime_error for more than 10,000.
int most_periods_with(int n_periods);

/// Forces F0 + Delta F cos(2 pi f t) and F_x0 cos(2 pi f t + phase), the oscillating parts rising over ramp_duration
/// in s. mean positive, amplitudes not negative, f in Hz positive, phase in rad.
ForcePath ramped_force(double mean, double amplitude, double frequency, double phase, double ramp_duration);

/// Steps the springs from the relaxed state at the path's start until their tractions repeat.
///
/// Stick depths: the friction margin of a spring that sticks, over its stiffness, is g(c) - g(x), so every stuck
/// spring gives g(c); the outermost one is taken. First slip: least margin min(mu q_z -+ q_x) over the whole history of
/// springs that never slipped; shakedown: mean of the two least margins over the last period, of springs that do not
/// slip in it. Minima between time steps are those of parabolas. Not positive where no spring sticks.
/// Under a prescribed force the motion of the indenter is found in every step; it is the same for all springs, so the
/// margins mean the same. Where slip dies out slowly everywhere (a body much stiffer in motion than at rest), tractions
/// repeat while springs still slip a little; settling_depth counts springs that slip by up to settling_slip of the
/// largest tangential displacement in the period: their margins are those of springs that stick.
/// Throws std::runtime_error when the state is not periodic after max_periods or the contact slides under a tangential
/// force, std::invalid_argument for bad arguments.
SpringHistory spring_history(const SpringBed& bed, const PronyBody& body, double mu, const Loading& loading,
                             const HistoryControl& control);

}  // namespace fretval::mdr
