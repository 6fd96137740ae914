#include "comparison/results/answer_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fretval {
namespace {

struct Prefix {
  const char* name;
  double factor;
};
constexpr std::array prefixes{Prefix{"n", 1e-9}, Prefix{"µ", 1e-6}, Prefix{"m", 1e-3}, Prefix{"", 1},
                              Prefix{"k", 1e3},  Prefix{"M", 1e6},  Prefix{"G", 1e9}};

const Prefix& prefix_for(double value) {
  const auto* best = &prefixes.front();
  for (const auto& prefix : prefixes)
    if (std::abs(value) >= prefix.factor) best = &prefix;
  return *best;
}

/// Decimals that show a bar with one digit, or a value with six.
int decimals_of(double value, double bar) {
  constexpr int six = 5, most = 9;
  const auto exponent = [](double x) { return static_cast<int>(std::floor(std::log10(std::abs(x)))); };
  if (bar > 0 && std::isfinite(bar)) return std::clamp(-exponent(bar), 0, most);
  return value == 0 ? 0 : std::clamp(six - exponent(value), 0, most);
}

struct Value {
  std::optional<double> fe, mdr;
};

Value value_of(const CaseResult& result, Quantity quantity) {
  const auto& fe = result.fe.fe;
  const auto& mdr = result.mdr;
  switch (quantity) {
    case Quantity::stick_radius_first_slip:
      return {fe.stick_radius_first_slip, mdr.stick_radius_first_slip};
    case Quantity::stick_radius_shakedown:
      return {fe.stick_radius_shakedown, mdr.stick_radius_shakedown};
    case Quantity::contact_radius_max:
      return {fe.contact_radius_max, mdr.contact_radius_max};
    case Quantity::indentation_max:
      return {fe.indentation_max, mdr.indentation_max};
    case Quantity::tangential_amplitude:
      return {fe.tangential_amplitude, mdr.tangential_amplitude};
    case Quantity::worn_radius:
      return {result.wear->fe.worn_radius * result.fem_case.units.length, mdr.worn_radius};
    default:
      return {fe.normal_force_max, mdr.normal_force_max};
  }
}

std::string gross_slip_text(const std::optional<GrossSlipStart>& fe, const std::optional<double>& mdr) {
  const auto at = [](double share) { return fmt::format("at {:.1f} % of the amplitudes", 100 * share); };
  const std::string none = "no gross slip";
  return fmt::format(
      "gross slip: the tangential force comes to mu times the normal force. Finite elements: {}; MDR: {}",
      fe ? fmt::format("after {}, {}", with_unit(fe->time, 0, "s"), at(fe->amplitude)) : none, mdr ? at(*mdr) : none);
}

std::string verdict_text(const CaseResult& result) {
  double largest = 0;
  for (const auto& [quantity, difference] : result.comparison)
    largest = std::max(largest, std::abs(difference.difference.value_or(difference.only_one)));
  const auto any = [&](Verdict verdict) {
    return std::any_of(result.comparison.begin(), result.comparison.end(),
                       [&](const auto& compared) { return compared.second.verdict == verdict; });
  };
  if (any(Verdict::fail))
    return fmt::format("finite elements do not confirm MDR: they differ by up to {:.1e}", largest);
  if (any(Verdict::inconclusive))
    return fmt::format(
        "open: the error bars of the finite elements are wider than the tolerance; they differ from MDR by up to "
        "{:.1e}",
        largest);
  return fmt::format("finite elements confirm MDR to {:.1e}", largest);
}

/// What has become of the indenter.
std::string wear_text(const ProvedWear& wear, const Units& units) {
  const auto& last = wear.fe.course.curve.back();
  const double cubic_millimetres = 1e9;
  auto text = fmt::format("  worn off: {:.6g} mm³ in {:.3g} cycles", last.volume * units.volume() * cubic_millimetres,
                          last.cycles);
  if (wear.kinetics) text += fmt::format(" (MDR {:.6g} mm³)", wear.kinetics->curve.back().volume * cubic_millimetres);
  if (wear.ends_in_limit())
    return text +
           fmt::format("; nothing wears any more\n  worn profile: {:.1e} from the limiting one (in r/a and f/d max)\n",
                       wear.distance_shakedown.back());
  if (wear.fe.course.end == fem::WearEnd::cycles)
    return text + fmt::format("; still {:.2g} from the limiting profile\n", wear.distance_shakedown.back());
  return text + "; what still bears pressure sticks throughout, and wears no more\n";
}

}  // namespace

std::string with_unit(double value, double bar, const std::string& unit) {
  const auto& [name, factor] = prefix_for(value);
  const int decimals = decimals_of(value / factor, bar / factor);
  const auto number = fmt::format("{:.{}f}", value / factor, decimals);
  if (bar <= 0 || !std::isfinite(bar)) return fmt::format("{} {}{}", number, name, unit);
  return fmt::format("{} ± {:.{}f} {}{}", number, bar / factor, decimals, name, unit);
}

std::string answer_text(const CaseResult& result) {
  if (result.fe.fe.gross_slip || result.mdr.gross_slip)
    return fmt::format("{}: {}\n", result.input.name, gross_slip_text(result.fe.fe.gross_slip, result.mdr.gross_slip));
  const auto row = [](const std::string& title, const std::string& fe, const std::string& mdr) {
    return fmt::format("  {:<28} {:<28} {}\n", title, fe, mdr);
  };
  std::string text =
      fmt::format("{}: {}\n", result.input.name, verdict_text(result)) + row("", "finite elements", "MDR");
  for (const auto quantity : quantities_by_interest) {
    const auto compared = result.comparison.find(quantity);
    const auto& traits = traits_of(quantity);
    if (compared == result.comparison.end() || *traits.unit == '\0' || quantity == Quantity::worn_volume) continue;
    const auto [fe, mdr] = value_of(result, quantity);
    const bool over_a = quantity == Quantity::contact_radius_max || std::string(traits.scale) == "over a";
    const double scale = over_a ? result.fem_case.units.length : fe.value_or(0);
    const auto& bar = compared->second.bar;
    const auto shown = [&](const std::optional<double>& value, double width) {
      return value ? with_unit(*value, width, traits.unit) : std::string("none");
    };
    text += row(traits.title, shown(fe, bar ? bar->total() * scale : 0), shown(mdr, 0));
  }
  if (result.wear) return text + wear_text(*result.wear, result.fem_case.units);
  if (result.mdr.worn_radius) text += row("wear ends at the radius", "", with_unit(*result.mdr.worn_radius, 0, "m"));
  return text;
}

}  // namespace fretval
