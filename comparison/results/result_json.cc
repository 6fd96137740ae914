#include <sys/resource.h>

#include "comparison/accuracy/fe_readings.h"
#include "comparison/case_file/case_sections.h"
#include "comparison/quantities/reading.h"
#include "comparison/reference/mdr_document.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/reference/sensitivity.h"
#include "comparison/results/answer_text.h"
#include "comparison/results/case_inputs.h"
#include "comparison/results/case_result.h"
#include "comparison/results/results_folder.h"
#include "comparison/simulation/fem_case/resolution.h"
#include "comparison/support/constants.h"
#include "comparison/support/json.h"
#include "mdr/motion/force_control.h"
#include "mdr/profiles/profile.h"
#include "meshes/mesh.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

/// Amplitudes in m, frequencies in Hz, phases in degrees from an instant of largest indentation.
ordered_json harmonics_json(const std::vector<mdr::Harmonic>& harmonics) {
  auto json = ordered_json::array();
  for (const auto& [amplitude, frequency, phase, across] : harmonics)
    json.push_back({{"amplitude", amplitude}, {"frequency", frequency}, {"phase", phase * 180 / pi}});
  return json;
}

ordered_json path_json(const Case::Path& path) {
  ordered_json json{{"file", path.file},
                    {"columns", {"t", path.normal_force ? "F_N" : "d", path.tangential_force ? "F_x" : "u_x"}},
                    {"rows", path.time.size()},
                    {"duration", path.duration()}};
  return json;
}

/// A mesh that the case has brought along.
ordered_json mesh_json(const Case::Body& body) {
  ordered_json materials = ordered_json::array();
  const auto moduli = moduli_of_materials(body);
  for (std::size_t i = 0; i < moduli.size(); ++i)
    materials.push_back({{"name", body.grid->materials[i]}, {"relative_modulus", moduli[i]}});
  return {{"file", body.mesh},
          {"content", body.mesh_hash},
          {"cells", body.grid->cells.size()},
          {"contact_edges", meshes::contact_radii(*body.grid).size() - 1},
          {"contact_line", meshes::contact_radii(*body.grid).back() * body.mesh_unit},
          {"thickness", body.thickness},
          {"materials", std::move(materials)}};
}

/// The radius of the unworn contact at rest; null: MDR, which knows it, does not hold.
ordered_json radius_at_rest(const CaseResult& result, double normal_motion) {
  const auto& mdr = result.mdr_case;
  if (!result.is_compared()) return nullptr;
  return unworn_radius_at(
      mdr, mdr.normal_force
               ? mdr::indentation_for_force(mdr.profile, result.input.elastomer.relaxed_modulus, normal_motion)
               : normal_motion);
}

double unworn_radius(const CaseResult& result) {
  if (!result.is_compared()) return result.fe.fe.contact_radius_max.value();
  return result.mdr_case.layer ? result.mdr.contact_radius_max.value() : result.fem_case.units.length;
}

ordered_json case_json(const CaseResult& result) {
  const auto& input = result.input;
  const auto motion = motion_of_case(input.motion, limiting_indenter(result.mdr_case));
  const bool normal_force = result.mdr_case.normal_force, tangential_force = result.mdr_case.tangential_force;
  const auto kind = motion_kind_of(input.motion);
  const auto frequency_of = [&](const std::vector<mdr::Harmonic>& harmonics) {
    return is_pass(kind) ? ordered_json(nullptr) : ordered_json(harmonics.front().frequency);
  };
  ordered_json json{{"file", input.file},
                    {"shape", Case::shape_names[static_cast<std::size_t>(input.indenter.shape)]},
                    {"rheology", input.elastomer.rheology_name()},
                    {"friction_coefficient", input.friction_coefficient},
                    {"frequency", frequency_of(motion.normal)},
                    {"tangential_frequency", frequency_of(motion.tangential)},
                    {"has_period", !is_pass(kind) && result.fem_case.has_period()},
                    {"phase", input.motion.path ? ordered_json(nullptr) : or_null(input.motion.phase)},
                    {"wear", input.wear == Case::Wear::limiting ? "limiting" : "unworn"},
                    {"contact_radius_at_rest", radius_at_rest(result, motion.indentation)},
                    {"contact_radius_unworn", unworn_radius(result)},
                    {"tolerance", input.tolerance}};
  json[normal_force ? "normal_force_mean" : "indentation"] = motion.indentation;
  json[normal_force ? "normal_force_amplitude" : "normal_amplitude"] = motion.normal.front().amplitude;
  json[tangential_force ? "tangential_force_amplitude" : "tangential_amplitude"] = motion.tangential.front().amplitude;
  if (motion.normal.size() > 1) json["normal_harmonics"] = harmonics_json(motion.normal);
  if (motion.tangential.size() > 1) json["tangential_harmonics"] = harmonics_json(motion.tangential);
  if (result.mdr_case.path) {
    json["path"] = path_json(*input.motion.path);
    add_motion_kind(kind, json["path"]);
    if (!normal_force) json["indentation_max"] = mdr::maximum_normal(*result.mdr_case.path);
  }
  if (result.mdr_case.limiting) json["stick_radius_of_profile"] = result.mdr_case.limiting->stick_radius;
  if (const auto& wear = input.wear_kinetics) {
    json["indentation_max"] = result.fem_case.units.depth;
    json["wear_law"] = {{"law", Case::wear_law_names[static_cast<std::size_t>(wear->law)]},
                        {"coefficient", wear->coefficient},
                        {"exponent", wear->exponent},
                        {"cycles", or_null(wear->n_cycles)},
                        {"until", wear->until}};
    if (wear->has_worn_before()) json["wear_law"]["profile"] = wear->rings.empty() ? wear->profile : wear->rings;
  }
  if (input.body.grid) json["mesh"] = mesh_json(input.body);
  json["inputs"] = inputs_json(input);
  if (input.elastomer.master_curve) json["fit_of_moduli"] = fit_json(input.elastomer);
  if (auto data = data_json(input); !data.empty()) json["data"] = std::move(data);
  if (const auto& sweep = input.sweep) {
    json["sweep"] = {{"family", sweep->family}, {"entry", sweep->entry}, {"value", sweep->value}};
    if (!sweep->second_entry.empty()) {
      json["sweep"]["second_entry"] = sweep->second_entry;
      json["sweep"]["second_value"] = sweep->second_value;
    }
  }
  return json;
}

ordered_json bar_json(const std::optional<ErrorBar>& bar) {
  if (!bar) return nullptr;
  ordered_json shares = ordered_json::object();
  for (const auto& share : bar->shares)
    shares[name_of(share.source)] = {{"estimate", share.estimate}, {"order", or_null(share.order)}};
  return {{"total", bar->total()}, {"shares", shares}};
}

/// Whether the contact is lost in every cycle.
bool loses_contact(const fem::NormalHistory& normal) {
  const auto n = std::min<Eigen::Index>(normal.force.size(), normal.steps_per_cycle);
  return n > 0 && normal.pieces.empty() && normal.force.tail(n).minCoeff() <= 0;
}

ordered_json fe_json(const CaseResult& result) {
  const auto& fe = result.fe.fe;
  const auto& units = result.fem_case.units;
  auto readings = readings_of(fe, units);
  readings.erase(Quantity::maximum_indentation);  // has a key of its own
  readings[Quantity::worn_radius] = {{}, {}, "finite elements did not wear the indenter"};
  if (result.wear) readings[Quantity::worn_radius] = {result.wear->fe.worn_radius * units.length};
  ordered_json json;
  add_readings(readings, json);
  if (const auto* worn = fe.as<NoWearEvidence>()) json["touch_indentation"] = worn->touch_indentation;
  if (const auto* slip = fe.as<GrossSlipStart>())
    json["gross_slip"] = {{"time", slip->time}, {"amplitude", slip->amplitude}};
  json["lifts_off"] = loses_contact(fe.normal);
  if (fe.cycle) {
    json["sliding_force"] = fe.cycle->sliding_force;
    json["sliding_work"] = fe.cycle->sliding_work;
  }
  json["error_estimate"] = ordered_json::object();
  for (const auto& [quantity, difference] : result.comparison)
    json["error_estimate"][name_of(quantity)] = bar_json(difference.bar);
  if (const auto zones = zones_json(result); !zones.is_null()) {
    json["zones"] = zones;
    for (const auto& [quantity, bar] : result.fe.budget)
      if (json["error_estimate"].find(name_of(quantity)) == json["error_estimate"].end())
        json["error_estimate"][name_of(quantity)] = bar_json(bar);
  }
  if (result.wear) json["wear"] = to_json(*result.wear, units);
  if (result.surface_wear) json["surface_wear"] = to_json(*result.surface_wear, units);
  if (result.rings)
    json["rings"] = {{"in_contact", result.rings->in_contact}, {"needed", or_null(result.rings->needed)}};
  return json;
}

ordered_json comparison_json(const Comparison& comparison) {
  ordered_json json = ordered_json::object();
  for (const auto& [quantity, difference] : comparison)
    json[name_of(quantity)] = {
        {"difference", or_null(difference.difference)},
        {"tolerance", difference.tolerance},
        {"error_bar", difference.bar ? ordered_json(difference.bar->total()) : ordered_json(nullptr)},
        {"mdr_error", difference.mdr_error},
        {"asked", difference.asked},
        {"verdict", difference.verdict ? ordered_json(name_of(*difference.verdict)) : ordered_json(nullptr)},
        {"pass", difference.verdict.value_or(Verdict::agree) == Verdict::agree}};
  return json;
}

ordered_json to_json(const ProofCost& cost) {
  return {{"seconds", cost.seconds},   {"time_steps", cost.time_steps},
          {"cycles", cost.cycles},     {"computations", cost.computations},
          {"bodies", cost.bodies.all}, {"bodies_from_store", cost.bodies.from_store}};
}

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

ordered_json model_json(const ModelErrors& model) {
  ordered_json json{{"good_to", or_null(model.good_to())}};
  if (!model.outside.empty()) json["outside"] = model.outside;
  json["mdr_off_by"] = ordered_json::object();
  for (const auto& [quantity, error] : model.off_by)
    json["mdr_off_by"][name_of(quantity)] = {{"value", error.value}, {"uncertainty", error.uncertainty}};
  return json;
}

}  // namespace

ordered_json result_json(const CaseResult& result) {
  const auto& fe = result.fe.fe;
  auto cost = cost_json(fe);
  cost["computations"] = result.fe.cost.computations;
  cost["bodies"] = result.fe.cost.bodies.all;
  cost["bodies_from_store"] = result.fe.cost.bodies.from_store;
  auto all = result.fe.cost;
  if (result.wear) all = all + result.wear->cost;
  if (result.surface_wear) all = all + result.surface_wear->cost;
  cost["all"] = to_json(all);
  cost["peak_memory_bytes"] = peak_memory_bytes();
  const auto outcome = outcome_of(result);
  auto mdr = to_json(result.mdr);
  if (const auto found = sensitivities(result.input)) mdr["sensitivity"] = to_json(*found);
  if (result.wear && result.wear->kinetics) mdr["wear"] = to_json(*result.wear->kinetics);
  ordered_json json{{"schema", result_schema},
                    {"name", result.input.name},
                    {"pass", passes(outcome)},
                    {"verdict", name_of(outcome)},
                    {"proof", name_of(result.proof)},
                    {"scene", case_json(result)},
                    {"mdr", std::move(mdr)},
                    {"fe", fe_json(result)},
                    {"comparison", comparison_json(result.comparison)}};
  if (const auto reasons = beyond_mdr_model(result.input); !reasons.empty()) json["other_model"] = reasons;
  if (auto measured = measured_json(result.input, json["fe"], json["mdr"]); !measured.is_null())
    json["measured"] = std::move(measured);
  if (result.is_compared())
    json["model"] = model_json(result.model);
  else
    json["not_compared"] = not_compared_json(result);
  if (result.half_space) json["mdr_half_space"] = to_json(*result.half_space);
  json["cost"] = std::move(cost);
  return json;
}

ordered_json cost_json(const FeAnswer& fe) {
  const auto& body = *fe.body;
  return {{"seconds",
           {{"mesh", body.cost.mesh},
            {"assembly", body.cost.assembly},
            {"factorisation", body.cost.factorisation},
            {"reading", body.cost.reading},
            {"normal_history", fe.seconds.normal},
            {"friction_history", fe.seconds.friction}}},
          {"dofs", body.n_dofs},
          {"contact_nodes", body.n_contact_nodes},
          {"time_steps", fe.n_steps},
          {"cycles", fe.n_cycles}};
}

}  // namespace fretval
