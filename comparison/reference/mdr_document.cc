#include "comparison/reference/mdr_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/reference/incompressible_case.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/reference/mdr_wear.h"
#include "comparison/reference/spring_agreement.h"
#include "comparison/support/constants.h"
#include "comparison/support/json.h"
#include "mdr/springs/path_response.h"
#include "mdr/stick/limiting_motion.h"
#include "mdr/stick/limiting_state.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

constexpr int n_profile_points = 200;

/// Whether forces are prescribed to an oscillation along x, for which the limiting state is known.
bool oscillates_under_forces(const Case& input) {
  const auto& motion = input.motion;
  return !motion.path && !motion.moves_across() && (motion.normal_force || motion.tangential_force);
}

double modulus_ratio_of(const Case& input, const mdr::Rheology& body) {
  return mdr::modulus_ratio(body, mdr::angular_frequency(input.motion.normal_frequency));
}

/// The answer to prescribed displacements, with any number of harmonics of any frequencies.
MdrDocument answer_displacements(const Case& input) {
  const auto profile = profile_of(input.indenter);
  const auto body = rheology_of(input.elastomer);
  const auto motion = harmonic_motion_of(input.motion);
  const double deepest = mdr::maximum_indentation(motion);
  const auto radii = mdr::stick_radii(profile, body, input.friction_coefficient, motion);
  MdrDocument document;
  if (radii.shakedown) document.worn = mdr::limiting_profile(profile, *radii.shakedown, deepest);
  MdrAnswer answer{};
  answer.modulus_ratio = modulus_ratio_of(input, body);
  answer.contact_radius_max = mdr::inverse_transform(profile, deepest);
  answer.stick_radius_first_slip = radii.first_slip;
  answer.stick_radius_shakedown = radii.shakedown;
  if (document.worn) answer.worn_radius = document.worn->outer_radius;
  document.json["mdr"] = to_json(answer);
  return document;
}

ordered_json state_json(const std::optional<mdr::LimitingState>& state) {
  if (!state) return nullptr;
  return {{"stick_radius", state->stick_radius},
          {"indentation", state->motion.indentation},
          {"normal_amplitude", state->motion.normal_amplitude},
          {"tangential_amplitude", state->motion.tangential_amplitude},
          {"phase", state->motion.phase ? ordered_json(*state->motion.phase * 180 / pi) : nullptr},
          {"normal_force_mean", state->mean_normal_force},
          {"normal_force_amplitude", state->normal_force_amplitude},
          {"tangential_force_amplitude", state->tangential_force_amplitude}};
}

double normal_force_max_of(const Case&, const mdr::LimitingState& state) {
  return state.mean_normal_force + state.normal_force_amplitude;
}

/// The largest normal force where it is prescribed; empty where the indentation is, for which springs have it.
std::optional<double> normal_force_max_of(const Case& input, const mdr::LimitingMotion&) {
  if (!input.motion.normal_force) return std::nullopt;
  return mdr::maximum_indentation(harmonic_motion_of(input.motion));
}

ordered_json state_json(const std::optional<mdr::LimitingMotion>& state) {
  if (!state) return nullptr;
  return {{"stick_radius", state->stick_radius}, {"indentation", state->motion.indentation}};
}

/// The answer to a prescribed force: the fully worn contact, in which forces and displacements are linear in each
/// other. state_of(profile, body, criterion): the limiting state by a criterion.
template <class StateOf>
MdrDocument answer_by_limiting_state(const Case& input, const StateOf& state_of) {
  const auto profile = profile_of(input.indenter);
  const auto body = rheology_of(input.elastomer);
  const auto first_slip = state_of(profile, body, mdr::StickCriterion::first_slip);
  const auto shakedown = state_of(profile, body, mdr::StickCriterion::shakedown);
  MdrDocument document;
  MdrAnswer answer{};
  answer.modulus_ratio = modulus_ratio_of(input, body);
  if (first_slip) answer.stick_radius_first_slip = first_slip->stick_radius;
  if (shakedown) {
    document.worn =
        mdr::limiting_profile(profile, shakedown->stick_radius, mdr::maximum_indentation(shakedown->motion));
    answer.contact_radius_max = answer.stick_radius_shakedown = shakedown->stick_radius;
    answer.worn_radius = document.worn->outer_radius;
    answer.normal_force_max = normal_force_max_of(input, *shakedown);
  }
  document.json["mdr"] = to_json(answer);
  document.json["limiting_state"] = {{"first_slip", state_json(first_slip)}, {"shakedown", state_json(shakedown)}};
  return document;
}

MdrDocument answer_forces(const IncompressibleCase& equivalent) {
  const auto& input = equivalent.input;
  const auto control = control_of({harmonic_motion_of(input.motion), input.motion.normal_force.has_value(),
                                   input.motion.tangential_force.has_value()});
  return answer_by_limiting_state(input, [&](const auto& profile, const auto& body, mdr::StickCriterion criterion) {
    auto state = mdr::limiting_state(profile, body, input.friction_coefficient, control, criterion);
    if (state) state->motion.tangential_amplitude /= equivalent.displacement;
    return state;
  });
}

/// Whether the limiting state is known in closed form.
bool has_one_frequency(const Case::Motion& motion) {
  return (motion.normal_frequency == motion.tangential_frequency || !motion.phase) && motion.normal_harmonics.empty() &&
         motion.tangential_harmonics.empty();
}

/// Prescribed forces with several harmonics or frequencies, whose limiting state has no closed form.
MdrDocument answer_harmonics_of_forces(const Case& input) {
  const auto motion = harmonic_motion_of(input.motion);
  const bool normal = input.motion.normal_force.has_value(), tangential = input.motion.tangential_force.has_value();
  return answer_by_limiting_state(input, [&](const auto& profile, const auto& body, mdr::StickCriterion criterion) {
    return mdr::limiting_motion(profile, body, input.friction_coefficient, motion, normal, tangential, criterion);
  });
}

MdrDocument answer_comparable(const Case& input) {
  const auto mdr = mdr_case(input);
  const auto answer = mdr_answer_with_cycle(mdr, mdr_normal_response(mdr));
  MdrDocument document;
  document.worn = worn_profile(mdr, answer.stick_radius_shakedown);
  document.json["mdr"] = to_json(answer);
  return document;
}

ordered_json profile_json(const std::optional<mdr::LimitingProfile>& worn) {
  if (!worn) return nullptr;
  std::vector<double> r, f;
  const double end = std::min(1.1 * worn->outer_radius, mdr::end_radius(worn->unworn));
  for (int i = 0; i <= n_profile_points; ++i) {
    r.push_back(end * i / n_profile_points);
    f.push_back(mdr::shape(*worn, r.back()));
  }
  return {{"criterion", "shakedown"}, {"r", r}, {"f", f}};
}

/// closed_form: the stick radii as they stand in the document.
ordered_json springs_json(const Case& input, const ordered_json& closed_form) {
  const auto answer = spring_answer(input);
  const auto& history = answer.history;
  const auto profile = profile_of(input.indenter);
  const auto radius = [&](double depth) {
    return depth > 0 ? ordered_json(mdr::inverse_transform(profile, depth)) : ordered_json(nullptr);
  };
  const auto known = [&](const char* key) {
    return closed_form[key].is_null() ? std::nullopt : std::optional(closed_form[key].get<double>());
  };
  // Under a force the first-slip radius of the closed form belongs to the worn contact, that of the springs to the
  // unworn one.
  const bool forces = oscillates_under_forces(input);
  const auto agreement = spring_agreement(answer.bed, history, profile,
                                          {known("stick_radius_first_slip"), known("stick_radius_shakedown"), !forces});
  return {{"springs", answer.bed.position.size()},
          {"steps_per_period", answer.steps_per_period},
          {"periods", history.n_periods},
          {"stick_radius_first_slip", radius(history.depths.first_slip)},
          {"stick_radius_shakedown", radius(history.depths.shakedown)},
          {"normal_force_max", *std::max_element(history.normal_force.begin(), history.normal_force.end())},
          {"friction_work", history.friction_work},
          {"bulk_work", history.bulk_work},
          {"indenter_work", history.indenter_work},
          {"difference_first_slip", or_null(agreement.first_slip)},
          {"difference_shakedown", agreement.shakedown},
          {"slip_inside", agreement.slip_inside},
          {"warnings", agreement.warnings}};
}

ordered_json wear_json(const Case& input) {
  const auto kinetics = wear_kinetics_of(input, mdr_case(input), *input.wear_kinetics->n_cycles);
  if (!kinetics)
    throw InputError(
        fmt::format("{}: Wear / Cycles = {:g}: springs have the course of wear of an unworn indenter under one "
                    "oscillation in each direction, of the same frequency and locked, by the laws archard and energy; "
                    "leave it out, or let finite elements run it (fretval run)",
                    input.file, *input.wear_kinetics->n_cycles));
  return to_json(*kinetics);
}

void require_body_of_mdr(const Case& input) {
  const auto shape = input.body.shape;
  if (shape != Case::Body::Shape::layer && !input.body.is_half_space())
    throw InputError(
        fmt::format("{}: Body / Shape = {}: MDR knows half-spaces and layers; leave it out to see what it says of a "
                    "half-space, or run the case",
                    input.file, Case::Body::shape_names[static_cast<std::size_t>(shape)]));
}

void require_springs(const Case& input) {
  if (const auto why = why_no_springs(input); !why.empty()) throw InputError(input.file + ": " + why);
}

MdrDocument answer_to(const Case& input_of_any_body) {
  if (input_of_any_body.body.shape == Case::Body::Shape::layer) return answer_comparable(input_of_any_body);
  const auto equivalent = incompressible_case(input_of_any_body);
  const auto& input = equivalent.input;
  if (oscillates_under_forces(input))
    return has_one_frequency(input.motion) ? answer_forces(equivalent) : answer_harmonics_of_forces(input);
  // The stick radii of a fractional body need no approximation of it.
  const bool is_exact = input.elastomer.fractional_order > 0 && input.wear == Case::Wear::unworn;
  const bool has_forces = input.motion.path || (is_comparable(input) && !is_exact);
  return has_forces ? answer_comparable(input_of_any_body) : answer_displacements(input);
}

SpringAnswer springs_along_path(const Case& input, const SpringSetting& setting) {
  const auto mdr = mdr_case(input);
  auto [bed, history] =
      mdr::path_course(mdr.profile, mdr.body, mdr.friction_coefficient, mdr.path.value(),
                       {setting.n_springs, setting.steps_per_cycle, setting.n_ramp_periods, setting.periodicity});
  const auto n_steps = static_cast<int>(history.time.size()) - 1;
  return {std::move(bed), std::move(history), n_steps};
}

SpringAnswer springs_of_oscillation(const Case& input, const SpringSetting& setting) {
  const auto body = body_in_time(input);
  const auto profile = profile_of(input.indenter);
  const mdr::Prescribed prescribed{harmonic_motion_of(input.motion), input.motion.normal_force.has_value(),
                                   input.motion.tangential_force.has_value()};
  const auto repeating = mdr::repeating_motion(prescribed.motion, setting.n_oscillations);
  const double period = repeating.period();
  const int n_ramp = repeating.periods_with(setting.n_ramp_periods),
            steps = setting.steps_per_cycle *
                    static_cast<int>(std::lround(mdr::highest_frequency(repeating.motion) * period));
  const double outer = 1.001 * mdr::inverse_transform(profile, mdr::deepest_indentation(profile, body, prescribed));
  auto bed = mdr::spring_bed(profile, std::min(outer, mdr::end_radius(profile)), setting.n_springs);
  auto history = mdr::spring_history(bed, body, input.friction_coefficient,
                                     mdr::loading_of(prescribed, repeating, n_ramp * period),
                                     {period, steps, n_ramp, 2000, setting.periodicity});
  return {std::move(bed), std::move(history), steps};
}

/// Turns a history of the incompressible springs that stand for those of a case (IncompressibleCase) into that of the
/// case: tangential displacements and works change, forces do not.
void turn_into_body_of_case(double displacement, mdr::SpringHistory& history) {
  const double normal_loss = history.bulk_work + history.friction_work - history.tangential_work,
               normal_work = history.indenter_work - history.tangential_work;
  for (double* value : {&history.largest_shift, &history.friction_work, &history.tangential_work})
    *value /= displacement;
  for (double& value : history.tangential_displacement) value /= displacement;
  history.slip_amplitude /= displacement;
  for (auto& slip : history.slip_of_periods) slip /= displacement;
  history.bulk_work = normal_loss + history.tangential_work - history.friction_work;
  history.indenter_work = normal_work + history.tangential_work;
}

}  // namespace

ordered_json fit_json(const Case::Elastomer& elastomer) {
  const auto& curve = *elastomer.master_curve;
  ordered_json check;
  if (curve.kramers_kronig)
    check = {{"consistent", curve.kramers_kronig->consistent},
             {"worst", curve.kramers_kronig->worst},
             {"worst_frequency", curve.kramers_kronig->frequency_at_worst}};
  return {{"table", curve.table},
          {"frequencies", curve.frequency.size()},
          {"relaxed_modulus", elastomer.relaxed_modulus},
          {"branch_moduli", elastomer.branch_moduli},
          {"branch_times", elastomer.branch_times},
          {"residual", curve.residual},
          {"held_out", curve.held_out},
          {"worst", curve.worst},
          {"worst_frequency", curve.worst_frequency},
          {"kramers_kronig", check}};
}

MdrDocument mdr_document(const Case& input, bool with_springs) {
  require_body_of_mdr(input);
  if (with_springs) require_springs(input);
  try {
    (void)profile_of(input.indenter);  // refuses one that MDR does not hold for, before anything is asked of it
    auto document = answer_to(input);
    ordered_json json{{"name", input.name}};
    json.update(document.json);
    json["limiting_profile"] = profile_json(document.worn);
    if (input.elastomer.master_curve) json["elastomer"] = fit_json(input.elastomer);
    if (with_springs) json["springs"] = springs_json(input, document.json["mdr"]);
    if (input.wear_kinetics && input.wear_kinetics->n_cycles) json["wear"] = wear_json(input);
    document.json = std::move(json);
    return document;
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", input.file, error.what()));
  }
}

std::string why_no_springs(const Case& input) {
  if (input.wear == Case::Wear::limiting) return "Wear / State = limiting: springs are stepped for an unworn indenter";
  if (!input.body.is_half_space())
    return fmt::format(
        "Body / Shape = {}: springs are stepped for a half-space; leave --springs and --fields out, or "
        "run the case with Output / Fields",
        Case::Body::shape_names[static_cast<std::size_t>(input.body.shape)]);
  if (input.motion.moves_across())
    return "Motion: the indenter moves along x and y, of which springs of one direction know nothing; MDR's answer is "
           "that of springs already, so leave --springs and --fields out";
  return "";
}

SpringAnswer spring_answer(const Case& input_of_any_body, const SpringSetting& setting) {
  require_springs(input_of_any_body);
  const auto [input, displacement] = incompressible_case(input_of_any_body);
  auto answer = input.motion.path ? springs_along_path(input, setting) : springs_of_oscillation(input, setting);
  if (displacement != 1) turn_into_body_of_case(displacement, answer.history);
  return answer;
}

}  // namespace fretval
