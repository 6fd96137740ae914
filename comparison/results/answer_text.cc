#include "comparison/results/answer_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/quantities/readings_json.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

constexpr std::array prefixes{UnitPrefix{"n", 1e-9}, UnitPrefix{"µ", 1e-6}, UnitPrefix{"m", 1e-3}, UnitPrefix{"", 1},
                              UnitPrefix{"k", 1e3},  UnitPrefix{"M", 1e6},  UnitPrefix{"G", 1e9}};

/// Decimals that show a bar with one digit, or a value with six.
int decimals_of(double value, double bar) {
  constexpr int six = 5, most = 9;
  const auto exponent = [](double x) { return static_cast<int>(std::floor(std::log10(std::abs(x)))); };
  constexpr double rounded_up = 0.95;  // 0.0097 becomes 0.01, one digit of which is a place to the left
  if (bar > 0 && std::isfinite(bar)) return std::clamp(-exponent(bar / rounded_up), 0, most);
  return value == 0 ? 0 : std::clamp(six - exponent(value), 0, most);
}

/// Of a pass when, of what rises first how far it has come.
std::string both_gross_slips(const std::optional<GrossSlipStart>& fe, const MdrAnswer& mdr) {
  const auto share_text = [](double share) { return fmt::format("at {:.1f} % of the amplitudes", 100 * share); };
  const auto time_text = [](double time) { return "at t = " + with_unit(time, 0, "s"); };
  const std::string none = "no gross slip";
  std::string by_fe = none, by_mdr = none;
  if (fe)
    by_fe = mdr.single_pass ? time_text(fe->time)
                            : fmt::format("after {}, {}", with_unit(fe->time, 0, "s"), share_text(fe->amplitude));
  if (mdr.gross_slip) by_mdr = mdr.gross_slip_time ? time_text(*mdr.gross_slip_time) : share_text(*mdr.gross_slip);
  return fmt::format(
      "gross slip: the tangential force comes to mu times the normal force. Finite elements: {}; MDR: {}", by_fe,
      by_mdr);
}

std::optional<double> number_in(const ordered_json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

/// Of what only one of the methods finds, the difference is all of it.
double difference_of(const ordered_json& result, const std::string& key, const ordered_json& compared) {
  if (const auto difference = number_in(compared, "difference")) return std::abs(*difference);
  double one = 0;
  for (const char* side : {"fe", "mdr"})
    one = std::max(one, std::abs(number_in(result.at(side), key.c_str()).value_or(0)));
  return one / number_in(result.at("scene"), "contact_radius_unworn").value_or(1);
}

std::string verdict_text(const ordered_json& result) {
  double largest = 0;
  bool fails = false, is_open = false;
  for (const auto& [key, compared] : result.at("comparison").items()) {
    // Of how the motion settles, whose relative difference is of another kind than those of the values, the verdict
    // counts alone.
    const auto quantity = quantity_of(key);
    if (!quantity || !traits_of(*quantity).of_settling)
      largest = std::max(largest, difference_of(result, key, compared));
    const bool inconclusive = compared.value("verdict", "") == "inconclusive";
    is_open = is_open || inconclusive;
    fails = fails || (!compared.at("pass").get<bool>() && !inconclusive);
  }
  if (fails) return fmt::format("finite elements do not confirm MDR: they differ by up to {:.1e}", largest);
  if (is_open)
    return fmt::format(
        "open: the error bars of the finite elements are wider than the tolerance; they differ from MDR by up to "
        "{:.1e}",
        largest);
  return fmt::format("finite elements confirm MDR to {:.1e}", largest);
}

/// What has become of the indenter.
std::string wear_text(const ProvedWear& wear, const Units& units) {
  const auto& last = wear.fe.course.curve.back();
  auto text = fmt::format("  worn off: {} in {:.3g} cycles", volume_text(last.volume * units.volume()), last.cycles);
  if (wear.kinetics) text += fmt::format(" (MDR {})", volume_text(wear.kinetics->curve.back().volume));
  if (wear.ends_in_limit())
    return text +
           fmt::format("; nothing wears any more\n  worn profile: {:.1e} from the limiting one (in r/a and f/d max)\n",
                       wear.distance_shakedown.back());
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

std::string percent(double share) {
  return fmt::format("{:+.2g} %", 100 * share);
}

/// What is roundoff of the scale is 0, also of a bar.
std::string reading_text(Quantity quantity, const Scales& scales, const Reading& reading) {
  const auto rounded = [&](double value) { return without_roundoff(quantity, scales, value); };
  return reading.value
             ? with_unit(rounded(*reading.value), rounded(reading.uncertainty.value_or(0)), traits_of(quantity).unit)
             : "none";
}

/// Of finite elements alone, for a profile that MDR does not hold for.
Answer answer_beyond_mdr(const ordered_json& result) {
  const auto& fe = result.at("fe");
  Answer answer{"not compared: MDR does not hold for this profile: " + beyond_text(result.at("not_compared")), {}};
  const auto add = [&](const std::string& title, const std::string& text) {
    answer.rows.push_back({title, text, "–", "–", true});
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
  const auto path = result.at("scene").find("path");
  if (path == result.at("scene").end() || !path->contains("why_no_shakedown"))
    add("stick, shakedown, r", annuli_text(zones.at("shakedown")));
  return answer;
}

}  // namespace

UnitPrefix prefix_for(double value) {
  auto best = prefixes.front();
  for (const auto& prefix : prefixes)
    if (std::abs(value) >= prefix.factor) best = prefix;
  return best;
}

std::string with_unit(double value, double bar, const std::string& unit) {
  // A bar of hundreds would have three digits.
  const auto& [name, factor] = prefix_for(std::isfinite(bar) ? std::max(std::abs(value), 10 * bar) : value);
  const double least = 1e-9 * factor;
  if (bar < least) bar = 0;
  if (value != 0 && std::abs(value) < least && bar < least) return fmt::format("0 {}{}", name, unit);  // roundoff
  const int decimals = decimals_of(value / factor, bar / factor);
  auto number = fmt::format("{:.{}f}", value / factor, decimals);
  if (number.find_first_of("123456789") == std::string::npos && number.front() == '-') number.erase(0, 1);
  if (bar <= 0 || !std::isfinite(bar)) return fmt::format("{} {}{}", number, name, unit);
  return fmt::format("{} ± {:.{}f} {}{}", number, bar / factor, decimals, name, unit);
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

Answer answer_of(const ordered_json& result) {
  if (result.contains("not_compared")) return answer_beyond_mdr(result);
  Answer answer{verdict_text(result), {}};
  const auto scales = scales_of(result);
  for (const auto quantity : quantities_by_interest) {
    const auto& traits = traits_of(quantity);
    const auto compared = result.at("comparison").find(traits.name);
    if (compared == result.at("comparison").end() || *traits.unit == '\0' || quantity == Quantity::worn_volume)
      continue;
    const auto difference = number_in(*compared, "difference");
    answer.rows.push_back({traits.title,
                           reading_text(quantity, scales, fe_reading(result, quantity).value_or(Reading{})),
                           mdr_text(result.at("mdr"), quantity, scales),
                           difference ? fmt::format("{:+.1e}", *difference) : "–", compared->at("pass").get<bool>()});
  }
  return answer;
}

std::string beyond_text(const ordered_json& not_compared) {
  std::string text;
  const auto length = [](const ordered_json& value) {
    const auto [prefix, factor] = prefix_for(value.get<double>());
    return value == 0.0 ? "0" : fmt::format("{:.4g} {}m", value.get<double>() / factor, prefix);
  };
  for (const auto& fall : not_compared.at("image_falls"))
    text += fmt::format("{}{} to {}", text.empty() ? "its one-dimensional image g(x) falls for x = " : ", ",
                        length(fall.at("from")), length(fall.at("to")));
  const auto& at_rest = not_compared.at("at_rest");
  return text + fmt::format(
                    ". At rest at the largest indentation its springs would be off by {} of the normal force and "
                    "{} of the contact radius",
                    percent(at_rest.at("normal_force_difference").get<double>()),
                    percent(at_rest.at("contact_radius_difference").get<double>()));
}

std::string annuli_text(const ordered_json& annuli) {
  std::string text;
  const auto end = [](const ordered_json& annulus, const char* key, const char* bar) {
    const double width = annulus.at(bar).is_number() ? annulus.at(bar).get<double>() : 0;
    return with_unit(annulus.at(key).get<double>(), width, "m");
  };
  for (const auto& annulus : annuli)
    text += (text.empty() ? "" : "; ") + (annulus.at("inner") == 0.0 ? "0" : end(annulus, "inner", "inner_bar")) +
            " to " + end(annulus, "outer", "outer_bar");
  return text.empty() ? "none" : text;
}

std::string mdr_text(const ordered_json& mdr, Quantity quantity, const Scales& scales) {
  return reading_text(quantity, scales, stored_reading(mdr, quantity).value_or(Reading{}));
}

std::string answer_line(const std::string& title, const std::string& first, const std::string& second) {
  auto line = fmt::format("  {:<28} {:<28} {}", title, first, second);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string volume_text(double cubic_metres) {
  return fmt::format("{:.6g} mm³", cubic_metres * 1e9);
}

std::string answer_text(const CaseResult& result, const ordered_json& json) {
  if (result.fe.fe.gross_slip || result.mdr.gross_slip)
    return fmt::format("{}: {}\n", result.input.name, both_gross_slips(result.fe.fe.gross_slip, result.mdr));
  const auto answer = answer_of(json);
  if (result.beyond_mdr) {
    auto text = fmt::format("{}: {}\n", result.input.name, answer.verdict);
    for (const auto& one : answer.rows) text += answer_line(one.title, one.fe);
    return text;
  }
  auto text = fmt::format("{}: {}\n", result.input.name, answer.verdict) + answer_line("", "finite elements", "MDR");
  for (const auto& one : answer.rows) text += answer_line(one.title, one.fe, one.mdr);
  if (result.mdr.single_pass) text += answer_line("stick radius, shakedown", "none", no_shakedown_in_a_pass);
  if (result.wear) return text + wear_text(*result.wear, result.fem_case.units);
  if (result.mdr.worn_radius)
    text += answer_line("wear ends at the radius", "", with_unit(*result.mdr.worn_radius, 0, "m"));
  return text;
}

}  // namespace fretval
