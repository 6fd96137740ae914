#pragma once

#include <algorithm>
#include <memory>

#include "comparison/accuracy/computations.h"
#include "comparison/accuracy/prepared_case.h"

namespace fretval {

/// Lets a study believe that it computed what it asked for: every answer is the exact one but for an error that the
/// rings and the steps make.
struct FakeNumerics {
  double ring_error, step_error;  ///< at 1 ring per radius and 1 step a cycle, of third and second order
  double first_slip = 0.5;        ///< stick radii over the contact radius
  double shakedown = first_slip;
  double centre_depth = 1;        ///< of either stick zone
  double centre_depth_error = 0;  ///< at 1 ring per radius, of third order
  double creep_error = 0;         ///< of the shakedown radius alone, in 1 creep cycle, of first order

  [[nodiscard]] double error(const Resolution& r) const {
    const double rings = r.elements_per_radius, steps = r.steps_per_cycle;
    return ring_error / (rings * rings * rings) + step_error / (steps * steps);
  }

  FeAnswer operator()(const FemCase& fem, const Resolution& r) const {
    const double length = fem.units.length, rings = r.elements_per_radius;
    const auto radius = [&](double exact, double creep = 0) {
      return exact > 0 ? std::optional((exact + error(r) + creep / r.n_creep_cycles) * length) : std::nullopt;
    };
    FeAnswer answer;
    answer.contact_radius_max = length;
    answer.stick_radius_first_slip = radius(first_slip);
    answer.stick_radius_shakedown = radius(shakedown, creep_error);
    answer.normal_force_max = fem.units.force();
    const double depth = centre_depth + centre_depth_error / (rings * rings * rings);
    const fem::StickDepths depths{Eigen::Vector2d(depth, -1), Eigen::Vector2d(0, 1)};
    answer.of_kind = DiscAnswer{depths, depths};
    answer.n_steps = 10L * r.steps_per_cycle;
    BodySummary body{};
    body.n_dofs = 500 * r.elements_per_radius;
    body.radii = at_resolution(fem, r).body.contact_nodes;
    constexpr double roundoff = 1e-9;
    answer.rings.contact =
        std::upper_bound(body.radii.begin(), body.radii.end(), 1 + roundoff) - body.radii.begin() - 1;
    answer.body = std::make_shared<const BodySummary>(body);
    keep_to(fem.motion_kind, answer);
    return answer;
  }
};

inline Compute fake_compute(const PreparedCase& prepared, const FakeNumerics& numerics) {
  return [fem = prepared.fem, numerics](const Resolution& r) { return numerics(fem, r); };
}

}  // namespace fretval
