#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "comparison/case/test_duration.h"
#include "comparison/case_file/case_sections.h"
#include "comparison/case_file/entry_table.h"
#include "comparison/data/table_units.h"
#include "mdr/support/csv_units.h"

namespace fretval {
namespace {

/// All of the course of wear.
std::vector<std::string> names_of_wear_kinetics() {
  return names_but("Wear", {"State", "Stick radius ratio"});
}

std::optional<Case::WearKinetics> read_wear_kinetics(const EntryReader& entries, std::vector<std::string>& notes) {
  const auto names = names_of_wear_kinetics();
  if (std::none_of(names.begin(), names.end(), [&](const auto& name) { return entries.given("Wear", name); }))
    return {};
  Case::WearKinetics wear;
  wear.coefficient = entries.number("Wear", "Coefficient");
  if (entries.given("Wear", "Law")) wear.law = entries.kind<Case::WearLaw>("Wear", "Law").value_or(wear.law);
  if (wear.law == Case::WearLaw::power)
    wear.exponent = entries.number("Wear", "Exponent");
  else
    entries.forbid("Wear", "Exponent", "it belongs to Law = power");
  if (entries.given("Wear", "Cycles")) wear.n_cycles = entries.number("Wear", "Cycles");
  if (entries.given("Wear", "Until")) wear.until = entries.number("Wear", "Until");
  if (entries.given("Wear", "Worn rings")) {
    wear.rings = read_table_path(entries, "Wear", "Worn rings", notes);
    entries.forbid("Wear", "Profile", "Worn rings say what the indenter has lost before");
  } else if (entries.given("Wear", "Profile")) {
    wear.profile = read_table_path(entries, "Wear", "Profile", notes);
  }
  return wear;
}

/// The course of wear along a path, which has to be one of displacements that repeats.
void read_wear_along_path(const EntryReader& entries, Case& input) {
  const auto& path = *input.motion.path;
  if (path.repeats && !path.normal_force && !path.tangential_force)
    input.wear_kinetics = read_wear_kinetics(entries, input.notes);
  else
    entries.forbid_all("Wear", names_of_wear_kinetics(),
                       "wear needs a Motion / Path of displacements that repeats forever");
}

void read_wear(const EntryReader& entries, Case& input) {
  if (input.contact.is_full() || input.motion.path) {
    entries.forbid_all(
        "Wear", {"State", "Stick radius ratio"},
        input.contact.is_full()
            ? "under Contact / Friction = vector the profile that a motion is limiting for is found by wear"
            : "the profile that a Motion / Path is limiting for is found by wear");
    if (input.motion.path) return read_wear_along_path(entries, input);
    input.wear_kinetics = read_wear_kinetics(entries, input.notes);
    return;
  }
  if (entries.says("Wear", "State", "limiting")) {
    input.wear = Case::Wear::limiting;
    if (input.motion.normal_force || input.motion.tangential_force)
      entries.forbid("Wear", "Stick radius ratio", "under a prescribed force it follows from the motion");
    else
      input.worn_stick_ratio = entries.number("Wear", "Stick radius ratio");
    entries.forbid_all("Wear", names_of_wear_kinetics(), "the limiting profile wears no more");
    entries.forbid_all(
        "Motion", {"Normal harmonics", "Tangential harmonics", "Normal force harmonics", "Tangential force harmonics"},
        "Wear / State = limiting prescribes the stick radius of one oscillation");
    return;
  }
  entries.forbid("Wear", "Stick radius ratio", "it belongs to State = limiting");
  if (entries.text("Motion", "Tangential amplitude") == "shakedown")
    entries.fail("Motion", "Tangential amplitude",
                 "a number in m; the word shakedown belongs to Wear / State = limiting");
  input.wear_kinetics = read_wear_kinetics(entries, input.notes);
}

const char* const measured_section = "Measured";

void read_loops(const std::string& file, Case::Measured& measured, std::vector<std::string>& notes) {
  input_from(file, [&] {
    std::ifstream stream(file);
    std::vector<mdr::WantedColumn> wanted;
    for (const auto& kind : rig_columns()) wanted.push_back({{kind}, true});
    auto chosen = mdr::read_columns(stream, file, wanted, mdr::InOrder::no);
    auto& csv = chosen.csv;
    for (std::size_t k = 0; k < csv.columns.size(); ++k)
      if (chosen.kind[k] && !mdr::names_unit(csv, k))
        throw InputError(
            fmt::format("{}: column {} has no unit; must have one, for example \"F_x [N]\"", file, csv.names[k]));
    take_into_si(file, wanted, chosen);
    if (!chosen.kind[3] && !chosen.kind[4])
      throw InputError(
          fmt::format("{}: has neither a column F_N nor a column F_x with a unit; must have one of them", file));
    if (!chosen.kind[0] && !chosen.kind[1] && !chosen.kind[2])
      throw InputError(
          fmt::format("{}: has neither t nor d nor u_x with a unit, over which the forces would be drawn", file));
    if (auto skipped = skipped_text(file, chosen); !skipped.empty()) notes.push_back(std::move(skipped));
    measured.loop = file;
    measured.time = std::move(csv.columns[0]);
    measured.indentation = std::move(csv.columns[1]);
    measured.tangential_displacement = std::move(csv.columns[2]);
    measured.normal_force = std::move(csv.columns[3]);
    measured.tangential_force = std::move(csv.columns[4]);
  });
}

std::optional<Case::Measured::Value> read_value(const EntryReader& entries, const std::string& name) {
  const auto uncertainty = name + " uncertainty";
  if (!entries.given(measured_section, name)) {
    entries.forbid(measured_section, uncertainty, "it belongs to a " + name);
    return std::nullopt;
  }
  return Case::Measured::Value{entries.number(measured_section, name), entries.number(measured_section, uncertainty)};
}

}  // namespace

Case read_entries(const EntryReader& entries, Accuracy accuracy) {
  Case input;
  input.file = entries.file();
  input.indenter = read_indenter(entries, input.notes);
  input.elastomer = read_elastomer(entries, input.warnings, input.notes);
  input.friction_coefficient = entries.number("Friction", "Coefficient");
  input.motion = read_motion(entries, input.notes);
  input.contact = read_contact(entries, input.motion);
  input.body = read_body(entries, input.motion.moves_tangentially());
  read_wear(entries, input);
  if (accuracy == Accuracy::needed || entries.given("Accuracy", "Tolerance"))
    input.tolerance = entries.number("Accuracy", "Tolerance");
  if (entries.given("Accuracy", "Cycle tolerance"))
    input.cycle_tolerance = entries.number("Accuracy", "Cycle tolerance");
  if (input.body.shape == Case::Body::Shape::mesh)
    entries.forbid("Accuracy", "Rings per radius", "rings are the edges of the Body / Mesh on its curve contact");
  else if (entries.given("Accuracy", "Rings per radius"))
    input.rings_per_radius = entries.whole("Accuracy", "Rings per radius");
  if (entries.given("Accuracy", "Steps per cycle"))
    input.steps_per_cycle = static_cast<int>(entries.whole("Accuracy", "Steps per cycle"));
  if (entries.given("Output", "Fields")) input.fields = entries.kind<Case::Fields>("Output", "Fields");
  input.measured = read_measured(entries, input.notes);
  entries.throw_problems();
  if (entries.given("Elastomer", "Duration of the test")) {
    const double seconds = entries.number("Elastomer", "Duration of the test");
    entries.throw_problems();
    limit_to_test(seconds, input);
  }
  return input;
}

std::optional<Case::Measured> read_measured(const EntryReader& entries, std::vector<std::string>& notes) {
  Case::Measured measured;
  measured.stick_radius = read_value(entries, "Stick radius");
  measured.contact_radius = read_value(entries, "Contact radius");
  if (entries.given(measured_section, "Loops")) {
    const auto file = entries.path(measured_section, "Loops");
    try {
      if (!file.empty()) read_loops(file, measured, notes);
    } catch (const InputError& error) {
      entries.add_problem(error.what());
    }
  }
  if (!measured.stick_radius && !measured.contact_radius && measured.loop.empty()) return std::nullopt;
  return measured;
}

}  // namespace fretval
