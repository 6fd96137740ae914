#include "comparison/trust/ladder_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "comparison/results/answer_text.h"
#include "comparison/results/case_inputs.h"
#include "comparison/support/json.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

/// A share in percent with as many digits as its uncertainty allows, at most three: "-20.4 %".
std::string percent(double share, double uncertainty, bool with_sign = true) {
  const double largest = std::max(std::abs(share), 1e-300);
  const int digits =
      uncertainty > 0 ? std::clamp(static_cast<int>(std::floor(std::log10(largest / uncertainty))) + 2, 1, 3) : 3;
  return with_sign ? fmt::format("{:+.{}g} %", 100 * share, digits) : fmt::format("{:.{}g} %", 100 * share, digits);
}

/// A radius of the headline, as a sentence calls it.
struct NamedRadius {
  Quantity quantity;
  const char* name;
};

/// The radius of the headline, the one that a user asks for first.
std::optional<NamedRadius> radius_of_headline(const Ladder& ladder) {
  for (const auto& radius : {NamedRadius{Quantity::stick_radius_shakedown, "shakedown radius"},
                             NamedRadius{Quantity::stick_radius_first_slip, "first-slip radius"},
                             NamedRadius{Quantity::contact_radius_max, "contact radius"}})
    if (ladder.whole.off_by.count(radius.quantity) > 0) return radius;
  return std::nullopt;
}

/// What a rung stands for; for a body with the size of the contact against it.
std::string reason_of(const Rung& rung, double contact_radius) {
  const auto& body = rung.input.body;
  if (body.is_half_space()) return rung.title;
  return fmt::format("{}, a/H = {:.2g}", rung.title, contact_radius / body.thickness);
}

/// What MDR is off by because of all assumptions together beyond the sum of the rungs; the bars of both add up.
std::optional<OffBy> interaction_in(const Ladder& ladder, Quantity quantity) {
  if (ladder.rungs.size() < 2) return std::nullopt;
  auto rest = ladder.whole.off_by.at(quantity);
  for (const auto& rung : ladder.rungs) {
    const auto found = rung.off_by.find(quantity);
    if (found == rung.off_by.end()) return std::nullopt;
    rest.value -= found->second.value;
    rest.uncertainty += found->second.uncertainty;
  }
  return rest;
}

std::string off_by_text(const OffBy& one) {
  return one.is_resolved() ? percent(one.value, one.uncertainty)
                           : fmt::format("within {:.2g} %", 100 * one.uncertainty);
}

std::string off_by_text(const OffBys& all, Quantity quantity) {
  const auto found = all.find(quantity);
  return found == all.end() ? "" : off_by_text(found->second);
}

ordered_json off_by_json(const OffBy& one) {
  return {{"value", one.value}, {"uncertainty", one.uncertainty}, {"resolved", one.is_resolved()}};
}

ordered_json off_by_json(const OffBys& all) {
  ordered_json json = ordered_json::object();
  for (const auto quantity : quantities_by_interest)
    if (const auto found = all.find(quantity); found != all.end()) json[name_of(quantity)] = off_by_json(found->second);
  return json;
}

ordered_json fe_json(const OffBys& all) {
  ordered_json json = ordered_json::object();
  for (const auto quantity : quantities_by_interest)
    if (const auto found = all.find(quantity); found != all.end())
      json[name_of(quantity)] = {{"value", found->second.fe.value.value()},
                                 {"uncertainty", found->second.fe.uncertainty.value_or(0)}};
  return json;
}

std::string column(const std::string& text, std::size_t width) {
  // Letters of two bytes take one column.
  const auto n = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; }));
  return text + std::string(n < width ? width - n : 1, ' ');
}

/// Where MDR's own model has the case on the maps of its error.
ordered_json place_json(const Case& input, const Ladder& ladder) {
  const auto value = [&](Quantity quantity) {
    const auto found = ladder.mdr.find(quantity);
    return found == ladder.mdr.end() ? std::nullopt : found->second.value;
  };
  const auto a = value(Quantity::contact_radius_max);
  ordered_json json{{"phase", or_null(input.motion.phase)},
                    {"poisson_ratio", input.elastomer.poisson_ratio},
                    {"radius_over_thickness", input.body.is_half_space() || !a ? 0 : *a / input.body.thickness}};
  for (const auto quantity : {Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown})
    if (const auto c = value(quantity); c && a) json[name_of(quantity)] = *c / *a;
  return json;
}

ordered_json edges_json(const PlaneEdges& edges) {
  ordered_json json{{"angle", edges.angle}, {"contact", edges.contact}, {"never_slipped", edges.never_slipped}};
  if (!edges.sticks_in_a_cycle.empty()) json["sticks_in_a_cycle"] = edges.sticks_in_a_cycle;
  return json;
}

constexpr std::size_t title_width = 31, value_width = 27, share_width = 18;

std::string row_of(const Ladder& ladder, Quantity quantity) {
  const auto& traits = traits_of(quantity);
  const auto& fe = ladder.whole.off_by.at(quantity).fe;
  const auto& mdr = ladder.mdr.at(quantity);
  auto line = "  " + column(traits.title, title_width) +
              column(with_unit(*mdr.value, mdr.uncertainty.value_or(0), traits.unit), value_width) +
              column(with_unit(*fe.value, fe.uncertainty.value_or(0), traits.unit), value_width) +
              column(off_by_text(ladder.whole.off_by, quantity), share_width);
  if (ladder.rungs.size() > 1)
    for (const auto& rung : ladder.rungs) line += column(off_by_text(rung.off_by, quantity), share_width);
  if (const auto interaction = interaction_in(ladder, quantity)) line += off_by_text(*interaction);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

/// The heading of the column of a rung: coupling is against all the others.
const char* head_of(const std::string& key) {
  if (key == "body") return "body alone";
  if (key == "poisson_ratio") return "nu alone";
  return key == "friction" ? "direction alone" : "coupling, last";
}

std::string heads_of(const Ladder& ladder) {
  auto line = "  " + column("", title_width) + column("MDR", value_width) + column("finite elements", value_width) +
              column("MDR is off by", share_width);
  if (ladder.rungs.size() > 1) {
    for (const auto& rung : ladder.rungs) line += column(head_of(rung.rung.key), share_width);
    line += "beyond the sum";
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string headline_of(const Ladder& ladder) {
  const auto radius = radius_of_headline(ladder);
  if (!radius) return "neither finite elements nor MDR find a contact to compare";
  const auto& whole = ladder.whole.off_by.at(radius->quantity);
  const char* title = radius->name;
  if (!whole.is_resolved())
    return fmt::format("nothing is resolved beyond numerics: MDR's {} is right to {:.1g} %", title,
                       100 * (std::abs(whole.value) + whole.uncertainty));
  auto text = fmt::format("MDR's {} is {} ± {:.1g} % too {} here", title,
                          percent(std::abs(whole.value), whole.uncertainty, false), 100 * whole.uncertainty,
                          whole.value > 0 ? "large" : "small");
  std::string reasons;
  for (const auto& rung : ladder.rungs)
    if (const auto share = off_by_text(rung.off_by, radius->quantity); !share.empty())
      reasons +=
          fmt::format("{}{} ({})", reasons.empty() ? ": " : "; ", reason_of(rung.rung, ladder.contact_radius), share);
  return text + reasons;
}

std::string ladder_text(const std::string& name, const Ladder& ladder) {
  auto text = fmt::format("{}: {}\n", name, headline_of(ladder)) + heads_of(ladder);
  for (const auto quantity : quantities_by_interest)
    if (ladder.whole.off_by.count(quantity) > 0) text += row_of(ladder, quantity);
  text += "not computed:\n";
  for (const auto& [assumption, order] : ladder.not_computed) text += fmt::format("  {} ({})\n", assumption, order);
  return text;
}

std::string radii_beyond(double share, const Ladder& ladder) {
  std::string titles;
  for (const auto quantity :
       {Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown, Quantity::contact_radius_max})
    if (const auto found = ladder.whole.off_by.find(quantity);
        found != ladder.whole.off_by.end() && std::abs(found->second.value) - found->second.uncertainty > share)
      titles += (titles.empty() ? "" : ", ") + std::string(traits_of(quantity).title);
  return titles;
}

ordered_json ladder_json(const Case& input, const Ladder& ladder) {
  ordered_json json{{"name", input.name}, {"headline", headline_of(ladder)}};
  if (const auto radius = radius_of_headline(ladder)) json["headline_quantity"] = name_of(radius->quantity);
  json["mdr"] = ordered_json::object();
  for (const auto quantity : quantities_by_interest)
    if (ladder.whole.off_by.count(quantity) > 0) json["mdr"][name_of(quantity)] = ladder.mdr.at(quantity).value.value();
  json["mdr_off_by"] = off_by_json(ladder.whole.off_by);
  json["fe"] = fe_json(ladder.whole.off_by);
  json["rungs"] = ordered_json::object();
  for (const auto& rung : ladder.rungs)
    json["rungs"][rung.rung.key] = {
        {"title", rung.rung.title}, {"mdr_off_by", off_by_json(rung.off_by)}, {"fe", fe_json(rung.off_by)}};
  json["interaction"] = ordered_json::object();
  for (const auto& [quantity, off] : ladder.whole.off_by)
    if (const auto interaction = interaction_in(ladder, quantity))
      json["interaction"][name_of(quantity)] = off_by_json(*interaction);
  if (ladder.edges) json["zones"] = edges_json(*ladder.edges);
  json["not_computed"] = ordered_json::array();
  for (const auto& [assumption, order] : ladder.not_computed)
    json["not_computed"].push_back({{"assumption", assumption}, {"order", order}});
  json["inputs"] = inputs_json(input);
  json["at"] = place_json(input, ladder);
  return json;
}

}  // namespace fretval
