#include "comparison/verification/trade/trade_plan.h"

#include <algorithm>

namespace fretval {
namespace {

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
