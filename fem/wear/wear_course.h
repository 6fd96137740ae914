#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "fem/wear/wearing_contact.h"

namespace fretval::fem {

/// How far and how finely wear is followed.
struct WearControl {
  double most_cycles;     ///< of the motion; may be infinite
  double rate_fallen_to;  ///< ends when the volume worn off in a cycle has fallen to this share of the first
  double largest_jump;    ///< worn depth of a jump
  double accuracy;        ///< of worn depths: less than that is nothing
};

/// Why the wear was followed no further: as many cycles as asked for; the rate has fallen as far as asked for; or as
/// many cycles again as there have been wear off nothing.
enum class WearEnd { cycles, rate, nothing_left };

/// One state of the course.
struct WearPoint {
  double cycles;
  double volume;          ///< worn off
  double volume_rate;     ///< per cycle
  double friction_work;   ///< per cycle
  double deepest;         ///< worn depth
  double contact_radius;  ///< outer edge of the outermost ring that bears pressure in the cycle
  double stick_radius;    ///< outer edge of the outermost ring of those around the centre that do not slip in the cycle
};

/// An indenter from its first shape to the last that was asked for.
struct WearCourse {
  std::vector<WearPoint> curve;       ///< from cycle 0 on
  std::vector<Eigen::VectorXd> worn;  ///< depth of the rings, likewise
  WearingContact::Period first, last;
  WearEnd end = WearEnd::nothing_left;
  int n_jumps = 0;
  double largest_jump_error = 0;  ///< worn depth, before a jump is extrapolated
  int n_cycles_stepped = 0;
};

/// Called after each jump.
using WearProgress = std::function<void(const WearPoint&)>;

/// Wears a contact by jumps: each takes the wear of many cycles in one period, then the slip settles on the new
/// profile. A jump is made at once and in two halves, which are extrapolated to second order in its length. The next
/// is as long as the last one suggests, at most three times; one that wears off more than twice the largest is taken
/// back. Errors are in the course alone: where wear ends, it ends in a state in which nothing under pressure slips,
/// whatever the jumps.
WearCourse wear_course(WearingContact contact, const WearControl& control, const WearProgress& progress = {});

}  // namespace fretval::fem
