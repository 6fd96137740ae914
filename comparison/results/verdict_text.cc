#include "comparison/results/verdict_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/data/motion_kind.h"
#include "comparison/results/unit_text.h"
#include "comparison/support/json.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;
using Differences = std::vector<StoredDifference>;

constexpr const char* method = "the method of dimensionality reduction (MDR)";

std::optional<Verdict> verdict_named(const std::string& name) {
  if (name == "agree" || name == "pass") return Verdict::agree;
  if (name == "disagree" || name == "fail") return Verdict::disagree;
  return name.empty() ? std::nullopt : std::optional(Verdict::not_resolved);
}

/// "the stick radius (shakedown)"
std::string spoken(Quantity quantity) {
  std::string title = traits_of(quantity).title;
  if (const auto comma = title.find(", "); comma != std::string::npos) title.replace(comma, 2, " (").append(")");
  return "the " + title;
}

/// "both stick radii, the largest contact radius and the largest normal force"
std::string names_of(const Differences& differences) {
  constexpr std::size_t most = 5;
  if (differences.size() > most) return fmt::format("all {} quantities that were asked for", differences.size());
  const auto has = [&](Quantity quantity) {
    return std::any_of(differences.begin(), differences.end(), [&](const auto& d) { return d.quantity == quantity; });
  };
  const bool both = has(Quantity::stick_radius_first_slip) && has(Quantity::stick_radius_shakedown);
  std::vector<std::string> names;
  if (both) names.emplace_back("both stick radii");
  for (const auto& d : differences)
    if (!both || (d.quantity != Quantity::stick_radius_first_slip && d.quantity != Quantity::stick_radius_shakedown))
      names.push_back(spoken(d.quantity));
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

Differences chosen(const Differences& differences, bool asked, std::optional<Verdict> verdict) {
  Differences some;
  for (const auto& d : differences)
    if (d.asked == asked && (!verdict || d.verdict == verdict)) some.push_back(d);
  return some;
}

/// The largest difference of values; those of quantities of settling are of another kind and are left out.
double largest_of(const Differences& differences) {
  double largest = 0;
  for (const auto& d : differences)
    if (!traits_of(d.quantity).of_settling) largest = std::max(largest, d.size);
  return largest;
}

std::string are(std::size_t n) {
  return n == 1 ? "is" : "are";
}

/// "; 3 of 8 other quantities are not resolved"
std::string others_text(const Differences& differences) {
  const auto all = chosen(differences, false, std::nullopt).size();
  const auto open = chosen(differences, false, Verdict::not_resolved).size();
  if (all == 0) return "";
  if (open == 0)
    return fmt::format("; so {} {} other {}", all == 1 ? "does" : "do", all, all == 1 ? "quantity" : "quantities");
  return fmt::format("; {} of {} other {} {} not resolved", open, all, all == 1 ? "quantity" : "quantities", are(open));
}

std::string one_text(const StoredDifference& d) {
  if (d.only_one) return fmt::format("{}, which only one of both finds", spoken(d.quantity));
  return fmt::format("{} by {:.1e}, where {:.0e} was asked for and the error bar is {:.1e}", spoken(d.quantity), d.size,
                     d.tolerance, d.bar);
}

/// Differences of one verdict as a list, the largest use of a tolerance first.
std::string list_text(Differences some) {
  constexpr std::size_t most = 3;
  std::sort(some.begin(), some.end(),
            [](const auto& a, const auto& b) { return a.size / a.tolerance > b.size / b.tolerance; });
  std::string text;
  for (std::size_t i = 0; i < std::min(most, some.size()); ++i) text += (i ? "; " : "") + one_text(some[i]);
  return text + (some.size() > most ? fmt::format("; and {} more", some.size() - most) : "");
}

std::string agreeing_text(const Differences& differences) {
  const auto asked = chosen(differences, true, std::nullopt), good = chosen(differences, true, Verdict::agree);
  return fmt::format(". {} of {} quantities that were asked for agree", good.size(), asked.size());
}

std::string open_text(const Differences& differences) {
  std::string text;
  for (const auto& d : chosen(differences, true, Verdict::not_resolved))
    text += fmt::format(
        "{}the error bar of {} is {:.2e}, wider than the tolerance of {:.0e} that was asked for (the difference is "
        "{:.1e})",
        text.empty() ? "" : "; ", spoken(d.quantity), d.bar, d.tolerance, d.size);
  return fmt::format("not resolved: finite elements neither confirm nor refute {}: {}{}", method, text,
                     agreeing_text(differences));
}

/// Three digits, and one more next to 100 %.
std::string share_text(double share) {
  constexpr double next_to_all = 0.01;
  return fmt::format("{:.{}f} %", 100 * share, std::abs(share - 1) < next_to_all ? 2 : 1);
}

/// Text on gross slip: what each method found on its way to the steady motion, and what the balance of forces demands.
std::string sliding_text(const ordered_json& result) {
  const auto &fe = result.at("fe"), &mdr = result.at("mdr");
  const bool once = mdr.contains("gross_slip_time");
  std::string by_fe = "do not find that", by_mdr = "does not find that";
  if (const auto slip = fe.find("gross_slip"); slip != fe.end()) {
    const auto time = with_unit(slip->at("time").get<double>(), 0, "s");
    by_fe = once ? "find it from t = " + time + " on"
                 : fmt::format("find it after {}, at {} of the amplitudes", time,
                               share_text(number_or_nan(*slip, "amplitude")));
  }
  if (once)
    by_mdr = fmt::format("finds it from t = {} on", with_unit(number_or_nan(mdr, "gross_slip_time"), 0, "s"));
  else if (slides(mdr))
    by_mdr = fmt::format("finds it at {} of {}", share_text(number_or_nan(mdr, "gross_slip")),
                         slides(fe) ? "them" : "the amplitudes");
  auto text = fmt::format("finite elements {}, {} {}", by_fe, method, by_mdr);
  if (!once && slides(fe) && slides(mdr)) text += ", each while the amplitudes rise in its own way";
  const double share = number_or_nan(mdr, "steady_sliding_share");
  if (std::isnan(share)) return text;
  return text + fmt::format(
                    ". By the balance of forces, λ |F_x exp(iφ) ± μ dF| = μ F_0, the steady motion slides "
                    "from {} of the amplitudes on{}",
                    share_text(share),
                    share < 1 ? fmt::format(": this one is {} beyond", share_text(1 / share - 1)) : "");
}

/// "; the stick radius (shakedown) is 3.2 % ± 0.1 % smaller" of finite elements, over MDR's value.
std::string change_of(const ordered_json& result, const StoredDifference& d) {
  const double fe = number_or_nan(result.at("fe"), name_of(d.quantity)),
               mdr = number_or_nan(result.at("mdr"), name_of(d.quantity)),
               radius = number_or_nan(result.at("scene"), "contact_radius_unworn");
  if (std::isnan(fe) && std::isnan(mdr)) return "";
  if (std::isnan(fe) || std::isnan(mdr))
    return fmt::format("{} only {} has", spoken(d.quantity), std::isnan(fe) ? "MDR" : "the case");
  const bool is_over_radius = traits_of(d.quantity).scale.over == Over::contact_radius;
  const double change = fe / mdr - 1, bar = d.bar * (is_over_radius ? radius / mdr : 1);
  const auto text = d.bar > 0 ? fmt::format("{:.2g} % ± {:.1g} %", 100 * std::abs(change), 100 * bar)
                              : fmt::format("{:.2g} %", 100 * std::abs(change));
  return fmt::format("{} is {} {}", spoken(d.quantity), text, change < 0 ? "smaller" : "larger");
}

/// Text on the error of MDR where the case has another model.
std::string other_model_text(const ordered_json& result, const Differences& asked) {
  std::string reasons, changes;
  for (const auto& reason : result.at("other_model"))
    reasons += (reasons.empty() ? "" : ", ") + reason.get<std::string>();
  for (const auto& d : asked)
    if (const auto text = change_of(result, d); !text.empty()) changes += (changes.empty() ? "" : ", ") + text;
  return fmt::format("{} computes another model, as {}: compared with it, {}", method, reasons, changes);
}

bool any_slides(const ordered_json& result) {
  return slides(result.at("fe")) || slides(result.at("mdr"));
}

/// The answer to a case in which any_slides.
std::string sliding_answer(const ordered_json& result) {
  const auto outcome = stored_outcome(result);
  const bool by_fe = slides(result.at("fe")), by_both = by_fe && slides(result.at("mdr"));
  if (by_both || (outcome != Outcome::not_resolved && outcome != Outcome::disagree))
    return "the whole contact slides: friction does not carry the tangential force";
  return fmt::format(
      "the whole contact slides by {} alone{}", by_fe ? "finite elements" : "MDR",
      outcome == Outcome::not_resolved ? ": friction just carries the tangential force, or just does not" : "");
}

/// With the prefix of the contact radius, three digits, and more where the length is a thousand of these units.
std::string length_text(double length, double contact_radius) {
  const auto [prefix, factor] = prefix_for(contact_radius);
  constexpr double rounded_to_a_hundred = 99.95;
  const double value = length / factor;
  return fmt::format(value < rounded_to_a_hundred ? "{:#.3g} {}m" : "{:.0f} {}m", value, prefix);
}

/// A stick radius of finite elements, with its error bar where that exceeds a tenth of it, so that not even its first
/// digit is known: as where a record of a rig leaves it open.
std::string stick_text(const ordered_json& result, Quantity quantity, double contact) {
  const double stick = number_or_nan(result.at("fe"), name_of(quantity));
  double bar = 0;
  if (const auto compared = result.at("comparison").find(name_of(quantity)); compared != result.at("comparison").end())
    bar = number_or_nan(*compared, "error_bar") * number_or_nan(result.at("scene"), "contact_radius_unworn");
  return bar > stick / 10 ? with_unit(stick, bar, "m") : length_text(stick, contact);
}

/// Text on the zone that sticks for good, and where it ends.
std::string zones_answer(const ordered_json& result, double stick, double contact) {
  constexpr double nearly_all = 0.9995;
  const auto& fe = result.at("fe");
  const auto text = [&](double length) { return length_text(length, contact); };
  const auto inner = stick_text(result, Quantity::stick_radius_shakedown, contact);
  if (std::isnan(stick) && fe.value("lifts_off", false))
    return fmt::format(
        "the indenter lifts off in every cycle: nothing sticks for good, and all of the contact of {} wears",
        text(contact));
  if (std::isnan(stick))
    return fmt::format("nothing sticks for good: all of the contact of {} slips in every cycle, and wears on",
                       text(contact));
  if (const auto wear = fe.find("surface_wear"); wear != fe.end())
    return fmt::format("unworn, the inner {} of a contact of {} sticks; of the worn indenter the inner {}", inner,
                       text(contact), text(number_or_nan(wear->at("sticks"), "radius")));
  if (stick >= nearly_all * contact)
    return fmt::format("all of the contact of {} sticks for good: nothing wears", text(contact));
  const double by_fe = number_or_nan(fe, "worn_radius"),
               by_mdr = result.contains("other_model") ? by_fe : number_or_nan(result.at("mdr"), "worn_radius"),
               worn = std::isnan(by_fe) ? by_mdr : by_fe;
  const auto zones = fmt::format("the inner {} of a contact of {} sticks for good", inner, text(contact));
  if (!(worn > 0)) return zones + "; the ring outside wears";
  const bool has_worn = fe.contains("wear") && fe.at("wear").value("ends_in_limit", false);
  return fmt::format("{}; the ring outside {}, out to {}", zones, has_worn ? "has worn off" : "wears", text(worn));
}

}  // namespace

Differences stored_differences(const ordered_json& result) {
  Differences all;
  const double radius = number_or_nan(result.at("scene"), "contact_radius_unworn");
  for (const auto& [key, compared] : result.at("comparison").items()) {
    const auto quantity = quantity_of(key);
    if (!quantity) continue;
    StoredDifference one{
        *quantity, std::abs(number_or_nan(compared, "difference")), number_or_nan(compared, "tolerance"), 0, {}, true,
        false};
    const double bar = number_or_nan(compared, "error_bar"), mdr_error = number_or_nan(compared, "mdr_error");
    one.bar = bar + (std::isnan(mdr_error) ? 0 : mdr_error);
    const auto verdict = compared.find("verdict");
    if (verdict != compared.end() && verdict->is_string()) one.verdict = verdict_named(verdict->get<std::string>());
    one.asked = compared.value("asked", traits_of(*quantity).refined_for == RefinedFor::any_case);
    if (std::isnan(one.size)) {
      const double fe = number_or_nan(result.at("fe"), key), mdr = number_or_nan(result.at("mdr"), key);
      one.only_one = std::isnan(fe) != std::isnan(mdr);
      one.size = one.only_one ? std::abs(std::isnan(fe) ? mdr : fe) / radius : 0;
    }
    all.push_back(one);
  }
  const auto place = [](Quantity quantity) {
    return std::find(quantities_by_interest.begin(), quantities_by_interest.end(), quantity);
  };
  std::sort(all.begin(), all.end(),
            [&](const auto& a, const auto& b) { return place(a.quantity) < place(b.quantity); });
  return all;
}

bool slides(const ordered_json& method) {
  const auto found = method.find("gross_slip");
  return found != method.end() && !found->is_null();
}

Outcome stored_outcome(const ordered_json& result) {
  if (result.contains("not_compared")) return Outcome::not_compared;
  if (const auto verdict = result.find("verdict"); verdict != result.end() && verdict->is_string())
    for (const auto outcome :
         {Outcome::agree, Outcome::not_resolved, Outcome::disagree, Outcome::not_proved, Outcome::other_model})
      if (*verdict == name_of(outcome)) return outcome;
  // A result of the first version.
  if (result.at("pass").get<bool>()) return Outcome::agree;
  return chosen(stored_differences(result), true, Verdict::disagree).empty() ? Outcome::not_resolved
                                                                             : Outcome::disagree;
}

std::string plain_answer(const ordered_json& result) {
  const auto &scene = result.at("scene"), &fe = result.at("fe");
  if (any_slides(result)) return sliding_answer(result);
  const double in_contact = number_or_nan(fe, "contact_radius_max"),
               contact = std::isnan(in_contact) ? number_or_nan(scene, "contact_radius_unworn") : in_contact,
               stick = number_or_nan(fe, "stick_radius_shakedown"),
               first = number_or_nan(fe, "stick_radius_first_slip");
  if (result.contains("not_compared") || std::isnan(contact)) return "";
  const auto kind = stored_motion_kind(scene);
  if (kind == MotionKind::pass_from_touch)
    return fmt::format("in this pass the contact grows from a touch to {}", length_text(contact, contact));
  if (is_pass(kind))
    return std::isnan(first) ? fmt::format("in this pass all of the contact of {} slips", length_text(contact, contact))
                             : fmt::format("in this pass the inner {} of a contact of {} never slips",
                                           stick_text(result, Quantity::stick_radius_first_slip, contact),
                                           length_text(contact, contact));
  if (scene.value("wear", "") == "limiting" && !std::isnan(stick))
    return fmt::format("this worn indenter is pressed, and sticks, within {}: nothing wears any more",
                       length_text(stick, contact));
  return zones_answer(result, stick, contact);
}

std::string verdict_sentence(const ordered_json& result) {
  if (any_slides(result)) return sliding_text(result);
  const auto differences = stored_differences(result);
  const auto asked = chosen(differences, true, std::nullopt);
  switch (stored_outcome(result)) {
    case Outcome::agree:
      return fmt::format("finite elements confirm {}: {} {} to {:.1e}{}", method, names_of(asked),
                         asked.size() == 1 ? "agrees" : "agree", largest_of(asked), others_text(differences));
    case Outcome::not_resolved:
      return open_text(differences);
    case Outcome::disagree: {
      auto bad = chosen(differences, true, Verdict::disagree);
      const auto others = chosen(differences, false, Verdict::disagree);
      bad.insert(bad.end(), others.begin(), others.end());
      return fmt::format("finite elements do not confirm {}: they differ in {}{}", method, list_text(bad),
                         agreeing_text(differences));
    }
    case Outcome::not_proved:
      return fmt::format(
          "not proved: finite elements and {} differ by up to {:.1e} in {}, but without error bars that is "
          "no verdict (--proof bars or tolerance gives one)",
          method, largest_of(asked), names_of(asked));
    case Outcome::other_model:
      return other_model_text(result, asked);
    case Outcome::not_compared:
      break;
  }
  return differences.empty() ? fmt::format("nothing is compared with {}", method) : "";
}

}  // namespace fretval
