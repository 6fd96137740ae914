#include "comparison/case_entries.h"

#include <deal.II/base/parameter_handler.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace fretval {
namespace {

struct Section {
  const char* name;
  std::vector<const char*> entries;
};

const std::vector<Section>& sections() {
  static const std::vector<Section> all{
      {"Indenter", {"Shape", "Radius", "Slope angle", "Coefficient", "Exponent"}},
      {"Elastomer", {"Rheology", "Relaxed shear modulus", "Viscosity", "Branch moduli", "Branch times"}},
      {"Friction", {"Coefficient", "Law"}},
      {"Motion",
       {"Indentation", "Normal amplitude", "Normal frequency", "Tangential amplitude", "Tangential frequency",
        "Phase"}},
      {"Wear", {"State", "Stick radius ratio"}},
      {"Accuracy", {"Tolerance", "Rings per radius", "Steps per cycle"}},
      {"Output", {"Fields"}},
      {"Sweep", {"Entry", "Values"}}};
  return all;
}

const ValidNumber positive{[](double x) { return x > 0; }, "a positive number"};
const ValidNumber not_negative{[](double x) { return x >= 0; }, "a number that is not negative"};

bool is_whole(double x, double least, double most) {
  return x == std::floor(x) && x >= least && x <= most;
}
const ValidNumber ring_count{[](double x) { return is_whole(x, 8, 640); }, "a whole number from 8 to 640"};
const ValidNumber step_count{[](double x) { return is_whole(x, 12, 10000); }, "a whole number from 12 to 10000"};

double parse_number(const std::string& text, bool& ok) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  ok = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
  return value;
}

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

Case::Indenter read_indenter(const EntryReader& entries) {
  const std::string section = "Indenter";
  Case::Indenter indenter;
  const std::string shape = entries.one_of(section, "Shape", {"parabola", "cone", "power"});
  const auto belongs = [&](const char* name, const char* owner) {
    if (shape != owner) entries.forbid(section, name, fmt::format("it belongs to Shape = {}, not to {}", owner, shape));
  };
  belongs("Radius", "parabola");
  belongs("Slope angle", "cone");
  belongs("Coefficient", "power");
  belongs("Exponent", "power");
  if (shape == "parabola") {
    indenter.shape = Case::Shape::parabola;
    indenter.radius = entries.number(section, "Radius", positive);
  } else if (shape == "cone") {
    indenter.shape = Case::Shape::cone;
    indenter.slope_angle = entries.number(
        section, "Slope angle", {[](double x) { return x > 0 && x < 90; }, "an angle between 0 and 90 degrees"});
  } else {
    indenter.shape = Case::Shape::power;
    indenter.coefficient = entries.number(section, "Coefficient", positive);
    indenter.exponent = entries.number(section, "Exponent",
                                       {[](double x) { return x >= 0.5 && x <= 20; }, "a number between 0.5 and 20"});
  }
  return indenter;
}

Case::Elastomer read_elastomer(const EntryReader& entries) {
  const std::string section = "Elastomer";
  Case::Elastomer elastomer;
  elastomer.rheology = entries.one_of(section, "Rheology", {"elastic", "kelvin voigt", "standard solid", "prony"});
  const ValidNumber relaxed{
      [](double x) { return x > 0; },
      "a positive modulus in Pa: a body that relaxes to nothing (Maxwell) has no permanent stick"};
  elastomer.relaxed_modulus = entries.number(section, "Relaxed shear modulus", relaxed);
  const bool has_branches = elastomer.rheology == "standard solid" || elastomer.rheology == "prony";
  const bool has_dashpot = elastomer.rheology == "kelvin voigt" || elastomer.rheology == "prony";
  for (const char* name : {"Branch moduli", "Branch times"})
    if (!has_branches) entries.forbid(section, name, "a body of Rheology = " + elastomer.rheology + " has no branches");
  if (!has_dashpot) entries.forbid(section, "Viscosity", "a body of Rheology = " + elastomer.rheology + " has none");
  if (has_branches) {
    elastomer.branch_moduli = entries.numbers(section, "Branch moduli", positive);
    elastomer.branch_times = entries.numbers(section, "Branch times", positive);
    const auto n = elastomer.branch_moduli.size();
    if (elastomer.rheology == "standard solid" && n != 1)
      entries.fail(section, "Branch moduli", "one modulus; use Rheology = prony for several branches");
    if (elastomer.branch_times.size() != n)
      entries.fail(section, "Branch times", fmt::format("{} times, one for each of the Branch moduli", n));
  }
  if (elastomer.rheology == "kelvin voigt" || entries.given(section, "Viscosity"))
    elastomer.viscosity = entries.number(section, "Viscosity", positive);
  return elastomer;
}

Case::Motion read_motion(const EntryReader& entries) {
  const std::string section = "Motion";
  Case::Motion motion;
  motion.indentation = entries.number(section, "Indentation", positive);
  motion.normal_amplitude = entries.number(section, "Normal amplitude", not_negative);
  motion.tangential_amplitude = entries.text(section, "Tangential amplitude") == "shakedown"
                                    ? std::nan("")
                                    : entries.number(section, "Tangential amplitude", not_negative);
  motion.frequency = entries.number(section, "Normal frequency", positive);
  if (entries.number(section, "Tangential frequency", positive) != motion.frequency)
    entries.fail(
        section, "Tangential frequency",
        fmt::format("the Normal frequency, {:g} Hz: unequal frequencies are not compared yet; use Phase = free for "
                    "motions that are not synchronised",
                    motion.frequency));
  if (entries.text(section, "Phase") != "free") motion.phase = entries.number(section, "Phase", any_number);
  return motion;
}

}  // namespace

const ValidNumber any_number{[](double) { return true; }, "a finite number"};

void declare_entries(dealii::ParameterHandler& handler) {
  for (const auto& section : sections()) {
    handler.enter_subsection(section.name);
    for (const char* entry : section.entries) handler.declare_entry(entry, "");
    handler.leave_subsection();
  }
}

bool is_entry(const std::string& section, const std::string& name) {
  for (const auto& s : sections())
    if (s.name == section) return std::find(s.entries.begin(), s.entries.end(), name) != s.entries.end();
  return false;
}

std::string valid_entries() {
  std::string list;
  for (const auto& section : sections())
    list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", section.name, fmt::join(section.entries, ", "));
  return list;
}

std::string EntryReader::text(const std::string& section, const std::string& name) const {
  handler_.enter_subsection(section);
  std::string value = handler_.get(name);
  handler_.leave_subsection();
  return value;
}

bool EntryReader::given(const std::string& section, const std::string& name) const {
  return !text(section, name).empty();
}

void EntryReader::fail(const std::string& section, const std::string& name, const std::string& valid) const {
  const std::string value = text(section, name);
  if (value.empty()) throw InputError(fmt::format("{}: {} / {} is missing; expected {}", file_, section, name, valid));
  throw InputError(fmt::format("{}: {} / {} = {}: expected {}", file_, section, name, value, valid));
}

void EntryReader::forbid(const std::string& section, const std::string& name, const std::string& reason) const {
  if (given(section, name))
    throw InputError(
        fmt::format("{}: {} / {} = {} has no meaning here: {}", file_, section, name, text(section, name), reason));
}

std::string EntryReader::one_of(const std::string& section, const std::string& name,
                                const std::vector<std::string>& choices) const {
  const std::string value = text(section, name);
  if (std::find(choices.begin(), choices.end(), value) == choices.end())
    fail(section, name, fmt::format("one of {}", fmt::join(choices, ", ")));
  return value;
}

double EntryReader::number(const std::string& section, const std::string& name, const ValidNumber& valid) const {
  bool ok = false;
  const double value = parse_number(text(section, name), ok);
  if (!ok || !valid.accepts(value)) fail(section, name, valid.description);
  return value;
}

std::vector<double> EntryReader::numbers(const std::string& section, const std::string& name,
                                         const ValidNumber& valid) const {
  std::vector<double> values;
  std::string rest = text(section, name);
  if (rest.empty()) fail(section, name, fmt::format("a list, each {}", valid.description));
  while (!rest.empty()) {
    const auto comma = rest.find(',');
    bool ok = false;
    values.push_back(parse_number(trimmed(rest.substr(0, comma)), ok));
    if (!ok || !valid.accepts(values.back()))
      fail(section, name, fmt::format("a list separated by commas, each {}", valid.description));
    if (comma == std::string::npos) break;
    rest = rest.substr(comma + 1);
    if (trimmed(rest).empty()) fail(section, name, "a number after the last comma");
  }
  return values;
}

Case read_entries(const EntryReader& entries, Case::Fields fields) {
  Case scene;
  scene.file = entries.file();
  scene.indenter = read_indenter(entries);
  scene.elastomer = read_elastomer(entries);
  scene.friction_coefficient = entries.number("Friction", "Coefficient", positive);
  static_cast<void>(entries.one_of("Friction", "Law", {"unidirectional"}));
  scene.motion = read_motion(entries);
  if (entries.given("Wear", "State") && entries.one_of("Wear", "State", {"unworn", "limiting"}) == "limiting") {
    scene.wear = Case::Wear::limiting;
    scene.worn_stick_ratio = entries.number(
        "Wear", "Stick radius ratio",
        {[](double x) { return x >= 0.01 && x <= 0.99; }, "a ratio of stick to unworn contact radius, 0.01 to 0.99"});
  } else {
    entries.forbid("Wear", "Stick radius ratio", "it belongs to State = limiting");
    if (std::isnan(scene.motion.tangential_amplitude))
      entries.fail("Motion", "Tangential amplitude",
                   "a number in m; the word shakedown belongs to Wear / State = limiting");
  }
  scene.tolerance = entries.number("Accuracy", "Tolerance",
                                   {[](double x) { return x >= 1e-5 && x <= 0.1; }, "a number between 1e-5 and 0.1"});
  if (entries.given("Accuracy", "Rings per radius"))
    scene.rings_per_radius = static_cast<unsigned>(entries.number("Accuracy", "Rings per radius", ring_count));
  if (entries.given("Accuracy", "Steps per cycle"))
    scene.steps_per_cycle = static_cast<int>(entries.number("Accuracy", "Steps per cycle", step_count));
  scene.fields = fields;
  if (entries.given("Output", "Fields"))
    scene.fields = entries.one_of("Output", "Fields", {"none", "extremes"}) == "none" ? Case::Fields::none
                                                                                      : Case::Fields::extremes;
  return scene;
}

}  // namespace fretval
