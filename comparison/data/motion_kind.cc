#include "comparison/data/motion_kind.h"

#include <nlohmann/json.hpp>

namespace fretval {

using nlohmann::ordered_json;

MotionKind motion_kind_of(const Case::Motion& motion) {
  if (!motion.path || motion.path->repeats) return MotionKind::cycles;
  return motion.path->from_touch ? MotionKind::pass_from_touch : MotionKind::pass;
}

Quantity lasting_stick_radius(MotionKind kind) {
  return is_pass(kind) ? Quantity::stick_radius_first_slip : Quantity::stick_radius_shakedown;
}

void keep_to(MotionKind kind, Readings& readings) {
  if (!is_pass(kind)) return;
  for (const auto quantity : all_quantities)
    if (traits_of(quantity).of_periodic_state) readings.erase(quantity);
  const auto leave_out = [&](Quantity quantity, const char* why) {
    const auto found = readings.find(quantity);
    if (found == readings.end()) return;
    found->second.value.reset();
    found->second.why_absent = why;
    found->second.is_compared = false;
  };
  for (const auto quantity : {Quantity::stick_radius_shakedown, Quantity::worn_radius})
    leave_out(quantity, "a single pass has no periodic state");
  if (kind == MotionKind::pass_from_touch) leave_out(Quantity::stick_radius_first_slip, nothing_at_rest);
}

void add_motion_kind(MotionKind kind, ordered_json& path) {
  path["repeats"] = is_pass(kind) ? "once" : "forever";
  if (is_pass(kind)) path["why_no_shakedown"] = no_shakedown_in_a_pass;
  if (kind == MotionKind::pass_from_touch) path["from_touch"] = true;
}

MotionKind stored_motion_kind(const ordered_json& scene) {
  const auto path = scene.find("path");
  if (path == scene.end() || path->value("repeats", "") != "once") return MotionKind::cycles;
  return path->value("from_touch", false) ? MotionKind::pass_from_touch : MotionKind::pass;
}

}  // namespace fretval
