#include "comparison/model_error/coordinates.h"

#include <cmath>

namespace fretval {

double phase_on_maps(double phase) {
  constexpr double half_turn = 180;
  const double rest = std::fmod(phase, half_turn);
  return rest < 0 ? rest + half_turn : rest;
}

Coordinates coordinates_of(const Case& input, const MdrAnswer& answer) {
  Coordinates at;
  at.contact_radius = answer.contact_radius_max.value_or(0);
  at.normal_force = answer.normal_force_max.value_or(0);
  if (at.contact_radius > 0) {
    if (answer.stick_radius_first_slip) at.first_slip = *answer.stick_radius_first_slip / at.contact_radius;
    if (answer.stick_radius_shakedown) at.shakedown = *answer.stick_radius_shakedown / at.contact_radius;
  }
  at.phase = phase_on_maps(input.motion.phase.value_or(0));
  at.poisson_ratio = input.elastomer.poisson_ratio;
  if (!input.body.is_half_space()) at.radius_over_thickness = at.contact_radius / input.body.thickness;
  return at;
}

Coordinates coordinates_of(const Case& input) {
  auto of_one_direction = input;
  of_one_direction.contact = {};
  const auto mdr = mdr_case(of_one_direction);
  return coordinates_of(input, mdr_answer(mdr, mdr_normal_response(mdr)));
}

}  // namespace fretval
