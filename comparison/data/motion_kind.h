#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/case/case.h"
#include "comparison/quantities/reading.h"

namespace fretval {

/// How a motion goes on, which decides what there is to be asked about it: in cycles, or once; once also from the
/// instant on in which the indenter comes to touch.
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

/// The zone that sticks for good: of a pass that has never slipped, otherwise that of shakedown.
Quantity lasting_stick_radius(MotionKind kind);

/// Takes the stick radii away from an answer of either method that its kind does not have, and keeps the kind.
template <class Answer>
void keep_to(MotionKind kind, Answer& answer) {
  answer.motion_kind = kind;
  if (is_pass(kind)) answer.stick_radius_shakedown.reset();
  if (kind == MotionKind::pass_from_touch) answer.stick_radius_first_slip.reset();
}

/// Leaves out of the readings what a pass does not have: stick and worn radii say why, and nobody tells what the
/// body has kept, nor how slip dies out.
void keep_to(MotionKind kind, Readings& readings);

/// The keys of the "path" of a scene in result.json that tell the kind.
void add_motion_kind(MotionKind kind, nlohmann::ordered_json& path);

/// That of a "scene".
MotionKind stored_motion_kind(const nlohmann::ordered_json& scene);

}  // namespace fretval
