#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/case/case.h"
#include "comparison/quantities/reading.h"

namespace fretval {

/// Course of a motion, which decides what can be asked about it: cycles that repeat, a single pass, or a single pass
/// from the instant on at which the indenter comes to touch.
enum class MotionKind { cycles, pass, pass_from_touch };

inline bool is_pass(MotionKind kind) {
  return kind != MotionKind::cycles;
}

MotionKind motion_kind_of(const Case::Motion& motion);

/// Why a path that is passed once has one stick radius alone.
constexpr const char* no_shakedown_in_a_pass =
    "a single pass has no periodic state: never slipped is the only stick radius";

/// Why there is no stick radius of first slip in a pass whose indenter only comes to touch at rest.
constexpr const char* nothing_at_rest = "the pass begins as the indenter comes to touch: nothing is in contact at rest";

/// The stick radius of the zone that sticks for good: that of first slip for a pass, otherwise that of shakedown.
Quantity lasting_stick_radius(MotionKind kind);

/// Removes from an answer of either method the stick radii that its kind of motion does not have, and stores the kind.
template <class Answer>
void keep_to(MotionKind kind, Answer& answer) {
  answer.motion_kind = kind;
  if (is_pass(kind)) answer.stick_radius_shakedown.reset();
  if (kind == MotionKind::pass_from_touch) answer.stick_radius_first_slip.reset();
}

/// Leaves out of the readings what a pass does not have: stick and worn radii say why, and the losses inside the body
/// and the decay of slip are left out.
void keep_to(MotionKind kind, Readings& readings);

/// Adds the keys that tell the kind to the "path" of a scene in result.json.
void add_motion_kind(MotionKind kind, nlohmann::ordered_json& path);

/// The kind of motion of a "scene" in result.json.
MotionKind stored_motion_kind(const nlohmann::ordered_json& scene);

}  // namespace fretval
