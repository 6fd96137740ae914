#pragma once

#include <optional>
#include <variant>

#include "mdr/motion/motion.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/rheology.h"

namespace fretval::mdr {

/// d(t) = mean + amplitude cos(omega_z t), in m. Mean positive, amplitude not negative.
struct IndentationControl {
  double mean;
  double amplitude;
};

/// F_z(t) = mean + amplitude cos(omega_z t), in N. Mean positive, amplitude not negative.
struct NormalForceControl {
  double mean;
  double amplitude;
};

/// u_x(t) = amplitude cos(omega_x t + phase), in m. Not negative.
struct TangentialDisplacementControl {
  double amplitude;
};

/// F_x(t) = amplitude cos(omega_x t + phase), in N. Not negative.
struct TangentialForceControl {
  double amplitude;
};

/// What the test rig prescribes.
struct FrettingControl {
  std::variant<IndentationControl, NormalForceControl> normal;
  std::variant<TangentialDisplacementControl, TangentialForceControl> tangential;
  double normal_frequency;      ///< Hz
  double tangential_frequency;  ///< Hz; the same when the phase is locked
  std::optional<double> phase;  ///< rad, between the prescribed quantities; empty: unlocked
};

/// Throws std::invalid_argument for values that are not finite or not as described above, and for a locked phase
/// between unequal frequencies, of which no limiting state is known.
void validate(double mu, const FrettingControl& control);

/// Which stick zone wear leaves untouched; see stick_depths() of mdr/stick/stick_radius.h. Slow wear tends to
/// shakedown.
enum class StickCriterion { first_slip, shakedown };

/// The fully worn contact. Its radius is the stick radius at all times, so forces and displacements are linear in each
/// other.
struct LimitingState {
  double stick_radius;            ///< c in m
  Motion motion;                  ///< displacements, and the phase between them; d_max = maximum_indentation(motion)
  double mean_normal_force;       ///< N
  double normal_force_amplitude;  ///< N
  double tangential_force_amplitude;  ///< N
};

/// The worn contact that a rig ends up with, displacements or forces being prescribed in either direction.
///
///   F_z mean = 8 G0 (c d0 - int_0^c g dx),   Delta F = 8 |G(w_z)| c Delta d,   F_x0 = (16/3) |G(w_x)| c u_x0,
///   both forces ahead of their displacements by arg G;
///   g(c) = d0 - (M+ + M-)/2 for shakedown, d0 - max(M+, M-) for first slip, with d0, Delta d and u_x0 at that c.
///
/// Under two forces nothing is left of the rheology: the unworn elastic contact of radius c carries
///   8 G0 (c g(c) - int_0^c g dx) = F0 - (1/2)(|F_x0/mu e^(i phase) - Delta F| + |F_x0/mu e^(i phase) + Delta F|),
/// the normal force where the two tangents of slope +-mu to the loading loop meet (Barber, Davies and Hills 2011).
/// Under an indentation and a tangential force two radii may fulfil the condition; wear shrinks the contact from
/// outside, so it is the larger one. Under a normal force there is one at most.
///
/// Empty: no limiting state. No contact radius carries the oscillation without slip, and wear goes on for ever.
/// Source: paper, equations (13) to (20), solved for the other quantities.
/// Validity: as stick_depths(); equal frequencies or an unlocked phase. Relative accuracy of c: roundoff, enlarged
/// where the two radii are about to merge.
/// Throws std::invalid_argument for bad arguments and a locked phase between unequal frequencies, std::runtime_error
/// for a tangential force above the largest that sticks by less than a relative 1e-11.
std::optional<LimitingState> limiting_state(const Profile& profile, const Rheology& body, double mu,
                                            const FrettingControl& control, StickCriterion criterion);

}  // namespace fretval::mdr
