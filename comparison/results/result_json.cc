#include <sys/resource.h>

#include "comparison/results/case_result.h"
#include "comparison/simulation/resolution_json.h"
#include "comparison/support/json.h"
#include "mdr/profiles/profile.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

const char* name_of(Case::Shape shape) {
  switch (shape) {
    case Case::Shape::parabola:
      return "parabola";
    case Case::Shape::cone:
      return "cone";
    case Case::Shape::power:
      return "power";
    case Case::Shape::rounded_flat:
      return "rounded flat";
    case Case::Shape::truncated_sphere:
      return "truncated sphere";
    case Case::Shape::table:
      break;
  }
  return "table";
}

ordered_json scene_json(const CaseResult& outcome) {
  const auto& scene = outcome.scene;
  const auto& motion = outcome.mdr_case.motion;
  ordered_json json{{"file", scene.file},
                    {"shape", name_of(scene.indenter.shape)},
                    {"rheology", scene.elastomer.rheology},
                    {"friction_coefficient", scene.friction_coefficient},
                    {"indentation", motion.indentation},
                    {"normal_amplitude", motion.normal_amplitude},
                    {"tangential_amplitude", motion.tangential_amplitude},
                    {"frequency", motion.normal_frequency},
                    {"phase", or_null(scene.motion.phase)},
                    {"wear", scene.wear == Case::Wear::limiting ? "limiting" : "unworn"},
                    {"contact_radius_at_rest", mdr::inverse_transform(outcome.mdr_case.profile, motion.indentation)},
                    {"contact_radius_unworn", outcome.fem_case.units.length},
                    {"tolerance", scene.tolerance}};
  if (outcome.mdr_case.limiting) json["stick_radius_of_profile"] = outcome.mdr_case.limiting->stick_radius;
  if (scene.sweep)
    json["sweep"] = {{"family", scene.sweep->family}, {"entry", scene.sweep->entry}, {"value", scene.sweep->value}};
  return json;
}

ordered_json bar_json(const std::optional<ErrorBar>& bar) {
  if (!bar) return nullptr;
  ordered_json shares = ordered_json::object();
  for (const auto& share : bar->shares)
    shares[name_of(share.source)] = {{"estimate", share.estimate}, {"order", or_null(share.order)}};
  return {{"total", bar->total()}, {"shares", shares}};
}

ordered_json fe_json(const FeAnswer& fe, const Comparison& verdict) {
  ordered_json json{{"contact_radius_max", or_null(fe.contact_radius_max)},
                    {"stick_radius_first_slip", or_null(fe.stick_radius_first_slip)},
                    {"stick_radius_shakedown", or_null(fe.stick_radius_shakedown)},
                    {"worn_radius", nullptr},
                    {"normal_force_max", fe.normal_force_max}};
  if (fe.no_wear) {
    json["slip_inside_stick_zone"] = fe.no_wear->slip_inside;
    json["force_outside_stick_zone"] = fe.no_wear->force_outside;
    json["touch_indentation"] = fe.no_wear->touch_indentation;
  }
  json["error_estimate"] = ordered_json::object();
  for (const auto& [quantity, difference] : verdict) json["error_estimate"][quantity] = bar_json(difference.bar);
  return json;
}

ordered_json verdict_json(const Comparison& verdict) {
  ordered_json json = ordered_json::object();
  for (const auto& [quantity, difference] : verdict)
    json[quantity] = {{"difference", or_null(difference.difference)},
                      {"tolerance", difference.tolerance},
                      {"error_bar", difference.bar ? ordered_json(difference.bar->total()) : ordered_json(nullptr)},
                      {"verdict", name_of(difference.finding)},
                      {"pass", difference.passes()}};
  return json;
}

ordered_json economised_json(const std::optional<CheapestProved>& cheapest) {
  if (!cheapest) return nullptr;
  auto resolutions = ordered_json::array();
  for (const auto& r : cheapest->resolutions) resolutions.push_back(resolution_json(r));
  return {{"resolutions", std::move(resolutions)}, {"error_bars", cheapest->bars}};
}

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

ordered_json result_json(const CaseResult& outcome) {
  const auto& [fe, normal, body, failure] = outcome.study.answer;
  return {{"name", outcome.scene.name},
          {"pass", passes(outcome.verdict)},
          {"scene", scene_json(outcome)},
          {"mdr", to_json(outcome.mdr)},
          {"fe", fe_json(fe, outcome.verdict)},
          {"comparison", verdict_json(outcome.verdict)},
          {"economised", economised_json(outcome.study.cheapest)},
          {"cost",
           {{"seconds",
             {{"mesh", body->cost.mesh},
              {"assembly", body->cost.assembly},
              {"factorisation", body->cost.factorisation},
              {"normal_history", normal->seconds},
              {"friction_history", fe.seconds}}},
            {"dofs", body->n_dofs},
            {"contact_nodes", body->n_contact_nodes},
            {"time_steps", fe.n_steps},
            {"cycles", fe.n_cycles},
            {"peak_memory_bytes", peak_memory_bytes()}}}};
}

}  // namespace fretval
