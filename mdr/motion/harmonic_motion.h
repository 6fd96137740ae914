#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mdr/motion/harmonic.h"
#include "mdr/motion/motion.h"

namespace fretval::mdr {

/// Motion of the rigid indenter about an indented rest position, each direction a sum of harmonics of any frequencies:
///
///   d(t)   = d0 + sum_j a_j cos(2 pi f_j t + phi_j)        normal
///   u_x(t) =      sum_k b_k cos(2 pi f_k t + psi_k)        tangential
///
/// The paper has one harmonic each, equation (11), and leaves unequal frequencies open. Tangential harmonics that go
/// across are those of u_y.
struct HarmonicMotion {
  double indentation;                ///< d0 in m, positive
  std::vector<Harmonic> normal;      ///< amplitudes in m, not negative; may be empty
  std::vector<Harmonic> tangential;  ///< amplitudes in m, not negative; may be empty
  bool phase_locked = true;          ///< false: the tangential motion as a whole creeps against the normal one, so that
                                     ///< in the course of time every lag between the two occurs
};

/// Whether any harmonic moves along y.
bool moves_across(const HarmonicMotion& motion);

/// Throws std::invalid_argument unless the motion is as described above.
void validate(const HarmonicMotion& motion);

/// A motion of one harmonic in each direction as a HarmonicMotion.
HarmonicMotion harmonic_motion(const Motion& motion);

/// A motion as one of a single harmonic in each direction; empty where a direction has more than one harmonic that
/// moves, or the indentation is not largest at time 0. A direction at rest keeps its first frequency.
std::optional<Motion> one_harmonic_each(const HarmonicMotion& motion);

/// The motion with its harmonics that do not move left out, but for the first of a direction in which none does.
HarmonicMotion without_still_harmonics(const HarmonicMotion& motion);

/// Highest and lowest frequency of all harmonics, Hz; 0 for a motion without harmonics.
double highest_frequency(const HarmonicMotion& motion);
double lowest_frequency(const HarmonicMotion& motion);

/// The cycle with which a motion repeats, and how often each harmonic oscillates in it; 0 for one that does not move.
struct CommonCycle {
  double frequency;  ///< Hz
  std::vector<int> normal_orders, tangential_orders;

  [[nodiscard]] int highest_order() const;
};

/// Empty: frequencies are not commensurate (see mdr/motion/commensurability.h). Whether the phase is locked does not
/// matter. Where nothing moves, the cycle is that of the first normal harmonic.
std::optional<CommonCycle> common_cycle(const HarmonicMotion& motion);

/// Harmonics that are multiples of one frequency, see mdr/motion/commensurability.h.
struct HarmonicGroup {
  struct Member {
    bool normal;        ///< false: tangential
    std::size_t place;  ///< in its direction
    int order;          ///< oscillations per period of the group; orders have no common divisor
  };

  double base_frequency;  ///< Hz
  std::vector<Member> members;

  [[nodiscard]] int highest_order() const;
};

/// Groups of the harmonics that move, normal ones first: one where there is a common cycle, none where nothing moves.
std::vector<HarmonicGroup> harmonic_groups(const HarmonicMotion& motion);

/// Whether there are two groups, the first of normal harmonics alone and the second of tangential ones alone.
bool are_the_directions(const std::vector<HarmonicGroup>& groups);

/// A motion with its time shifted so that its indentation is largest at time 0. Where normal frequencies are not
/// commensurate, there may be none: the motion comes as close as one likes to the one that is returned, in which every
/// group of commensurate harmonics begins where its normal ones are largest together (see
/// mdr/motion/commensurability.h). Of several such instants the first that is not before time 0; one harmonic of phase
/// 0 stays as it is.
HarmonicMotion from_largest_indentation(HarmonicMotion motion);

/// Least upper bound of d(t) in m, see supremum() in mdr/motion/harmonic.h: d_max of the limiting profile.
double maximum_indentation(const HarmonicMotion& motion);

/// Greatest lower bound of d(t) in m; negative when the indenter leaves the surface.
double minimum_indentation(const HarmonicMotion& motion);

}  // namespace fretval::mdr
