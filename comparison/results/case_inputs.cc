#include "comparison/results/case_inputs.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>

#include "comparison/case_file/entry_lookup.h"
#include "comparison/results/answer_text.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

class Inputs {
 public:
  /// Adds a value in the unit of its entry. of: what the value belongs to, told behind the name.
  void add(const char* section, const std::string& name, const ordered_json& value, const std::string& of = "") {
    const auto& dimensions = find_entry(section, name)->dimensions;
    const bool has_unit = !dimensions.empty() && (value.is_number() || (value.is_array() && value.front().is_number()));
    const auto unit = has_unit ? base_unit(dimensions.front()) : "";
    add_in(unit == "deg" ? "°" : unit, section, name + of, value);
  }
  /// Adds a value in a unit that another entry decides.
  void add_in(const std::string& unit, const char* section, const std::string& name, const ordered_json& value) {
    list_.push_back({{"section", section}, {"name", name}, {"value", value}, {"unit", unit}});
  }
  /// Adds a value unless it is zero or empty, as values of another choice of the section are.
  void add_if_any(const char* section, const std::string& name, const ordered_json& value, const std::string& of = "") {
    if (value.empty() || value == "" || (value.is_number() && value.get<double>() == 0)) return;
    add(section, name, value, of);
  }
  /// Adds the entries that have a field in this part of the case, if their value differs from that of a new case.
  /// varying: the unit of an entry whose unit depends on another entry.
  template <class Part>
  void add_fields(const char* section, const Part& part, const std::string& varying = "") {
    for (const auto& entry : find_section(section)->entries) {
      const auto* field = std::get_if<double Part::*>(&entry.field);
      if (!field || part.*(*field) == Part().*(*field)) continue;
      if (entry.dimensions.front() == Dimension::varying)
        add_in(varying, section, entry.name, part.*(*field));
      else
        add(section, entry.name, part.*(*field));
    }
  }
  [[nodiscard]] const ordered_json& list() const { return list_; }

 private:
  ordered_json list_ = ordered_json::array();
};

void add_indenter(const Case::Indenter& indenter, Inputs& inputs) {
  inputs.add("Indenter", "Shape", Case::shape_names[static_cast<std::size_t>(indenter.shape)]);
  inputs.add_if_any("Indenter", "Table", indenter.table);
  inputs.add_fields("Indenter", indenter, fmt::format("m^{:g}", 1 - indenter.exponent));
  if (indenter.trace) inputs.add("Indenter", "Table alignment", "fit");
}

void add_elastomer(const Case::Elastomer& elastomer, Inputs& inputs) {
  inputs.add("Elastomer", "Rheology", elastomer.rheology_name());
  const auto& curve = elastomer.master_curve;
  const auto& shift = elastomer.shift;
  if (curve) {
    inputs.add("Elastomer", "Table", curve->table);
    inputs.add("Elastomer", "Table modulus", curve->youngs ? "Young" : "shear");
  }
  if (elastomer.shore_a) inputs.add("Elastomer", "Shore A", *elastomer.shore_a);
  inputs.add_if_any("Elastomer", "Branches", elastomer.branches_file);
  if (const auto& test = elastomer.test_duration) inputs.add("Elastomer", "Duration of the test", test->seconds);
  const std::string fitted = curve ? ", fitted" : "", shifted = shift ? " at the Temperature" : "";
  inputs.add("Elastomer", "Relaxed shear modulus", elastomer.relaxed_modulus, fitted);
  inputs.add_if_any("Elastomer", "Branch moduli", elastomer.branch_moduli, fitted);
  inputs.add_if_any("Elastomer", "Branch times", elastomer.branch_times, fitted + shifted);
  inputs.add_if_any("Elastomer", "Viscosity", elastomer.viscosity, fitted + shifted);
  inputs.add_fields("Elastomer", elastomer);
  if (!shift) return;
  inputs.add("Elastomer", "Temperature", shift->temperature);
  inputs.add("Elastomer", "Reference temperature", shift->reference);
  inputs.add("Elastomer", "WLF C1", shift->c1);
  inputs.add("Elastomer", "WLF C2", shift->c2);
}

void add_mesh(const Case::Body& body, Inputs& inputs) {
  inputs.add("Body", "Mesh", body.mesh);
  if (body.mesh_unit != 1) inputs.add("Body", "Mesh unit", body.mesh_unit);
  std::vector<std::string> moduli;
  for (const auto& [material, value] : body.relative_moduli) moduli.push_back(fmt::format("{} {:g}", material, value));
  inputs.add_if_any("Body", "Relative moduli", moduli);
}

void add_body(const Case::Body& body, Inputs& inputs) {
  if (body.is_half_space()) return;
  inputs.add("Body", "Shape", Case::Body::shape_names[static_cast<std::size_t>(body.shape)]);
  if (body.grid)
    add_mesh(body, inputs);
  else
    inputs.add_fields("Body", body);
  inputs.add("Body", "Base", body.is_bonded ? "bonded" : "frictionless");
}

/// "5 µm at 2 Hz, phase 30°" of each.
std::vector<std::string> texts_of(const std::vector<Case::Harmonic>& harmonics, const char* unit) {
  std::vector<std::string> texts;
  for (const auto& [amplitude, frequency, phase] : harmonics)
    texts.push_back(fmt::format("{} at {:g} Hz, phase {:g}°", with_prefix(amplitude, unit, 6), frequency, phase));
  return texts;
}

void add_harmonics(const char* direction, bool of_force, const std::vector<Case::Harmonic>& harmonics, Inputs& inputs) {
  inputs.add_if_any("Motion", fmt::format("{} {}harmonics", direction, of_force ? "force " : ""),
                    texts_of(harmonics, of_force ? "N" : "m"));
}

void add_motion(const Case::Motion& motion, Inputs& inputs) {
  if (motion.path) {
    inputs.add("Motion", "Path", motion.path->file);
    inputs.add("Motion", "Path repeats", motion.path->repeats ? "forever" : "once");
    return;
  }
  if (motion.normal_force) {
    inputs.add("Motion", "Normal force", motion.normal_force->mean);
    inputs.add("Motion", "Normal force amplitude", motion.normal_force->amplitude);
  } else {
    inputs.add("Motion", "Indentation", motion.indentation);
    inputs.add("Motion", "Normal amplitude", motion.normal_amplitude);
  }
  inputs.add("Motion", "Normal frequency", motion.normal_frequency);
  add_harmonics("Normal", motion.normal_force.has_value(), motion.normal_harmonics, inputs);
  if (motion.tangential_force)
    inputs.add("Motion", "Tangential force amplitude", *motion.tangential_force);
  else if (std::isnan(motion.tangential_amplitude))
    inputs.add("Motion", "Tangential amplitude", "shakedown");
  else
    inputs.add("Motion", "Tangential amplitude", motion.tangential_amplitude);
  inputs.add("Motion", "Tangential frequency", motion.tangential_frequency);
  add_harmonics("Tangential", motion.tangential_force.has_value(), motion.tangential_harmonics, inputs);
  inputs.add("Motion", "Phase", motion.phase ? ordered_json(*motion.phase) : ordered_json("free"));
  add_harmonics("Transverse", motion.tangential_force.has_value(), motion.transverse, inputs);
}

void add_contact(const Case::Contact& contact, Inputs& inputs) {
  if (!contact.is_full()) return;
  inputs.add("Contact", "Friction", "vector");
  inputs.add("Contact", "Coupling", contact.coupled ? "on" : "off");
  if (contact.second_algorithm) inputs.add("Contact", "Second algorithm", "on");
}

void add_measured(const Case& input, Inputs& inputs) {
  if (!input.measured) return;
  inputs.add_if_any("Measured", "Loops", input.measured->loop);
  const auto add_radius = [&](const std::string& name, const std::optional<Case::Measured::Value>& radius) {
    if (!radius) return;
    inputs.add("Measured", name, radius->value);
    inputs.add("Measured", name + " uncertainty", radius->uncertainty);
  };
  add_radius("Stick radius", input.measured->stick_radius);
  add_radius("Contact radius", input.measured->contact_radius);
}

void add_wear(const Case& input, Inputs& inputs) {
  if (input.wear == Case::Wear::limiting) {
    inputs.add("Wear", "State", "limiting");
    inputs.add("Wear", "Stick radius ratio", input.worn_stick_ratio);
  }
  const auto& wear = input.wear_kinetics;
  if (!wear) return;
  const bool power = wear->law == Case::WearLaw::power;
  inputs.add("Wear", "Law", Case::wear_law_names[static_cast<std::size_t>(wear->law)]);
  if (power)
    inputs.add_in(fmt::format("Pa^{:g}", -wear->exponent), "Wear", "Coefficient", wear->coefficient);
  else
    inputs.add("Wear", "Coefficient", wear->coefficient);
  if (power) inputs.add("Wear", "Exponent", wear->exponent);
  const char* without = find_entry("Wear", "Cycles")->without;
  inputs.add("Wear", "Cycles", wear->n_cycles ? ordered_json(*wear->n_cycles) : ordered_json(without));
  inputs.add_if_any("Wear", "Until", wear->until);
  inputs.add_if_any("Wear", "Profile", wear->profile);
  inputs.add_if_any("Wear", "Worn rings", wear->rings);
}

}  // namespace

bool takes_prefixes(const std::string& unit) {
  for (const char* plain : {"m", "N", "Pa", "Pa s", "s"})
    if (unit == plain) return true;
  return false;
}

ordered_json inputs_json(const Case& input) {
  Inputs inputs;
  add_indenter(input.indenter, inputs);
  add_elastomer(input.elastomer, inputs);
  add_body(input.body, inputs);
  inputs.add("Friction", "Coefficient", input.friction_coefficient);
  add_contact(input.contact, inputs);
  add_motion(input.motion, inputs);
  add_wear(input, inputs);
  inputs.add("Accuracy", "Tolerance", input.tolerance);
  if (input.cycle_tolerance) inputs.add("Accuracy", "Cycle tolerance", *input.cycle_tolerance);
  if (input.rings_per_radius) inputs.add("Accuracy", "Rings per radius", *input.rings_per_radius);
  if (input.steps_per_cycle) inputs.add("Accuracy", "Steps per cycle", *input.steps_per_cycle);
  add_measured(input, inputs);
  return inputs.list();
}

std::string input_text(const ordered_json& value, const std::string& unit, int digits) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array()) {
    std::string text;
    for (const auto& one : value) text += (text.empty() ? "" : ", ") + input_text(one, unit, digits);
    return text;
  }
  if (value.is_null()) return "–";
  const double number = value.get<double>();
  if (unit.empty() || unit == "°") return fmt::format("{:.{}g}{}", number, digits, unit);
  if (unit == "degC") return fmt::format("{:.{}g} °C", number, digits);
  if (!takes_prefixes(unit) || number == 0) return fmt::format("{:.{}g} {}", number, digits, unit);
  return with_prefix(number, unit, digits);
}

}  // namespace fretval
