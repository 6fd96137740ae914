#include "comparison/verification/trade/trade_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/simulation/body.h"
#include "comparison/support/resident_memory.h"
#include "comparison/support/stopwatch.h"
#include "fem/full_model/full_history.h"
#include "fem/history/static_contact.h"
#include "fem/support/solver_error.h"
#include "mdr/stick/stick_radius.h"
#include "meshes/mesh_error.h"

namespace fretval {
namespace {

constexpr double closed_form_seconds = 0.5;
constexpr double right_angle = 3.14159265358979323846 / 2;
constexpr int n_full_cycles = 2;

Quantities quantities_of(const mdr::SpringHistory& history, const PreparedCase& prepared) {
  const auto& units = prepared.fem.units;
  const auto radius = [&](double depth) {
    return depth > 0 ? mdr::inverse_transform(prepared.mdr.profile, depth) / units.length : 0;
  };
  const double force = *std::max_element(history.normal_force.begin(), history.normal_force.end());
  return {{Quantity::normal_force_max, std::log(force / units.force())},
          {Quantity::stick_radius_first_slip, radius(history.depths.first_slip)},
          {Quantity::stick_radius_shakedown, radius(history.depths.shakedown)}};
}

void measure(const PreparedCase& prepared, FullLevel& level) {
  FemCase fem = at_resolution(prepared.fem, level.resolution);
  fem.motion.n_ramp_cycles = 1;
  if (!fem.motion.phase) fem.motion.phase = right_angle;
  const int steps = fem.resolution.steps_per_cycle;
  const ResidentGrowth growth;
  const auto body = make_body(fem.body);
  level.n_dofs = body.n_dofs();
  level.body_seconds = body.cost.total();
  const Eigen::VectorXd profile = fem::ring_means(body.normal.contact.compliance, fem.profile);
  Stopwatch watch;
  const auto normal =
      fem::full_normal_history(body.normal.space, fem.relaxation, profile, fem.motion, steps, n_full_cycles);
  level.seconds_per_normal_step = watch.lap() / (n_full_cycles * steps);
  if (body.tangential) {
    fem::full_friction_history(body.tangential->space, fem.relaxation, fem.friction_coefficient, fem.motion,
                               normal.pressure, steps, n_full_cycles);
    level.seconds_per_friction_step = watch.lap() / (n_full_cycles * steps);
  }
  level.memory_bytes = growth.peak_bytes();
}

}  // namespace

ClosedForm closed_form(const PreparedCase& prepared) {
  const double never = std::numeric_limits<double>::infinity();
  const auto& mdr_case = prepared.mdr;
  ClosedForm result{{}, never, never};
  Stopwatch watch;
  for (double seconds = 0; seconds < closed_form_seconds;) {
    result.answer = mdr_answer(mdr_case, mdr_normal_response(mdr_case));
    const double lap = watch.lap();
    mdr::stick_radii(mdr_case.profile, mdr_case.body, mdr_case.friction_coefficient, mdr_case.motion);
    result.stick_radii_seconds = std::min(result.stick_radii_seconds, watch.lap());
    result.seconds = std::min(result.seconds, lap);
    seconds += lap;
  }
  return result;
}

std::vector<SpringLevel> spring_levels(const PreparedCase& prepared, const Quantities& reference) {
  if (prepared.mdr.limiting || !prepared.input.motion.phase) return {};
  std::vector<SpringLevel> levels;
  for (const auto& setting : {SpringSetting{50, 45, 5, 1e-4}, SpringSetting{100, 90, 10, 1e-5},
                              SpringSetting{200, 180, 20, 1e-6}, SpringSetting{400, 360, 20, 1e-7}}) {
    SpringLevel level{setting, {}};
    try {
      Stopwatch watch;
      const auto answer = spring_answer(prepared.input, setting);
      level.seconds = watch.lap();
      level.errors = errors_of(quantities_of(answer.history, prepared), reference);
    } catch (const std::runtime_error& error) {
      level.failure = error.what();
    }
    levels.push_back(std::move(level));
  }
  return levels;
}

FullLevel full_level(const PreparedCase& prepared, const Resolution& resolution) {
  FullLevel level{resolution};
  try {
    measure(prepared, level);
  } catch (const fem::SolverError& error) {
    level.failure = error.what();
  } catch (const meshes::MeshError& error) {
    level.failure = error.what();
  }
  return level;
}

}  // namespace fretval
