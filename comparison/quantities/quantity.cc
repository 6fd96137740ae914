#include "comparison/quantities/quantity.h"

#include <algorithm>
#include <cmath>

namespace fretval {

const QuantityTraits& traits_of(Quantity quantity) {
  constexpr auto none = RefinedFor::none, any = RefinedFor::any_case, cycles = RefinedFor::cycles;
  constexpr bool friction = true, settling = true, periodic = true, no = false;
  constexpr QuantityScale itself{Over::value, "relative"}, a{Over::contact_radius, "over a"},
      force{Over::sliding_force, "over sliding"}, work{Over::sliding_work, "over sliding"};
  constexpr auto ratio = [](const char* words) { return QuantityScale{Over::nothing, words}; };
  constexpr auto of_case = ratio("over that of the case"), of_largest = ratio("over the largest");
  // In the order of the enumeration.
  static constexpr std::array<QuantityTraits, all_quantities.size()> table{{
      {"axis_pressure_max", "largest pressure on the axis", "pressure", itself, "Pa", 1, {1}, none},
      {"bulk_work", "energy lost in the body", "bulk loss", itself, "J", 1, {2}, cycles, friction, no, periodic},
      {"contact_across", "extent of the contact across", "contact across", a, "m", 1, {3}, none},
      {"contact_along", "extent of the contact along", "contact along", a, "m", 1, {3}, none},
      {"contact_radius_max", "largest contact radius", "contact radius", a, "m", 10, {3}},
      {"cycle_work", "energy lost altogether", "loss", itself, "J", 1, {2}, cycles, friction, no, periodic},
      {"cycles_to_shakedown", "cycles to shakedown", "cycles", itself, "cycles", 1, {1}, none, no, settling, periodic},
      {"distance_to_limit", "distance from the limiting profile", "distance", ratio("over a and d max"), "", 0.5, {2}},
      {"first_slip_across", "extent across, first slip", "first slip across", a, "m", 1, {3}, none, friction},
      {"first_slip_along", "extent along, first slip", "first slip along", a, "m", 1, {3}, none, friction},
      {"force_outside_stick_zone", "force outside c", "force outside", ratio("over the force"), "", 1, {1}},
      {"friction_work", "energy lost to friction", "friction", work, "J", 10, {2}, cycles, friction},
      {"indentation_max", "largest indentation", "largest depth", itself, "m", 10, {3}, any},
      {"limiting_amplitude", "amplitude at which slip begins inside c", "amplitude", of_case, "", 1, {1}},
      {"maximum_indentation", "indentation at which the flank touches", "indentation", of_largest, "", 1, {1}},
      {"normal_force_max", "largest normal force", "normal force", itself, "N", 10, {3}, any},
      {"shakedown_across",
       "extent across, shakedown",
       "shakedown across",
       a,
       "m",
       1,
       {3},
       none,
       friction,
       no,
       periodic},
      {"shakedown_along", "extent along, shakedown", "shakedown along", a, "m", 1, {3}, none, friction, no, periodic},
      {"slip_decay", "decay of slip in a cycle", "slip decay", itself, "", 1, {2}, none, no, settling, periodic},
      {"slip_inside_stick_zone", "slip inside c", "slip inside", ratio("over the amplitude"), "", 1, {1}},
      {"stick_radius_first_slip", "stick radius, first slip", "first slip", a, "m", 1, {3}, any, friction},
      {"stick_radius_shakedown", "stick radius, shakedown", "shakedown", a, "m", 1, {3}, any, friction},
      {"tangential_amplitude", "tangential amplitude", "u_x", itself, "m", 1, {2}, any, friction},
      {"tangential_force_max", "largest tangential force", "tangential force", itself, "N", 1, {2}, cycles, friction},
      {"tangential_force_mean", "mean tangential force", "mean force", force, "N", 1, {2}, cycles, friction},
      {"tangential_work", "area of the tangential loop", "loop", itself, "J", 1, {2}, cycles, friction, no, periodic},
      {"transverse_force_max", "largest transverse force", "transverse force", itself, "N", 1, {2}, cycles, friction},
      {"worn_radius", "outer radius of the wear", "worn radius", a, "m", 0.2, {2}},
      {"worn_volume", "worn volume", "worn volume", ratio("over that of the limit"), "m³", 0.5, {2}, any, friction},
  }};
  return table[static_cast<std::size_t>(quantity)];
}

bool is_of_stick_zone(Quantity quantity) {
  constexpr std::array zones{Quantity::stick_radius_first_slip, Quantity::stick_radius_shakedown,
                             Quantity::first_slip_along,        Quantity::first_slip_across,
                             Quantity::shakedown_along,         Quantity::shakedown_across};
  return std::find(zones.begin(), zones.end(), quantity) != zones.end();
}

bool is_relative(Quantity quantity, const Scales& scales) {
  const auto over = traits_of(quantity).scale.over;
  return over == Over::value || (over == Over::contact_radius && scales.contact_radius == 0);
}

double scale_of(Quantity quantity, const Scales& scales, double value) {
  if (is_relative(quantity, scales)) return std::abs(value);
  const auto over = traits_of(quantity).scale.over;
  if (over == Over::sliding_force) return scales.sliding_force;
  if (over == Over::sliding_work) return scales.sliding_work;
  return over == Over::contact_radius ? scales.contact_radius : 1;
}

double without_roundoff(Quantity quantity, const Scales& scales, double value) {
  constexpr double roundoff = 1e-12;
  return std::abs(value) < roundoff * scale_of(quantity, scales, value) ? 0 : value;
}

std::string column_of(Quantity quantity, const std::string& who) {
  const auto& traits = traits_of(quantity);
  std::string title = traits.title;
  // A comma would end the column.
  if (const auto comma = title.find(", "); comma != std::string::npos) title.replace(comma, 2, " (").append(")");
  return title + who + (*traits.unit ? " [" + std::string(traits.unit) + "]" : " [1]");
}

std::optional<Quantity> quantity_of(const std::string& name) {
  const auto found =
      std::find_if(all_quantities.begin(), all_quantities.end(), [&](Quantity q) { return name == name_of(q); });
  return found == all_quantities.end() ? std::nullopt : std::optional(*found);
}

}  // namespace fretval
