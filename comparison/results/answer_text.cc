#include "comparison/results/answer_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/case/table_noise.h"
#include "comparison/data/motion_kind.h"
#include "comparison/quantities/reading.h"
#include "comparison/results/verdict_text.h"
#include "comparison/support/json.h"
#include "comparison/support/log.h"
#include "comparison/support/statistics.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t most_listed = 3;  // all others are counted

/// A share of the order of 1 without its roundoff.
double without_roundoff_of_one(double value) {
  constexpr double roundoff = 1e-6;
  return std::abs(value) < roundoff ? 0 : value;
}

/// ", 56 h at 1 Hz"; nothing where a cycle is not that of one frequency.
std::string time_of_cycles(const ordered_json& scene, double cycles) {
  const auto period = period_of(scene);
  return period ? fmt::format(", {} at {:.3g} Hz", time_text(cycles * *period), 1 / *period) : "";
}

/// Text on wear that ends because friction no longer carries what is prescribed.
constexpr auto slides_text =
    "; then the whole contact slides: μ times the normal force is no more than the tangential force\n";

/// Text on the wear of an indenter.
std::string wear_text(const ProvedWear& wear, const Units& units, const ordered_json& scene) {
  const auto& last = wear.fe.course.curve.back();
  auto text = fmt::format("  worn off: {} in {:.3g} cycles{}", volume_text(last.volume * units.volume()), last.cycles,
                          time_of_cycles(scene, last.cycles));
  if (wear.kinetics) text += fmt::format(" (MDR {})", volume_text(wear.kinetics->curve.back().volume));
  if (wear.ends_in_limit())
    return text +
           fmt::format("; nothing wears any more\n  worn profile: {:.1e} from the limiting one (in r/a and f/d max)\n",
                       wear.distance_shakedown.back());
  if (wear.fe.course.end == fem::WearEnd::slides) return text + slides_text;
  if (wear.sticks_throughout) return text + "; all that touches sticks: nothing wears\n";
  if (!wear.slip_is_proved)
    return text + "; no slip is proved: friction takes less energy from a cycle than its error bar\n";
  if (wear.fe.course.end == fem::WearEnd::progressive)
    return text + fmt::format("; it goes on for ever, by {} a cycle{}\n",
                              volume_text(last.volume_rate * units.volume()),
                              wear.rate_error ? fmt::format(" (± {:.1g} of that)", *wear.rate_error) : "");
  if (wear.fe.course.end != fem::WearEnd::nothing_left)
    return text + fmt::format("; still {:.2g} from the limiting profile\n", wear.distance_shakedown.back());
  return text + "; what still bears pressure sticks throughout, and wears no more\n";
}

/// Text on the wear of an indenter to a shape that is not axisymmetric, beside MDR's limit.
std::string wear_text(const ProvedSurfaceWear& wear, const Units& units, const ordered_json& scene) {
  const auto& fe = wear.fe;
  const auto& last = fe.course.curve.back();
  const double volume = last.volume * units.volume(), length = units.length;
  const auto bar = [&](const ErrorBar& of, double unit) { return wear.is_proved ? of.total() * unit : 0; };
  auto text = fmt::format("  worn off: {} in {:.3g} cycles{} (MDR's limit: {})", volume_text(volume), last.cycles,
                          time_of_cycles(scene, last.cycles), volume_text(wear.limit.volume));
  if (fe.course.end == fem::WearEnd::slides) return text + slides_text;
  text += fe.course.end == fem::WearEnd::nothing_left ? "; nothing wears any more\n" : "\n";
  text += fmt::format("  what has worn leaves {} to stick (MDR {}), {} along x and {} across\n",
                      with_unit(fe.sticks.radius * length, bar(wear.radius, length), "m"),
                      with_unit(wear.limit.stick_radius, 0, "m"),
                      with_unit(fe.sticks.along * length, bar(wear.along, length), "m"),
                      with_unit(fe.sticks.across * length, bar(wear.across, length), "m"));
  return text;
}

/// A share in percent, to so many significant digits, or whole where it has more of them: never as a power of ten.
std::string percent_text(double share, int digits, bool with_sign = false) {
  const double percent = 100 * share, rounded = to_digits(percent, digits);
  const auto text = std::abs(rounded) < std::pow(10, digits) ? fmt::format("{:.{}g}", percent, digits)
                                                             : fmt::format("{:.0f}", percent);
  return with_sign && !std::signbit(percent) ? "+" + text : text;
}

/// A value or bar as it is shown: 0 if it is roundoff of the scale.
std::string reading_text(Quantity quantity, const Scales& scales, const Reading& reading) {
  const auto rounded = [&](double value) { return without_roundoff(quantity, scales, value); };
  return reading.value
             ? with_unit(rounded(*reading.value), rounded(reading.uncertainty.value_or(0)), traits_of(quantity).unit)
             : "none";
}

/// "its image g(x) falls for x = 502 to 600 µm. MDR's springs would bear +3.1 % and reach -0.2 % further, at rest at
/// the largest indentation": of the key "not_compared".
std::string beyond_text(const ordered_json& not_compared) {
  std::string text;
  const auto length = [](const ordered_json& value) {
    return value == 0.0 ? "0" : with_prefix(value.get<double>(), "m", 4);
  };
  const auto& falls = not_compared.at("image_falls");
  const auto noise = number_in(not_compared, "table_noise");
  if (noise) text = noise_text(*noise) + ". As it is, ";
  for (std::size_t k = 0; k < std::min(falls.size(), most_listed); ++k)
    text += fmt::format("{}{} to {}", k == 0 ? "its one-dimensional image g(x) falls for x = " : ", ",
                        length(falls[k].at("from")), length(falls[k].at("to")));
  if (falls.size() > most_listed) text += fmt::format(" and in {} places more", falls.size() - most_listed);
  const auto& at_rest = not_compared.at("at_rest");
  return text + fmt::format(
                    ". At rest at the largest indentation its springs would be off by {} % of the normal force and "
                    "{} % of the contact radius",
                    percent_text(at_rest.at("normal_force_difference").get<double>(), 2, true),
                    percent_text(at_rest.at("contact_radius_difference").get<double>(), 2, true));
}

/// The answer of finite elements alone, for a profile that MDR does not hold for.
Answer answer_beyond_mdr(const ordered_json& result) {
  const auto& fe = result.at("fe");
  Answer answer{"", "not compared: MDR does not hold for this profile: " + beyond_text(result.at("not_compared")), {}};
  const auto add = [&](const std::string& title, const std::string& text) {
    answer.rows.push_back({title, text, "–", "–"});
  };
  for (const auto quantity : quantities_by_interest) {
    const auto& traits = traits_of(quantity);
    const auto reading = fe_reading(result, quantity);
    if (!reading || !reading->value || !fe.at("error_estimate").contains(traits.name)) continue;
    add(traits.title, reading_text(quantity, scales_of(result), *reading));
  }
  const auto& zones = fe.at("zones");
  if (const auto pressure = number_in(zones, "pressure_max"))
    add("largest pressure", with_unit(*pressure, number_in(zones, "pressure_max_bar").value_or(0), "Pa"));
  add("contact, r", annuli_text(zones.at("contact")));
  add("stick, first slip, r", annuli_text(zones.at("first_slip")));
  if (!is_pass(stored_motion_kind(result.at("scene")))) add("stick, shakedown, r", annuli_text(zones.at("shakedown")));
  return answer;
}

/// Quantities that are not asked for have no part in the verdict.
std::string not_asked_line(bool has_cycle_tolerance) {
  return has_cycle_tolerance
             ? "  not asked for, as far as they are known:\n"
             : "  not asked for, as far as they are known (Accuracy / Cycle tolerance asks for forces and "
               "energies):\n";
}

}  // namespace

std::optional<double> period_of(const ordered_json& scene) {
  if (const auto path = scene.find("path"); path != scene.end())
    return is_pass(stored_motion_kind(scene)) ? std::nullopt : number_in(*path, "duration");
  const auto frequency = number_in(scene, "frequency"), tangential = number_in(scene, "tangential_frequency");
  const bool has_more = scene.contains("normal_harmonics") || scene.contains("tangential_harmonics");
  if (!frequency || has_more || tangential.value_or(*frequency) != *frequency) return std::nullopt;
  return 1 / *frequency;
}

Scales scales_of(const ordered_json& result) {
  const auto& fe = result.at("fe");
  return {number_in(result.at("scene"), "contact_radius_unworn").value_or(0),
          number_in(fe, "sliding_force").value_or(0), number_in(fe, "sliding_work").value_or(0)};
}

std::optional<Reading> fe_reading(const ordered_json& result, Quantity quantity) {
  const auto &fe = result.at("fe"), &comparison = result.at("comparison");
  const char* key = name_of(quantity);
  auto reading = stored_reading(fe, quantity);
  if (!reading) return std::nullopt;
  reading->uncertainty.reset();
  if (const auto compared = comparison.find(key); compared != comparison.end())
    reading->uncertainty = number_in(*compared, "error_bar");
  else if (const auto bars = fe.find("error_estimate"); bars != fe.end())
    if (const auto found = bars->find(key); found != bars->end() && found->is_object())
      reading->uncertainty = number_in(*found, "total");
  if (reading->uncertainty)
    *reading->uncertainty *= scale_of(quantity, scales_of(result), reading->value.value_or(std::nan("")));
  return reading;
}

/// Remark on a force or an energy of a cycle that is not asked for, where its bar is a tenth of it or more.
std::string hardly_known(const ordered_json& result, const StoredDifference& one) {
  constexpr double tenth = 0.1;
  const auto reading = fe_reading(result, one.quantity);
  if (one.asked || traits_of(one.quantity).refined_for != RefinedFor::cycles || !reading || !reading->value ||
      !reading->uncertainty || *reading->value == 0)
    return "";
  const double share = *reading->uncertainty / std::abs(*reading->value);
  if (!(share >= tenth)) return "";
  if (share >= 1) return "no larger than its bar";
  return fmt::format("known to {:.0f} %: set a Cycle tolerance", 100 * share);
}

/// Text on the error of MDR over a half-space in the place of the body, relative to finite elements.
std::string half_space_text(const ordered_json& result) {
  const auto half_space = result.find("mdr_half_space");
  if (half_space == result.end()) return "";
  constexpr double roundoff = 1e-9;
  std::string text;
  for (const auto quantity : {Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown,
                              Quantity::contact_radius_max, Quantity::normal_force_max, Quantity::indentation_max}) {
    const auto fe = stored_reading(result.at("fe"), quantity), mdr = stored_reading(*half_space, quantity);
    if (!fe || !fe->value || !mdr || !mdr->value) continue;
    const double off_by = *mdr->value / *fe->value - 1;
    if (std::abs(off_by) < roundoff) continue;  // of what is prescribed
    text += fmt::format("{}{} by {:+.3g} %", text.empty() ? "" : ", ", traits_of(quantity).title, 100 * off_by);
  }
  return "over a half-space MDR would be off: " + text;
}

/// "as a model MDR is good to about 3 %: its stick radius, first slip, is off by +2.1 ± 0.4 %": by the maps of its
/// error.
std::string model_text(const ordered_json& result) {
  const auto model = result.find("model");
  if (model == result.end()) return "";
  if (model->contains("outside"))
    return fmt::format("as a model: outside the map ({})", model->at("outside").get<std::string>());
  const auto good_to = number_in(*model, "good_to");
  if (!good_to) return "";
  auto text = fmt::format("as a model MDR is good to about {} %", percent_text(*good_to, 1));
  const char* mark = ": off by ";
  for (const auto quantity : mapped_quantities)
    if (const auto found = model->at("mdr_off_by").find(name_of(quantity)); found != model->at("mdr_off_by").end()) {
      const double value = found->at("value").get<double>(), uncertainty = found->at("uncertainty").get<double>();
      if (std::abs(value) <= uncertainty) continue;
      text += fmt::format("{}{} ± {} % in the {}", mark, percent_text(value, 2, true), percent_text(uncertainty, 1),
                          traits_of(quantity).title);
      mark = "; ";
    }
  return text;
}

/// "a percent more friction changes the stick radius, first slip by +0.31 %, …; a percent more relaxed modulus …"
std::string sensitivity_text(const ordered_json& result) {
  const auto found = result.at("mdr").find("sensitivity");
  if (found == result.at("mdr").end()) return "";
  std::string text;
  for (const auto& [key, words] : {std::pair{"friction_coefficient", "friction (μ)"},
                                   std::pair{"relaxed_modulus", "relaxed modulus (G'(0), the branches as they are)"}}) {
    std::string changes;
    for (const auto quantity : {Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown})
      if (const auto one = found->find(name_of(quantity)); one != found->end() && one->is_object())
        changes += fmt::format("{}the {} by {:+.2g} %", changes.empty() ? "" : " and ", traits_of(quantity).title,
                               without_roundoff_of_one(one->at(key).get<double>()));
    if (!changes.empty()) text += fmt::format("{}1 % more {} changes {}", text.empty() ? "" : "; ", words, changes);
  }
  return text;
}

/// Text that a given mesh has too few rings, and how many are needed; empty if it has enough.
std::string rings_text(const ordered_json& result) {
  const auto rings = result.at("fe").find("rings");
  if (rings == result.at("fe").end() || !rings->at("needed").is_number()) return "";
  return fmt::format(
      "too few rings for the tolerance: the mesh has {} edges within the contact, and it takes some {}, with cells "
      "to match",
      rings->at("in_contact").get<int>(), rings->at("needed").get<int>());
}

Answer answer_of(const ordered_json& result) {
  if (result.contains("not_compared")) return answer_beyond_mdr(result);
  Answer answer{plain_answer(result), verdict_sentence(result), {}, model_text(result), half_space_text(result),
                rings_text(result),   sensitivity_text(result)};
  const auto scales = scales_of(result);
  for (const auto& one : stored_differences(result)) {
    const auto& traits = traits_of(one.quantity);
    if (*traits.unit == '\0' || one.quantity == Quantity::worn_volume) continue;
    const auto difference = number_in(result.at("comparison").at(traits.name), "difference");
    const bool is_good = one.verdict.value_or(Verdict::agree) == Verdict::agree;
    answer.rows.push_back(
        {traits.title, reading_text(one.quantity, scales, fe_reading(result, one.quantity).value_or(Reading{})),
         mdr_text(result.at("mdr"), one.quantity, scales), difference ? fmt::format("{:+.1e}", *difference) : "–",
         is_good ? "" : name_of(*one.verdict), one.asked});
    if (const auto words = hardly_known(result, one); !words.empty())
      answer.rows.back().remark += (answer.rows.back().remark.empty() ? "" : "; ") + words;
  }
  std::stable_partition(answer.rows.begin(), answer.rows.end(), [](const AnswerRow& row) { return row.asked; });
  return answer;
}

std::string annuli_text(const ordered_json& annuli) {
  std::string text;
  const auto end = [](const ordered_json& annulus, const char* key, const char* bar) {
    return with_unit(annulus.at(key).get<double>(), number_in(annulus, bar).value_or(0), "m");
  };
  for (std::size_t k = 0; k < std::min(annuli.size(), most_listed); ++k) {
    const auto& annulus = annuli[k];
    text += (text.empty() ? "" : "; ") + (annulus.at("inner") == 0.0 ? "0" : end(annulus, "inner", "inner_bar")) +
            " to " + end(annulus, "outer", "outer_bar");
  }
  if (annuli.size() > most_listed)
    text +=
        fmt::format("; and {} more, out to {}", annuli.size() - most_listed, end(annuli.back(), "outer", "outer_bar"));
  return text.empty() ? "none" : text;
}

std::string mdr_text(const ordered_json& mdr, Quantity quantity, const Scales& scales) {
  return reading_text(quantity, scales, stored_reading(mdr, quantity).value_or(Reading{}));
}

std::string answer_line(const std::string& title, const std::string& first, const std::string& second,
                        const std::string& remark) {
  auto line = fmt::format("  {:<28} {:<28} {:<24} {}", title, first, second, remark);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

namespace {

bool asks_for_cycles(const ordered_json& result) {
  for (const auto& input : result.at("scene").value("inputs", ordered_json::array()))
    if (input.at("name") == "Cycle tolerance") return true;
  return false;
}

/// wear: text on the wear of the indenter; empty: it has not worn.
std::string text_of_answer(const ordered_json& json, const std::string& wear) {
  const auto answer = answer_of(json);
  auto text = json.at("name").get<std::string>() + ": ";
  if (!answer.plain.empty()) text += answer.plain + "\n";
  text += answer.verdict + "\n";
  if (!answer.model.empty()) text += answer.model + "\n";
  if (json.contains("not_compared")) {
    for (const auto& one : answer.rows) text += answer_line(one.title, one.fe);
    return text;
  }
  if (slides(json.at("fe")) || slides(json.at("mdr"))) return text;
  text += answer_line("", "finite elements", "MDR");
  bool asked = true;
  for (const auto& one : answer.rows) {
    if (asked && !one.asked) text += not_asked_line(asks_for_cycles(json));
    asked = one.asked;
    text += answer_line(one.title, one.fe, one.mdr, one.remark);
  }
  const auto kind = stored_motion_kind(json.at("scene"));
  if (kind == MotionKind::pass_from_touch) text += answer_line("stick radius, first slip", "none", nothing_at_rest);
  if (is_pass(kind)) text += answer_line("stick radius, shakedown", "none", no_shakedown_in_a_pass);
  if (const auto zones = json.at("fe").find("zones");
      zones != json.at("fe").end() && zones->contains("second_algorithm"))
    text +=
        answer_line("second algorithm", fmt::format("differs by {:.1e}", zones->at("second_algorithm").get<double>()),
                    "of the largest traction or pressure, in any step");
  for (const auto* line : {&answer.half_space, &answer.rings})
    if (!line->empty()) text += "  " + *line + "\n";
  if (!answer.sensitivity.empty() && log::tells_details()) text += "  " + answer.sensitivity + "\n";
  if (!wear.empty()) return text + wear;
  if (const auto worn = number_in(json.at("mdr"), "worn_radius"))
    text += answer_line("wear ends at the radius", "", with_unit(*worn, 0, "m"));
  return text;
}

}  // namespace

std::string answer_text(const CaseResult& result, const ordered_json& json) {
  std::string wear;
  if (result.wear) wear = wear_text(*result.wear, result.fem_case.units, json.at("scene"));
  if (result.surface_wear) wear = wear_text(*result.surface_wear, result.fem_case.units, json.at("scene"));
  return text_of_answer(json, wear);
}

std::string kept_answer_text(const ordered_json& json) {
  auto wear = json.at("fe").find("wear");
  if (wear == json.at("fe").end()) wear = json.at("fe").find("surface_wear");
  if (wear == json.at("fe").end()) return text_of_answer(json, "");
  const double cycles = wear->at("cycles").back().get<double>();
  return text_of_answer(
      json, fmt::format("  worn off: {} in {:.3g} cycles{}\n", volume_text(wear->at("volume").back().get<double>()),
                        cycles, time_of_cycles(json.at("scene"), cycles)));
}

}  // namespace fretval
