#include "comparison/data/course.h"

#include <nlohmann/json.hpp>

namespace fretval {

using nlohmann::ordered_json;

Course course_of(const Case::Motion& motion) {
  if (!motion.path || motion.path->repeats) return Course::cycles;
  return motion.path->from_touch ? Course::pass_from_touch : Course::pass;
}

Quantity lasting_stick_radius(Course course) {
  return is_pass(course) ? Quantity::stick_radius_first_slip : Quantity::stick_radius_shakedown;
}

void keep_to(Course course, Readings& readings) {
  if (!is_pass(course)) return;
  for (const auto quantity :
       {Quantity::bulk_work, Quantity::cycle_work, Quantity::tangential_work, Quantity::shakedown_along,
        Quantity::shakedown_across, Quantity::slip_decay, Quantity::cycles_to_shakedown})
    readings.erase(quantity);
  const auto leave_out = [&](Quantity quantity, const char* why) {
    const auto found = readings.find(quantity);
    if (found == readings.end()) return;
    found->second.value.reset();
    found->second.why_absent = why;
    found->second.is_compared = false;
  };
  for (const auto quantity : {Quantity::stick_radius_shakedown, Quantity::worn_radius})
    leave_out(quantity, "a single pass has no periodic state");
  if (course == Course::pass_from_touch) leave_out(Quantity::stick_radius_first_slip, nothing_at_rest);
}

void add_course(Course course, ordered_json& path) {
  path["repeats"] = is_pass(course) ? "once" : "forever";
  if (is_pass(course)) path["why_no_shakedown"] = no_shakedown_in_a_pass;
  if (course == Course::pass_from_touch) path["from_touch"] = true;
}

Course stored_course(const ordered_json& scene) {
  const auto path = scene.find("path");
  if (path == scene.end() || path->value("repeats", "") != "once") return Course::cycles;
  return path->value("from_touch", false) ? Course::pass_from_touch : Course::pass;
}

}  // namespace fretval
