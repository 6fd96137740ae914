#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "fem/wear/wearing_contact.h"

namespace fretval::fem {

/// How far and how finely wear is followed.
struct WearControl {
  double most_cycles;     ///< of the motion; may be infinite
  double rate_fallen_to;  ///< ends when the volume worn off in a cycle has fallen to this share of the first; 0: never
  double largest_jump;    ///< worn depth of a jump
  double accuracy;        ///< of worn depths: less than that counts as nothing
};

/// Why the wear was followed no further: as many cycles as asked for; the rate has fallen as far as asked for; as many
/// cycles again as there have been wear off nothing; it goes on for ever, see wear_on; or the contact has worn until it
/// bears no more than a tangential force that is prescribed, so that all of it slides.
enum class WearEnd { cycles, rate, nothing_left, progressive, slides };

/// One state of the course.
struct WearPoint {
  double cycles;
  double volume;          ///< worn off
  double volume_rate;     ///< per cycle
  double friction_work;   ///< per cycle
  double deepest;         ///< worn depth
  double contact_radius;  ///< outer edge of the outermost ring that bears pressure in the cycle
  double stick_radius;    ///< outer edge of the outermost ring of those around the centre that do not slip in the cycle
  // On rings and angles both radii are those of discs of the area that the edges of these zones enclose.

  template <class Archive>
  void serialize(Archive& archive) {
    archive(cycles, volume, volume_rate, friction_work, deepest, contact_radius, stick_radius);
  }
};

/// Course of the wear of an indenter, from its first shape to the last one. Dimensionless.
struct WearCourse {
  std::vector<WearPoint> curve;                   ///< from cycle 0 on
  std::vector<Eigen::VectorXd> worn;              ///< worn depth of the points, for each point of the curve
  std::vector<Eigen::VectorXd> largest_pressure;  ///< in a cycle, of the points, for each point of the curve
  WearingContact::Period first, last;
  WearEnd end = WearEnd::nothing_left;
  int n_jumps = 0;
  double largest_jump_error = 0;  ///< of worn depths, before a jump is extrapolated
  int n_cycles_stepped = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(curve, worn, largest_pressure, first, last, end, n_jumps, largest_jump_error, n_cycles_stepped);
  }
};

/// A course of wear that is not finished, with all that it takes to go on.
struct WearState {
  WearingContact contact;
  WearCourse course = {};
  double next_jump = 0;  ///< length of the next jump in cycles
  bool goes_on = true;

  /// To be loaded into a state whose contact was made of the same arguments.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(contact, course, next_jump, goes_on);
  }
};

/// Called after each jump.
using WearObserver = std::function<void(const WearState&)>;

/// Wears a contact on until its course ends, from the start or from where it was left, by jumps: each takes the wear of
/// many cycles in one period, then the slip settles on the new profile. A jump is made at once and in two halves, which
/// are extrapolated to second order in its length. The next jump is made so long that it wears off largest_jump at the
/// rate of the last one, but at most three times as long; a jump that would wear off more than twice largest_jump is
/// made shorter, and so is one on whose way the whole contact slides: the course ends with the last state before that,
/// to a twentieth of largest_jump. Errors are in the course alone: where wear ends, it ends in a state in which nothing
/// under pressure slips, whatever the jumps.
///
/// Wear that has a limit takes off less and less in each doubling of its cycles. Where nothing sticks, more is worn off
/// than the indenter was pressed in at first, so that nothing is left of its first shape, and the last doubling has
/// taken off no less than the one before, there is no limit: wear is progressive, as under a normal force that lets the
/// indenter sink in after it.
void wear_on(WearState& state, const WearControl& control, const WearObserver& after_jump = {});

}  // namespace fretval::fem
