#include "comparison/verification/trade/trade_plan.h"

#include <algorithm>
#include <map>

namespace fretval {
namespace {

constexpr double joint_growth = 0.3, worn_edge_tolerance = 1e-3;
constexpr unsigned slow_finest_rings = 48;
constexpr int slow_finest_steps = 96;

/// A resolution whose number of steps is enough for a tolerance also has a start, a creep and a periodicity that are.
Resolution with_start_for(int steps_per_cycle, const FemCase& fem) {
  for (const double tolerance : {1e-2, 1e-3})
    if (steps_per_cycle <= 1.5 * resolution_for(tolerance).steps_per_cycle) return chosen_resolution(tolerance, fem);
  return chosen_resolution(1e-4, fem);
}

Resolution joint_setting(unsigned rings, unsigned degree, int steps, const FemCase& fem) {
  Resolution r = with_start_for(steps, fem);
  r.elements_per_radius = rings;
  r.degree = degree;
  r.growth = joint_growth;
  r.far_radius = rings <= 32 ? 12 : 25;
  r.worn_edge_ring = resolution_for(worn_edge_tolerance).worn_edge_ring;
  r.steps_per_cycle = steps;
  return r;
}

Resolution reference_of(const TradeAxes& axes, const FemCase& fem) {
  Resolution r = chosen_resolution(1e-4, fem);
  const unsigned finest = axes.rings.back();
  r.elements_per_radius = finest > 64 ? 64 : finest;
  r.degree = 3;
  r.growth = joint_growth;
  r.far_radius = axes.far_radii.back();
  r.worn_edge_ring = resolution_for(worn_edge_tolerance).worn_edge_ring;
  r.steps_per_cycle = axes.steps.back();
  return r;
}

TradeAxes affordable(TradeAxes axes, const FemCase& fem) {
  if (fem.motion.phase) return axes;
  const auto keep = [](auto& values, auto largest) {
    values.erase(std::remove_if(values.begin(), values.end(), [=](auto v) { return v > largest; }), values.end());
  };
  keep(axes.rings, slow_finest_rings);
  keep(axes.steps, slow_finest_steps);
  return axes;
}

}  // namespace

const std::array<TradeAxis, 5>& trade_axes() {
  static const std::array<TradeAxis, 5> axes{
      {{"rings", [](const Resolution& r) -> double { return r.elements_per_radius; }},
       {"time step", [](const Resolution& r) -> double { return r.steps_per_cycle; }},
       {"far field", [](const Resolution& r) { return r.far_radius; }},
       {"grading", [](const Resolution& r) { return r.growth; }, true},
       {"element order", [](const Resolution& r) -> double { return r.degree; }, false, false}}};
  return axes;
}

Resolution chosen_resolution(double tolerance, const FemCase& fem) {
  return resolution_for(tolerance, fem.relaxation.has_memory());
}

TradePlan trade_plan(const FemCase& fem, const TradeAxes& wanted) {
  const auto axes = affordable(wanted, fem);
  TradePlan plan{axes.tolerances, reference_of(axes, fem), {}, {}};
  const auto vary = [&](const char* axis, const auto& values, auto entry) {
    for (const auto value : values) {
      Resolution r = plan.reference;
      r.*entry = value;
      plan.settings[r].insert(axis);
    }
  };
  vary("rings", axes.rings, &Resolution::elements_per_radius);
  vary("element order", axes.degrees, &Resolution::degree);
  vary("grading", axes.growths, &Resolution::growth);
  vary("far field", axes.far_radii, &Resolution::far_radius);
  vary("time step", axes.steps, &Resolution::steps_per_cycle);
  for (const unsigned rings : axes.rings)
    for (const unsigned degree : axes.joint_degrees)
      for (const int steps : axes.steps) plan.settings[joint_setting(rings, degree, steps, fem)].insert("joint");
  for (const double tolerance : plan.tolerances) plan.settings[chosen_resolution(tolerance, fem)].insert("chosen");
  for (const unsigned rings : axes.full_rings) {
    plan.full.push_back(joint_setting(rings, 2, axes.steps.front(), fem));
    plan.settings[plan.full.back()].insert("joint");
  }
  return plan;
}

}  // namespace fretval
