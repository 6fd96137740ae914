#include "comparison/reference/mdr_answer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/reference/cycle_of_springs.h"
#include "comparison/reference/layer_answer.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/reference/plane_answer.h"
#include "comparison/reference/springs_as_asked.h"
#include "comparison/support/statistics.h"
#include "mdr/springs/path_response.h"
#include "mdr/springs/slip_of_periods.h"
#include "mdr/springs/stepped_response.h"
#include "mdr/stick/path_depths.h"
#include "mdr/stick/shakedown_amplitude.h"
#include "mdr/stick/slip_decay.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {

namespace {

/// The displacements of a case; of a limiting profile under forces those of its state.
mdr::HarmonicMotion displacements_of(const MdrCase& mdr) {
  return mdr.limiting && mdr.has_forces() ? mdr.limiting_state->motion : mdr.motion;
}

/// Largest error of what is asked of an answer by springs, over what the case allows: of the stick radii, of what
/// forces do to the indenter, and of the cycle.
double excess_of(const MdrCase& mdr, const MdrAnswer& answer) {
  const double a = answer.contact_radius_max.value_or(0);
  double most = 0;
  if (mdr.tolerance > 0)
    for (const auto& [quantity, error] : {std::pair(Quantity::stick_radius_first_slip, answer.stepped.first_slip),
                                          {Quantity::stick_radius_shakedown, answer.stepped.shakedown}})
      most = std::max(most, excess_of(mdr.tolerance, quantity, a, error, {a, 0, 0}));
  if (mdr.tolerance > 0 && answer.indentation_max)
    most = std::max(most, excess_of(mdr.tolerance, Quantity::indentation_max, *answer.indentation_max,
                                    answer.stepped.indentation, {a, 0, 0}));
  if (mdr.tolerance > 0 && answer.tangential_amplitude)
    most = std::max(most, excess_of(mdr.tolerance, Quantity::tangential_amplitude, *answer.tangential_amplitude,
                                    answer.stepped.tangential_amplitude, {a, 0, 0}));
  if (!mdr.cycle_tolerance || !answer.cycle) return most;
  const Scales scales{0, answer.cycle->sliding_force, answer.cycle->sliding_work};
  for (const auto& [quantity, reading] : answer.cycle->readings)
    if (const double value = reading.value.value_or(0); value > 0)
      most = std::max(most, excess_of(*mdr.cycle_tolerance, quantity, value, reading.uncertainty.value_or(0), scales));
  return most;
}

/// answer_with: as many times the usual springs and steps.
MdrAnswer as_known_as_asked(const MdrCase& mdr, const std::function<MdrAnswer(int times)>& answer_with) {
  return refined_until_known([&](const MdrAnswer& answer) { return excess_of(mdr, answer); }, answer_with);
}

/// Springs of a motion without period go through 192 oscillations, and half and twice as many, in the place of one. As
/// these leave nearly all of their error, finer springs go through more of them.
mdr::SpringFineness of_many_oscillations(int times) {
  return {100, 90, 10, 1e-7, 192 * times};
}

mdr::SteppedForcedResponse half_space_response(const MdrCase& mdr, int times) {
  return mdr::forced_response(
      mdr.profile, mdr.body, mdr.friction_coefficient, mdr.prescribed(),
      mdr.has_period() ? fineness_of(mdr, mdr::SpringFineness{}, times) : of_many_oscillations(times));
}

/// The answer to an unworn indenter, by springs. Under both forces a half-space has a closed shakedown radius.
MdrAnswer forced_answer(const MdrCase& mdr, const mdr::NormalResponse& normal, int times) {
  MdrAnswer answer = with_normal_response(normal);
  answer.steady_sliding_share = steady_sliding_share(mdr);
  mdr::SteppedForcedResponse stepped;
  try {
    stepped = mdr.layer ? layer_response(mdr, times) : half_space_response(mdr, times);
  } catch (const mdr::GrossSlip& slip) {
    answer.of_kind = GrossSlipShare{slip.amplitude};
    return answer;
  }
  const auto& [response, error] = stepped;
  answer.cycle = cycle_of_springs(mdr, stepped, answer.normal_force_max.value());
  constexpr double none = -std::numeric_limits<double>::infinity();
  if (response.normal.normal_force_min == 0)  // what is let go in every cycle does not stick
    take_depths(mdr, {none, none}, {0, 0}, response, error, answer);
  else
    take_depths(mdr, response.depths, error.depths, response, error, answer);
  if (mdr.has_period()) take_tangential_amplitude(mdr, response, error, answer);
  if (mdr.normal_force && mdr.tangential_force && mdr.limiting_state) {
    answer.stick_radius_shakedown = mdr.limiting_state->stick_radius;
    answer.stepped.shakedown = 0;
  }
  if (mdr.layer)
    answer.worn_radius = layer_worn_radius(mdr, answer.stick_radius_shakedown, response.largest_indentation);
  return answer;
}

template <class Profile>
MdrAnswer displaced_answer(const MdrCase& mdr, const Profile& profile, const mdr::HarmonicMotion& motion,
                           const mdr::NormalResponse& normal) {
  MdrAnswer answer = with_normal_response(normal);
  const auto one_each = mdr::one_harmonic_each(motion);
  const auto radii = one_each ? mdr::stick_radii(profile, mdr.body, mdr.friction_coefficient, *one_each)
                              : mdr::stick_radii(profile, mdr.body, mdr.friction_coefficient, motion);
  answer.stick_radius_first_slip = radii.first_slip;
  answer.stick_radius_shakedown = radii.shakedown;
  return answer;
}

/// The answer to an indenter that has its limiting profile.
MdrAnswer worn_answer(const MdrCase& mdr, const mdr::NormalResponse& normal) {
  const auto motion = displacements_of(mdr);
  auto answer = displaced_answer(mdr, *mdr.limiting, motion, normal);
  // On the way to a limiting state under forces the outer part of the contact slips, so that the first-slip radius is
  // not that of the limiting state.
  if (mdr.has_forces()) {
    const auto forced = mdr::forced_response(*mdr.limiting, mdr.body, mdr.friction_coefficient, mdr.prescribed());
    answer.stick_radius_first_slip = mdr::stick_radii(mdr.profile, forced.response.depths).first_slip;
  }
  const auto one_each = mdr::one_harmonic_each(motion);
  LimitingAnswer limiting;
  if (one_each && one_each->tangential_amplitude > 0)
    limiting.amplitude =
        mdr::tangential_amplitude_for_shakedown(mdr.body, mdr.friction_coefficient, *one_each,
                                                mdr::transform(mdr.profile, mdr.limiting->stick_radius))
            .value_or(0) /
        one_each->tangential_amplitude;
  answer.of_kind = limiting;
  if (mdr.normal_force) answer.indentation_max = mdr::maximum_indentation(motion);
  if (mdr.tangential_force) answer.tangential_amplitude = motion.tangential.front().amplitude;
  return answer;
}

/// The cycle of a path by the springs of one direction.
CycleReadings cycle_along(const MdrCase& mdr, const mdr::SteppedPathForces& stepped, double normal_force_max) {
  auto cycle = cycle_along(mdr, stepped.forces, stepped.error, normal_force_max);
  leave_out_unknown_force(mdr, cycle);
  return cycle;
}

/// Whether springs are asked about forces and energies along a path.
bool has_cycle_along(const MdrCase& mdr) {
  const auto& values = mdr.path->tangential;
  if (mdr.path->repeats && settles_for_long(mdr.body, mdr.path->duration())) return false;
  return std::any_of(values.begin(), values.end(), [&](double value) { return value != values.front(); });
}

/// Stick radii along a path of displacements, by closed forms.
void answer_displaced_path(const MdrCase& mdr, MdrAnswer& answer) {
  const auto radii = mdr::stick_radii(mdr.profile, mdr.body, mdr.friction_coefficient, *mdr.path);
  answer.stick_radius_first_slip = radii.first_slip;
  answer.stick_radius_shakedown = radii.shakedown;
}

/// Stick radii, forces and works along a path with forces or over a layer, by springs.
void answer_forced_path(const MdrCase& mdr, int times, MdrAnswer& answer) {
  std::optional<mdr::SteppedPathForces> stepped;
  try {
    const auto fineness = fineness_of(mdr, mdr::PathFineness{}, times);
    stepped = mdr.layer ? layer_path_forces(mdr, mdr.friction_coefficient, *mdr.path, fineness)
                        : mdr::path_forces(mdr.profile, mdr.body, mdr.friction_coefficient, *mdr.path, fineness);
  } catch (const mdr::GrossSlip& slip) {
    answer.of_kind = GrossSlipShare{slip.amplitude, mdr.is_single_pass() ? std::optional(slip.time) : std::nullopt};
    return;
  }
  const auto& [forces, error, course] = *stepped;
  take_depths(mdr, {forces.first_slip, forces.shakedown},
              {error.first_slip, mdr.is_single_pass() ? 0 : error.shakedown}, forces, error, answer);
  take_tangential_amplitude(mdr, forces, error, answer);
  if (has_cycle_along(mdr)) answer.cycle = cycle_along(mdr, *stepped, answer.normal_force_max.value());
}

MdrAnswer path_answer(const MdrCase& mdr, const mdr::NormalResponse& normal, int times) {
  MdrAnswer answer = with_normal_response(normal);
  if (mdr.path->has_forces() || mdr.layer)
    answer_forced_path(mdr, times, answer);
  else
    answer_displaced_path(mdr, answer);
  return answer;
}

/// Normal response along a path, by springs without tangential motion, which does not affect it.
mdr::NormalResponse normal_response_along(const MdrCase& mdr) {
  auto path = *mdr.path;
  path.tangential_force = false;
  std::fill(path.tangential.begin(), path.tangential.end(), 0.0);
  auto [forces, error, course] = refined_until_known(
      [&](const mdr::SteppedPathForces& stepped) {
        return excess_of_normal_force(mdr, stepped.forces.normal_force_max, stepped.error.normal_force_max);
      },
      [&](int times) {
        const auto fineness = fineness_of(mdr, mdr::PathFineness{}, times);
        return mdr.layer ? layer_path_forces(mdr, 1, path, fineness)
                         : mdr::path_forces(mdr.profile, mdr.body, 1, path, fineness);
      });
  auto& history = course.history;
  const double start = history.time.front();
  for (double& time : history.time) time -= start;
  const double radius =
      unworn_radius_at(mdr, path.normal_force ? forces.largest_indentation : mdr::maximum_normal(path));
  std::optional<mdr::AxisPressure> pressure;
  const auto& force = history.normal_force;
  const bool loses_contact = *std::min_element(force.begin(), force.end()) <= 0;
  const auto g = [&](double x) { return mdr::transform(mdr.profile, x); };
  if (mdr::has_bounded_axis_pressure(g, radius, mdr.body, loses_contact))
    pressure = {forces.axis_pressure_max, error.axis_pressure_max};
  return {forces.normal_force_max,
          forces.normal_force_min,
          radius,
          pressure,
          std::move(history.time),
          std::move(history.indentation),
          std::move(history.normal_force),
          path.normal_force ? 0 : error.normal_force_max};
}

}  // namespace

mdr::NormalResponse mdr_normal_response(const MdrCase& mdr) {
  if (mdr.path) return normal_response_along(mdr);
  if (mdr.layer) return layer_normal_response(mdr);
  if (mdr.normal_force && !mdr.limiting)
    return mdr::forced_response(mdr.profile, mdr.body, 1, mdr.prescribed_normally(),
                                fineness_of(mdr, mdr::SpringFineness{}, 1))
        .response.normal;
  const auto motion = displacements_of(mdr);
  const auto response = [&](const std::function<double(double)>& g, double outer) {
    const auto& [indentation, normal, tangential, locked] = motion;
    if (normal.size() > 1) return mdr::stepped_normal_response(g, outer, mdr.body, motion);
    const auto& [amplitude, frequency, phase, across] = normal.front();
    return mdr::periodic_normal_response(g, outer, mdr.body, {indentation, amplitude, 0, frequency, frequency, {}},
                                         mdr::transform_kinks(mdr.profile));
  };
  if (mdr.limiting)
    return response([worn = *mdr.limiting](double x) { return mdr::transform(worn, x); }, mdr.limiting->stick_radius);
  return response([profile = mdr.profile](double x) { return mdr::transform(profile, x); },
                  mdr::inverse_transform(mdr.profile, mdr::maximum_indentation(motion)));
}

std::optional<mdr::LimitingProfile> worn_profile(const MdrCase& mdr, const std::optional<double>& shakedown_radius) {
  if (mdr.limiting || !shakedown_radius) return mdr.limiting;
  if (mdr.layer) return std::nullopt;  // it has a profile of its own (mdr::layer_limiting_profile)
  if (mdr.has_forces() && !mdr.limiting_state) return std::nullopt;
  if (mdr.has_forces())
    return mdr::limiting_profile(mdr.profile, mdr.limiting_state->stick_radius,
                                 mdr::maximum_indentation(mdr.limiting_state->motion));
  return mdr::limiting_profile(mdr.profile, *shakedown_radius, deepest_indentation(mdr));
}

bool MdrAnswer::wears_no_more() const {
  constexpr double roundoff = 1e-9;  // of the amplitude whose stick radius is asked for
  return stick_radius_shakedown && *stick_radius_shakedown >= (1 - roundoff) * contact_radius_max.value();
}

namespace {

/// The answer to the incompressible case, turned into that of the case itself: tangential displacements and works
/// change, forces do not.
MdrAnswer in_body_of_case(MdrAnswer answer, double displacement) {
  if (displacement == 1) return answer;
  if (answer.tangential_amplitude) *answer.tangential_amplitude /= displacement;
  if (answer.cycle) divide_works(displacement, *answer.cycle);
  return answer;
}

/// The answer to an oscillation by closed forms, on a worn or an unworn indenter.
MdrAnswer closed_answer(const MdrCase& mdr, const mdr::NormalResponse& normal) {
  return mdr.limiting ? worn_answer(mdr, normal) : displaced_answer(mdr, mdr.profile, mdr.motion, normal);
}

double modulus_ratio_of(const MdrCase& mdr) {
  return mdr.path ? std::nan("")
                  : mdr::modulus_ratio(mdr.body, mdr::angular_frequency(mdr.motion.normal.front().frequency));
}

MdrAnswer incompressible_answer(const MdrCase& mdr, const mdr::NormalResponse& normal) {
  const auto stepped = [&](int times) {
    if (moves_in_plane(mdr)) return plane_answer(mdr, normal, times);
    return mdr.path ? path_answer(mdr, normal, times) : forced_answer(mdr, normal, times);
  };
  const bool is_stepped = moves_in_plane(mdr) || mdr.path || mdr.layer || (mdr.has_forces() && !mdr.limiting);
  auto answer = is_stepped ? as_known_as_asked(mdr, stepped) : closed_answer(mdr, normal);
  answer.modulus_ratio = modulus_ratio_of(mdr);
  keep_to(mdr.motion_kind, answer);
  if (mdr.layer && mdr.path)
    answer.worn_radius = layer_worn_radius(mdr, answer.stick_radius_shakedown, mdr::maximum_normal(*mdr.path));
  if (const auto worn = worn_profile(mdr, answer.stick_radius_shakedown)) answer.worn_radius = worn->outer_radius;
  return answer;
}

/// The cycle under prescribed displacements, whose radii have closed forms: springs as fine as forces need.
std::optional<CycleReadings> displaced_cycle(const MdrCase& mdr, const mdr::NormalResponse& normal, int times) {
  if (mdr.path) {
    constexpr mdr::PathFineness usual{100, 90, 10, 1e-7};
    if (!has_cycle_along(mdr)) return std::nullopt;
    const auto stepped =
        mdr::path_forces(mdr.profile, mdr.body, mdr.friction_coefficient, *mdr.path, fineness_of(mdr, usual, times));
    return cycle_along(mdr, stepped, normal.normal_force_max);
  }
  constexpr mdr::SpringFineness usual{100, 90, 5, 1e-5};
  if (!cycle_to_step(mdr)) return std::nullopt;
  try {
    const auto stepped = mdr::forced_response(mdr.profile, mdr.body, mdr.friction_coefficient, mdr.prescribed(),
                                              fineness_of(mdr, usual, times));
    return cycle_of_springs(mdr, stepped, normal.normal_force_max);
  } catch (const std::runtime_error&) {
    return std::nullopt;  // not periodic
  }
}

}  // namespace

std::optional<SettlingCycles> settling_cycles(const MdrCase& mdr, const MdrAnswer& answer, int n_ramp) {
  const bool remembers = mdr.body.viscosity > 0 || !mdr.body.branch_moduli.empty();
  if (mdr.limiting || mdr.layer || mdr.path || !mdr.has_period() || !remembers || !answer.stick_radius_shakedown)
    return {};
  double amplitude = answer.tangential_amplitude.value_or(0) * mdr.displacement;
  if (!mdr.tangential_force)
    for (const auto& harmonic : mdr.motion.tangential) amplitude += harmonic.amplitude;
  const auto cycles_with = [&](mdr::SpringFineness fineness) {
    auto slips =
        mdr::slip_of_periods(mdr.profile, mdr.body, mdr.friction_coefficient, mdr.prescribed(),
                             *answer.stick_radius_shakedown, n_ramp, slip_that_counts_as_none * amplitude, fineness);
    for (auto& slip : slips) slip /= amplitude;
    return cycles_until(slips, slip_that_counts_as_none);
  };
  try {
    const auto coarse = cycles_with({80, 72, 0, 1e-5}), fine = cycles_with({160, 144, 0, 1e-5});
    if (!coarse || !fine) return {};
    return SettlingCycles{*fine, 3 * std::abs(*fine - *coarse)};
  } catch (const std::runtime_error&) {
    return {};  // not periodic
  }
}

MdrAnswer mdr_answer(const MdrCase& mdr, const mdr::NormalResponse& normal) {
  return in_body_of_case(incompressible_answer(mdr, normal), mdr.displacement);
}

MdrAnswer no_answer(const MdrCase& mdr) {
  MdrAnswer answer{};
  answer.modulus_ratio = modulus_ratio_of(mdr);
  answer.motion_kind = mdr.motion_kind;
  return answer;
}

MdrAnswer mdr_answer_with_cycle(const MdrCase& mdr, const mdr::NormalResponse& normal) {
  auto answer = incompressible_answer(mdr, normal);
  if (moves_in_plane(mdr)) return in_body_of_case(std::move(answer), mdr.displacement);
  if (mdr.layer) return answer;  // a decay of slip is of springs that do not know of each other
  if (!mdr.has_forces())
    answer = as_known_as_asked(mdr, [&](int times) {
      auto with_cycle = answer;
      with_cycle.cycle = displaced_cycle(mdr, normal, times);
      return with_cycle;
    });
  if (answer.cycle)
    answer.slip_decay =
        mdr::slip_decay(mdr.body, mdr.path ? mdr.path->duration() : 1 / mdr::common_cycle(mdr.motion)->frequency);
  return in_body_of_case(std::move(answer), mdr.displacement);
}

}  // namespace fretval
