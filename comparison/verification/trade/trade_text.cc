#include "comparison/verification/trade/trade_text.h"

#include <fmt/format.h>

#include <optional>

namespace fretval {
namespace {

std::string setting_text(const Resolution& r) {
  return fmt::format("{:>5} {:>5} {:>7g} {:>5g} {:>6}", r.elements_per_radius, r.degree, r.growth, r.far_radius,
                     r.steps_per_cycle);
}

std::string megabytes(const std::optional<double>& bytes) {
  return bytes ? fmt::format("{:.1f}", *bytes / 1e6) : "-";
}

std::string point_line(const std::string& label, const TradePoint& point) {
  return fmt::format("{:<12} {} {:>10.2e} {:>9.3f} {:>9}\n", label, setting_text(point.setting.resolution),
                     point.error(), point.seconds.total(), megabytes(point.memory_bytes));
}

std::string other_levels(const Trade& trade) {
  std::string text =
      fmt::format("closed form: error 0 by definition, {:.2e} s, of which stick radii {:.1e} s (fastest of {})\n",
                  trade.reference.seconds, trade.reference.stick_radii_seconds, trade.reference.n_repetitions);
  for (const auto& p : trade.springs)
    text += fmt::format(
        "springs: {} springs, {} steps a period: {}\n", p.setting.n_springs, p.setting.steps_per_period,
        p.failure.empty() ? fmt::format("error {:.2e}, {:.3f} s", largest_of(p.errors), p.seconds) : p.failure);
  for (const auto& [p, condensed, seconds] : trade.full) {
    text += fmt::format("full finite elements: {} rings, order {}, {} dofs: ", p.resolution.elements_per_radius,
                        p.resolution.degree, p.n_dofs);
    if (!p.failure.empty()) {
      text += p.failure + "\n";
      continue;
    }
    const auto& same = trade.points.at(condensed);
    text += fmt::format(
        "pressure and traction within {:.1e} and {:.1e} of the condensed ones; {:.3f} and {:.3f} s a step measured\n"
        "  whole history extrapolated: {:.1f} s, error {:.2e}; condensed: {:.3f} s\n",
        p.pressure_difference, p.traction_difference, p.seconds_per_normal_step(), p.seconds_per_friction_step(),
        seconds, same.error(), same.seconds.total());
  }
  return text;
}

std::string slope_text(const std::optional<LogSlope>& slope) {
  return slope ? fmt::format("{:.2f} ({})", slope->slope, slope->n_points) : "-";
}

std::string rates(const Trade& trade) {
  std::string text = "power of the error in each axis (points above the floor):\n";
  for (const auto& rate : trade.rates) {
    text += fmt::format("  {:<10} largest {}", name_of(rate.sweep), slope_text(rate.largest_error));
    for (const auto& [quantity, slope] : rate.slope)
      text += fmt::format(", {} {}", name_of(quantity), slope_text(slope));
    text += "\n";
  }
  return text + fmt::format("power of the seconds in the rings: {}\n", slope_text(trade.seconds_over_rings));
}

}  // namespace

std::string trade_text(const Trade& trade) {
  std::string text = fmt::format("{:<12} {:>5} {:>5} {:>7} {:>5} {:>6} {:>10} {:>9} {:>9}\n", "", "rings", "order",
                                 "grading", "far", "steps", "error", "seconds", "MB");
  for (const std::size_t i : trade.front) text += point_line("front", trade.points[i]);
  for (const auto& r : trade.recommendations) {
    if (r.cheapest) {
      text += point_line(fmt::format("best {:.0e}", r.tolerance), trade.points[*r.cheapest]);
    } else {
      text += fmt::format("best {:.0e}: no setting of the plan meets it\n", r.tolerance);
    }
    text += point_line(fmt::format("tool {:.0e}{}", r.tolerance, r.chosen_meets ? "" : " !"), trade.points[r.chosen]);
  }
  return text + other_levels(trade) + rates(trade);
}

}  // namespace fretval
