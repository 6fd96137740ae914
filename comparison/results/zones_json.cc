#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/case/table_noise.h"
#include "comparison/results/case_result.h"
#include "comparison/support/constants.h"
#include "mdr/profiles/naive_contact.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

ordered_json total_of(const std::optional<ErrorBar>& bar, double unit) {
  return bar && std::isfinite(bar->total()) ? ordered_json(bar->total() * unit) : ordered_json(nullptr);
}

ordered_json annuli_json(const std::vector<fem::Annulus>& annuli, const std::vector<AnnulusBar>& bars, double length) {
  auto list = ordered_json::array();
  for (std::size_t k = 0; k < annuli.size(); ++k) {
    const auto bar = k < bars.size() ? bars[k] : AnnulusBar{};
    list.push_back({{"inner", annuli[k].inner},
                    {"outer", annuli[k].outer},
                    {"inner_bar", total_of(bar.inner, length)},
                    {"outer_bar", total_of(bar.outer, length)}});
  }
  return list;
}

/// Why a zone has no radius; null: it is one disc, and has a radius.
ordered_json why_no_radius(const std::vector<fem::Annulus>& zone) {
  if (zone.empty()) return "nothing sticks";
  if (zone.size() > 1) return fmt::format("{} annuli stick", zone.size());
  return zone.front().inner > 0 ? ordered_json("an annulus sticks, and no disc") : ordered_json(nullptr);
}

}  // namespace

ordered_json zones_json(const ZoneAnswer& zones, const std::optional<ZoneBudget>& bars, double length) {
  const auto known = bars.value_or(ZoneBudget{});
  return {{"contact", annuli_json(zones.contact, known.contact, length)},
          {"first_slip", annuli_json(zones.first_slip, known.first_slip, length)},
          {"shakedown", annuli_json(zones.shakedown, known.shakedown, length)},
          {"why_no_radius",
           {{"first_slip", why_no_radius(zones.first_slip)}, {"shakedown", why_no_radius(zones.shakedown)}}},
          {"contact_uncertainty", zones.contact_uncertainty},
          {"pressure_max", zones.pressure_max},
          {"pressure_max_bar", bars ? total_of(known.pressure_max, zones.pressure_max) : ordered_json(nullptr)}};
}

namespace {

ordered_json zones_json(const SurfaceAnswer& surface, MotionKind kind, const ErrorBudget& budget, double length) {
  const auto bar_of = [&](Quantity quantity) {
    const auto bar = budget.find(quantity);
    return total_of(bar == budget.end() ? std::nullopt : std::optional(bar->second), length);
  };
  const auto with_bars = [](const PlaneZone& zone, const ordered_json& radius, const ordered_json& along,
                            const ordered_json& across) {
    return ordered_json{
        {"area", zone.area},
        {"area_bar", radius.is_null() ? radius : ordered_json(2 * pi * zone.radius * radius.get<double>())},
        {"radius", zone.radius},
        {"radius_bar", radius},
        {"along", zone.along},
        {"along_bar", along},
        {"across", zone.across},
        {"across_bar", across}};
  };
  const auto zone_json = [&](const PlaneZone& zone, Quantity radius, Quantity along, Quantity across) {
    return with_bars(zone, bar_of(radius), bar_of(along), bar_of(across));
  };
  using Q = Quantity;
  ordered_json json{{"contact", zone_json(surface.contact, Q::contact_radius_max, Q::contact_along, Q::contact_across)},
                    {"never_slipped", zone_json(surface.never_slipped, Q::stick_radius_first_slip, Q::first_slip_along,
                                                Q::first_slip_across)}};
  const auto& end = surface.sticks_at_the_end;
  if (is_pass(kind))
    json["sticks_at_the_end"] = with_bars(end, end.uncertainty, end.edge_uncertainty, end.edge_uncertainty);
  else
    json["sticks_in_a_cycle"] =
        zone_json(surface.sticks_in_a_cycle, Q::stick_radius_shakedown, Q::shakedown_along, Q::shakedown_across);
  json["torque_max"] = surface.torque_max;
  if (const auto& second = surface.history.second_difference) json["second_algorithm"] = *second;
  return json;
}

}  // namespace

ordered_json zones_json(const CaseResult& result) {
  const auto& fe = result.fe.fe;
  const double length = result.fem_case.units.length;
  if (const auto* surface = fe.as<SurfaceAnswer>())
    return zones_json(*surface, fe.motion_kind, result.fe.budget, length);
  const auto* zones = fe.as<ZoneAnswer>();
  return zones ? zones_json(*zones, result.fe.zone_bars, length) : ordered_json(nullptr);
}

ordered_json not_compared_json(const CaseResult& result) {
  const auto& mdr = result.mdr_case;
  auto falls = ordered_json::array();
  for (const auto& [from, to] : mdr.falls()) falls.push_back({{"from", from}, {"to", to}});
  const double depth = result.fem_case.units.depth;
  const auto springs = mdr::naive_contact(mdr.profile, depth);
  const double force_of_springs = springs.force_over_modulus * mdr.body.relaxed_modulus;
  const auto& fe = std::get<ZoneAnswer>(result.fe.fe.of_kind);
  ordered_json json{{"reason", "MDR does not hold for this profile"},
                    {"image_falls", falls},
                    {"at_rest",
                     {{"indentation", depth},
                      {"normal_force", fe.force_at_rest},
                      {"contact_radius", fe.radius_at_rest},
                      {"normal_force_of_springs", force_of_springs},
                      {"contact_radius_of_springs", springs.radius},
                      {"normal_force_difference", force_of_springs / fe.force_at_rest - 1},
                      {"contact_radius_difference", springs.radius / fe.radius_at_rest - 1}}}};
  if (const auto noise = noise_behind_falls(result.input.indenter)) json["table_noise"] = *noise;
  return json;
}

}  // namespace fretval
