#include "comparison/trade_command.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "comparison/batch.h"
#include "comparison/case_file.h"
#include "comparison/commands.h"
#include "comparison/files.h"
#include "comparison/stopwatch.h"
#include "comparison/trade.h"
#include "comparison/trade_json.h"
#include "fem/petsc_session.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

std::string setting_text(const Resolution& r) {
  return fmt::format("{:>5} {:>5} {:>7g} {:>5g} {:>6}", r.elements_per_radius, r.degree, r.growth, r.far_radius,
                     r.steps_per_cycle);
}

std::string megabytes(const std::optional<double>& bytes) {
  return bytes ? fmt::format("{:.1f}", *bytes / 1e6) : "-";
}

void print_point(const std::string& label, const TradePoint& point) {
  fmt::print("{:<12} {} {:>10.2e} {:>9.3f} {:>9}\n", label, setting_text(point.setting.resolution), point.error(),
             point.seconds.total(), megabytes(point.memory.total()));
}

void print_other_levels(const Trade& trade) {
  fmt::print("closed form: error 0 by definition, {:.2e} s, of which stick radii {:.1e} s (fastest of {})\n",
             trade.reference.seconds, trade.reference.stick_radii_seconds, trade.reference.n_repetitions);
  for (const auto& p : trade.springs)
    fmt::print("springs: {} springs, {} steps a period: {}\n", p.setting.n_springs, p.setting.steps_per_period,
               p.failure.empty() ? fmt::format("error {:.2e}, {:.3f} s", largest_of(p.errors), p.seconds) : p.failure);
  for (const auto& [p, condensed, seconds] : trade.full) {
    fmt::print("full finite elements: {} rings, order {}, {} dofs: ", p.resolution.elements_per_radius,
               p.resolution.degree, p.n_dofs);
    if (!p.failure.empty()) {
      fmt::print("{}\n", p.failure);
      continue;
    }
    const auto& same = trade.points.at(condensed);
    fmt::print(
        "pressure and traction within {:.1e} and {:.1e} of the condensed ones; {:.3f} and {:.3f} s a step measured\n"
        "  whole history extrapolated: {:.1f} s, error {:.2e}; condensed: {:.3f} s\n",
        p.pressure_difference, p.traction_difference, p.seconds_per_normal_step(), p.seconds_per_friction_step(),
        seconds, same.error(), same.seconds.total());
  }
}

std::string slope_text(const std::optional<LogSlope>& slope) {
  return slope ? fmt::format("{:.2f} ({})", slope->slope, slope->n_points) : "-";
}

void print_rates(const Trade& trade) {
  fmt::print("power of the error in each axis (points above the floor):\n");
  for (const auto& rate : trade.rates) {
    fmt::print("  {:<10} largest {}", name_of(rate.sweep), slope_text(rate.largest_error));
    for (const auto& [quantity, slope] : rate.slope) fmt::print(", {} {}", quantity, slope_text(slope));
    fmt::print("\n");
  }
  fmt::print("power of the seconds in the rings: {}\n", slope_text(trade.seconds_over_rings));
}

void print_trade(const Trade& trade) {
  fmt::print("{:<12} {:>5} {:>5} {:>7} {:>5} {:>6} {:>10} {:>9} {:>9}\n", "", "rings", "order", "grading", "far",
             "steps", "error", "seconds", "MB");
  for (const std::size_t i : trade.front) print_point("front", trade.points[i]);
  for (const auto& r : trade.recommendations) {
    if (r.cheapest) {
      print_point(fmt::format("best {:.0e}", r.tolerance), trade.points[*r.cheapest]);
    } else {
      fmt::print("best {:.0e}: no setting of the plan meets it\n", r.tolerance);
    }
    print_point(fmt::format("tool {:.0e}{}", r.tolerance, r.chosen_meets ? "" : " !"), trade.points[r.chosen]);
  }
  print_other_levels(trade);
  print_rates(trade);
}

}  // namespace

int run_trade(const std::string& file, const fs::path& output) {
  Stopwatch watch;
  const auto cases = read_case_file(file);
  if (cases.size() != 1)
    throw InputError(fmt::format("{}: a sweep has many trades; expected a file with a single case", file));
  const auto prepared = prepare(cases).front();
  for (const auto& warning : prepared.scene.warnings) spdlog::warn("{}", warning);
  const fs::path folder = output / prepared.scene.name;
  fs::create_directories(folder);
  const fem::PetscSession session;
  const auto plan = trade_plan(prepared.fem);
  const auto trade = compute_trade(prepared, plan);
  write_file(folder / "trade.json", trade_json(prepared, plan, trade).dump(2) + "\n");
  print_trade(trade);
  spdlog::info("{} settings in {:.1f} s: {}", trade.points.size(), watch.lap(), (folder / "trade.json").string());
  return trade.front.empty() ? exit_numerics_failed : exit_agree;
}

}  // namespace fretval
