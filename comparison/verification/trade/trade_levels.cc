#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "comparison/reference/mdr_document.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/run/estimate.h"
#include "comparison/simulation/bodies/body.h"
#include "comparison/simulation/compute_case.h"
#include "comparison/simulation/fem_case/resolution.h"
#include "comparison/support/constants.h"
#include "comparison/support/log.h"
#include "comparison/support/progress.h"
#include "comparison/support/stopwatch.h"
#include "comparison/verification/trade/trade.h"
#include "fem/full_model/full_history.h"
#include "fem/ring_contact/static_contact.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

constexpr double closed_form_seconds = 0.5;
constexpr double right_angle = pi / 2;
constexpr int n_full_cycles = 2;

constexpr std::array spring_settings{SpringSetting{50, 45, 5, 1e-4}, SpringSetting{100, 90, 10, 1e-5},
                                     SpringSetting{200, 180, 20, 1e-6}, SpringSetting{400, 360, 20, 1e-7}};

template <class Compute>
TradeLevel attempted(TradeLevel level, const Compute& compute) {
  try {
    compute(level);
  } catch (const std::runtime_error& error) {
    level.failure = error.what();
    log::warn(fmt::format("a setting failed: {}", level.failure));
  }
  return level;
}

Readings readings_of(const mdr::SpringHistory& history, const mdr::Profile& profile) {
  const auto radius = [&](double depth) {
    return Reading{depth > 0 ? std::optional(mdr::inverse_transform(profile, depth)) : std::nullopt};
  };
  return {{Quantity::normal_force_max, {*std::max_element(history.normal_force.begin(), history.normal_force.end())}},
          {Quantity::stick_radius_first_slip, radius(history.depths.first_slip)},
          {Quantity::stick_radius_shakedown, radius(history.depths.shakedown)}};
}

/// The compared quantities of the state to which the motion settles, for which the forces of sliding are no scale.
Quantities in_units_of(const FemCase& fem, Readings readings) {
  return compared_quantities(readings, {fem.units.length, 1, 1}, fem.units);
}

TradeLevel spring_level(const PreparedCase& prepared, const Quantities& reference, const SpringSetting& setting) {
  return attempted({"springs", {{"springs", setting.n_springs}, {"steps_per_cycle", setting.steps_per_cycle}}},
                   [&](TradeLevel& level) {
                     Stopwatch watch;
                     const auto answer = spring_answer(prepared.input, setting);
                     level.seconds = watch.lap();
                     const auto readings = readings_of(answer.history, prepared.mdr.profile);
                     level.errors = errors_of(in_units_of(prepared.fem, readings), reference);
                   });
}

FeAnswer computed_alone(const PreparedCase& prepared, const Resolution& resolution) {
  BodyStore its_own;
  return compute_case(prepared.fem, resolution, its_own);
}

/// Seconds of the body and of as many steps as the condensed elements took. An unlocked phase is a right angle here:
/// the cost of a step does not depend on it.
double seconds_of_full_model(const PreparedCase& prepared, const Resolution& resolution, const FeAnswer& condensed) {
  FemCase fem = at_resolution(prepared.fem, resolution);
  fem.motion.n_ramp_cycles = 1;
  if (!std::exchange(fem.motion.locked, true)) fem.motion.tangential.front().phase = right_angle;
  const int steps = fem.steps_per_cycle();
  const auto body = make_body(fem.body);
  const Eigen::VectorXd profile = fem::ring_means(body.normal.contact.compliance, fem.profile);
  Stopwatch watch;
  const auto normal = fem::full_normal_history(body.normal.space, body.normal.contact.series, fem.relaxation, profile,
                                               fem.motion, steps, n_full_cycles);
  double seconds = body.cost.total() + watch.lap() / n_full_cycles * condensed.normal.n_cycles;
  if (!body.tangential) return seconds;
  fem::full_friction_history(body.tangential->space, fem.relaxation, fem.friction_coefficient, fem.motion,
                             normal.pressure, steps, n_full_cycles);
  return seconds + watch.lap() / (n_full_cycles * steps) * static_cast<double>(condensed.n_steps);
}

TradeLevel full_level(const PreparedCase& prepared, const Quantities& reference, const Resolution& resolution) {
  return attempted({"all dofs", resolution_json(resolution)}, [&](TradeLevel& level) {
    const auto condensed = computed_alone(prepared, resolution);
    level.seconds = seconds_of_full_model(prepared, resolution, condensed);
    level.errors = errors_of(quantities_of(condensed, prepared.fem.units), reference);
  });
}

/// The closed form, with its periodic normal response.
TradeLevel closed_form_level(const PreparedCase& prepared, const Quantities& reference) {
  TradeLevel level{"closed form", ordered_json::object(), {}, errors_of(reference, reference)};
  level.seconds = std::numeric_limits<double>::infinity();
  Stopwatch watch;
  for (double spent = 0; spent < closed_form_seconds;) {
    mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr));
    const double lap = watch.lap();
    level.seconds = std::min(level.seconds, lap);
    spent += lap;
  }
  return level;
}

/// "condensed, elements per radius 64, degree 3, …"
std::string title_of(std::string title, const ordered_json& setting) {
  for (const auto& [key, value] : setting.items()) {
    auto words = key;
    std::replace(words.begin(), words.end(), '_', ' ');
    title += fmt::format(", {} {}", words, value.dump());
  }
  return title;
}

/// Seconds of the condensed levels, which are nearly all, by their titles. Each pays for its body and its histories.
std::map<std::string, double> expected_seconds(const PreparedCase& prepared, const TradePlan& plan) {
  std::map<std::string, double> seconds;
  for (const auto& [resolution, axes] : plan.settings)
    seconds[title_of("condensed", resolution_json(resolution))] =
        seconds_of_one(resolution, prepared.fem.motion.highest_order());
  return seconds;
}

constexpr unsigned slow_finest_rings = 48, reference_rings = 64;
constexpr int slow_finest_steps = 96;

/// A resolution whose number of steps is enough for a tolerance also has a start, a creep and a periodicity that are.
Resolution with_start_for(int steps_per_cycle, const FemCase& fem) {
  for (const double tolerance : {1e-2, 1e-3})
    if (steps_per_cycle <= 1.5 * resolution_for(tolerance).steps_per_cycle) return chosen_resolution(tolerance, fem);
  return chosen_resolution(1e-4, fem);
}

Resolution joint_setting(unsigned rings, unsigned order, int steps, const FemCase& fem) {
  Resolution r = with_start_for(steps, fem);
  r.elements_per_radius = rings;
  r.degree = order;
  r.growth = 0.3;
  r.far_radius = rings <= 32 ? 12 : 25;
  r.worn_edge_ring = resolution_for(1e-3).worn_edge_ring;
  r.steps_per_cycle = steps;
  return r;
}

template <class Value>
void leave_out_above(std::vector<Value>& values, Value largest) {
  values.erase(std::remove_if(values.begin(), values.end(), [=](Value v) { return v > largest; }), values.end());
}

}  // namespace

std::vector<TradeLevel> computed_levels(const PreparedCase& prepared, const TradePlan& plan) {
  const auto exact = mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr));
  const auto reference = in_units_of(prepared.fem, compared_readings_of(exact));
  const bool has_springs = prepared.input.motion.phase && why_no_springs(prepared.input).empty();
  Progress progress(plan.settings.size() + plan.full.size() + (has_springs ? spring_settings.size() : 0) + 1,
                    expected_seconds(prepared, plan));
  // The first body of a process also pays for what its libraries load and allocate once and for all.
  make_body(at_resolution(prepared.fem, plan.settings.begin()->first).body);
  std::vector<TradeLevel> levels;
  const auto add = [&](TradeLevel&& level) {
    const auto title = title_of(level.kind, level.setting);
    progress.done(title, level.failure.empty(), title);
    levels.push_back(std::move(level));
  };
  for (const auto& [resolution, axes] : plan.settings)
    add(attempted({"condensed", resolution_json(resolution), axes}, [&, &r = resolution](TradeLevel& level) {
      const auto answer = computed_alone(prepared, r);
      level.seconds = answer.seconds_alone();
      level.errors = errors_of(quantities_of(answer, prepared.fem.units), reference);
    }));
  for (const auto& resolution : plan.full) add(full_level(prepared, reference, resolution));
  if (has_springs)
    for (const auto& setting : spring_settings) add(spring_level(prepared, reference, setting));
  add(closed_form_level(prepared, reference));
  return levels;
}

Resolution chosen_resolution(double tolerance, const FemCase& fem) {
  return resolution_for(tolerance, fem.relaxation.has_memory());
}

TradePlan trade_plan(const FemCase& fem, TradeGrid grid) {
  if (!fem.motion.locked) {
    leave_out_above(grid.rings, slow_finest_rings);
    leave_out_above(grid.steps, slow_finest_steps);
  }
  TradePlan plan{
      joint_setting(std::min(grid.rings.back(), reference_rings), 3, grid.steps.back(), fem), {}, {}, grid.tolerances};
  const auto vary = [&](const char* axis, const auto& values, auto entry) {
    for (const auto value : values) {
      Resolution r = plan.reference;
      r.*entry = value;
      plan.settings[r][axis] = value;
    }
  };
  vary("rings", grid.rings, &Resolution::elements_per_radius);
  vary("order", grid.orders, &Resolution::degree);
  vary("grading", grid.gradings, &Resolution::growth);
  vary("far radius", grid.far_radii, &Resolution::far_radius);
  vary("steps", grid.steps, &Resolution::steps_per_cycle);
  for (const unsigned rings : grid.rings)
    for (const unsigned order : grid.joint_orders)
      for (const int steps : grid.steps) plan.settings[joint_setting(rings, order, steps, fem)];
  for (const double tolerance : plan.tolerances) plan.settings[chosen_resolution(tolerance, fem)];
  for (const unsigned rings : grid.full_rings) plan.full.push_back(joint_setting(rings, 2, grid.steps.front(), fem));
  return plan;
}

}  // namespace fretval
