#include "comparison/results/case_inputs.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace fretval {
namespace {

using nlohmann::ordered_json;

/// A list that leaves out what a case does not have: zeros, empty lists and words.
class Inputs {
 public:
  void add(const char* section, const char* name, const ordered_json& value, const char* unit = "") {
    if (value.empty() || value == "" || (value.is_number() && !(value.get<double>() != 0))) return;
    list_.push_back({{"section", section}, {"name", name}, {"value", value}, {"unit", unit}});
  }
  [[nodiscard]] const ordered_json& list() const { return list_; }

 private:
  ordered_json list_ = ordered_json::array();
};

void add_indenter(const Case::Indenter& indenter, Inputs& inputs) {
  inputs.add("Indenter", "Shape", Case::shape_names[static_cast<std::size_t>(indenter.shape)]);
  inputs.add("Indenter", "Radius", indenter.radius, "m");
  inputs.add("Indenter", "Slope angle", indenter.slope_angle, "°");
  inputs.add("Indenter", "Coefficient", indenter.coefficient);
  inputs.add("Indenter", "Exponent", indenter.exponent);
  inputs.add("Indenter", "Flat radius", indenter.flat_radius, "m");
  inputs.add("Indenter", "Edge radius", indenter.edge_radius, "m");
  inputs.add("Indenter", "Table", indenter.table);
}

void add_elastomer(const Case::Elastomer& elastomer, Inputs& inputs) {
  inputs.add("Elastomer", "Rheology", elastomer.rheology);
  if (elastomer.master_curve) inputs.add("Elastomer", "Table", elastomer.master_curve->table);
  inputs.add("Elastomer", "Relaxed shear modulus", elastomer.relaxed_modulus, "Pa");
  inputs.add("Elastomer", "Branch moduli", elastomer.branch_moduli, "Pa");
  inputs.add("Elastomer", "Branch times", elastomer.branch_times, "s");
  inputs.add("Elastomer", "Viscosity", elastomer.viscosity, "Pa s");
  inputs.add("Elastomer", "Fractional order", elastomer.fractional_order);
}

void add_motion(const Case::Motion& motion, Inputs& inputs) {
  if (motion.path) {
    inputs.add("Motion", "Path", motion.path->file);
    inputs.add("Motion", "Path repeats", motion.path->repeats ? "forever" : "once");
    return;
  }
  inputs.add("Motion", "Indentation", motion.indentation, "m");
  inputs.add("Motion", "Normal amplitude", motion.normal_amplitude, "m");
  if (motion.normal_force) {
    inputs.add("Motion", "Normal force", motion.normal_force->mean, "N");
    inputs.add("Motion", "Normal force amplitude", motion.normal_force->amplitude, "N");
  }
  if (std::isnan(motion.tangential_amplitude))
    inputs.add("Motion", "Tangential amplitude", "shakedown");
  else
    inputs.add("Motion", "Tangential amplitude", motion.tangential_amplitude, "m");
  if (motion.tangential_force) inputs.add("Motion", "Tangential force amplitude", *motion.tangential_force, "N");
  inputs.add("Motion", "Normal frequency", motion.normal_frequency, "Hz");
  inputs.add("Motion", "Tangential frequency", motion.tangential_frequency, "Hz");
  if (motion.phase)
    inputs.add("Motion", "Phase", *motion.phase, "°");
  else
    inputs.add("Motion", "Phase", "free");
}

}  // namespace

ordered_json inputs_json(const Case& input) {
  Inputs inputs;
  add_indenter(input.indenter, inputs);
  add_elastomer(input.elastomer, inputs);
  inputs.add("Friction", "Coefficient", input.friction_coefficient);
  add_motion(input.motion, inputs);
  if (const auto& wear = input.wear_kinetics) {
    inputs.add("Wear", "Law", Case::wear_law_names[static_cast<std::size_t>(wear->law)]);
    inputs.add("Wear", "Coefficient", wear->coefficient);
    inputs.add("Wear", "Profile", wear->profile);
  }
  inputs.add("Accuracy", "Tolerance", input.tolerance);
  return inputs.list();
}

}  // namespace fretval
