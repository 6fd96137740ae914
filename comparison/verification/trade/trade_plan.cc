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

/// One run has to do where histories are long or bodies large.
int repetitions_for(const FemCase& fem) {
  return fem.relaxation.viscosity > 0 || !fem.motion.phase || fem.worn_edge ? 1 : 2;
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

const char* name_of(Sweep sweep) {
  switch (sweep) {
    case Sweep::rings:
      return "rings";
    case Sweep::element_order:
      return "element order";
    case Sweep::grading:
      return "grading";
    case Sweep::far_field:
      return "far field";
    case Sweep::time_step:
      return "time step";
    case Sweep::joint:
      return "joint";
    case Sweep::chosen:
      break;
  }
  return "chosen";
}

Resolution chosen_resolution(double tolerance, const FemCase& fem) {
  return resolution_for(tolerance, fem.relaxation.has_memory());
}

TradePlan trade_plan(const FemCase& fem, const TradeAxes& wanted) {
  const auto axes = affordable(wanted, fem);
  TradePlan plan{axes.tolerances, reference_of(axes, fem), {}, {}, repetitions_for(fem), {}};
  std::map<Resolution, std::set<Sweep>> settings;
  const auto vary = [&](Sweep sweep, const auto& values, auto entry) {
    for (const auto value : values) {
      Resolution r = plan.reference;
      r.*entry = value;
      settings[r].insert(sweep);
    }
  };
  vary(Sweep::rings, axes.rings, &Resolution::elements_per_radius);
  vary(Sweep::element_order, axes.degrees, &Resolution::degree);
  vary(Sweep::grading, axes.growths, &Resolution::growth);
  vary(Sweep::far_field, axes.far_radii, &Resolution::far_radius);
  vary(Sweep::time_step, axes.steps, &Resolution::steps_per_cycle);
  for (const unsigned rings : axes.rings)
    for (const unsigned degree : axes.joint_degrees)
      for (const int steps : axes.steps) settings[joint_setting(rings, degree, steps, fem)].insert(Sweep::joint);
  for (const double tolerance : plan.tolerances) settings[chosen_resolution(tolerance, fem)].insert(Sweep::chosen);
  for (const unsigned rings : axes.full_rings) {
    plan.full.push_back(joint_setting(rings, 2, axes.steps.front(), fem));
    settings[plan.full.back()].insert(Sweep::joint);
  }
  for (const auto& [resolution, sweeps] : settings) plan.settings.push_back({resolution, sweeps});
  plan.springs = {{50, 45, 5, 1e-4}, {100, 90, 10, 1e-5}, {200, 180, 20, 1e-6}, {400, 360, 20, 1e-7}};
  return plan;
}

}  // namespace fretval
