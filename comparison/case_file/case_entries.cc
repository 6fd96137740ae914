#include "comparison/case_file/case_entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/case/test_duration.h"
#include "comparison/case_file/case_sections.h"
#include "comparison/case_file/entry_table.h"
#include "comparison/case_file/measured.h"

namespace fretval {
namespace {

bool is_whole(double x, double least, double most) {
  return x == std::floor(x) && x >= least && x <= most;
}
// The error budget halves them, and fewer than 8 tell nothing.
const ValidNumber ring_count{[](double x) { return is_whole(x, 16, 640); }, "a whole number from 16 to 640"};
const ValidNumber step_count{[](double x) { return is_whole(x, 16, 10000); }, "a whole number from 16 to 10000"};
const ValidNumber relative_tolerance{[](double x) { return x >= 1e-5 && x <= 0.1; }, "a number between 1e-5 and 0.1"};

constexpr std::array wear_kinetics_names{"Law", "Coefficient", "Exponent", "Cycles", "Until", "Profile", "Worn rings"};

std::optional<Case::WearKinetics> read_wear_kinetics(const EntryReader& entries, std::vector<std::string>& notes) {
  const auto& names = wear_kinetics_names;
  if (std::none_of(names.begin(), names.end(), [&](const char* name) { return entries.given("Wear", name); }))
    return {};
  Case::WearKinetics wear;
  wear.coefficient = entries.number("Wear", "Coefficient", not_negative_number);
  if (entries.given("Wear", "Law")) {
    const auto& laws = Case::wear_law_names;
    const auto name = entries.one_of("Wear", "Law", {laws.begin(), laws.end()});
    if (!name.empty()) wear.law = static_cast<Case::WearLaw>(std::find(laws.begin(), laws.end(), name) - laws.begin());
  }
  if (wear.law == Case::WearLaw::power)
    wear.exponent = entries.number(
        "Wear", "Exponent", {[](double x) { return x >= 0.25 && x <= 4; }, "an exponent of the pressure, 0.25 to 4"});
  else
    entries.forbid("Wear", "Exponent", "it belongs to Law = power");
  if (entries.given("Wear", "Cycles")) wear.n_cycles = entries.number("Wear", "Cycles", not_negative_number);
  if (entries.given("Wear", "Until"))
    wear.until = entries.number(
        "Wear", "Until", {[](double x) { return x >= 1e-12 && x < 1; }, "a share of the first wear rate, 1e-12 to 1"});
  if (entries.given("Wear", "Worn rings")) {
    wear.rings = read_table_path(entries, "Wear", "Worn rings", notes);
    entries.forbid("Wear", "Profile", "Worn rings say what the indenter has lost before");
  } else if (entries.given("Wear", "Profile")) {
    wear.profile = read_table_path(entries, "Wear", "Profile", notes);
  }
  return wear;
}

/// Under friction as a vector: from the unworn indenter on, by prescribed displacements that repeat.
void read_wear_in_the_plane(const EntryReader& entries, Case& input) {
  for (const char* name : {"State", "Stick radius ratio", "Profile", "Worn rings"})
    entries.forbid("Wear", name, "under Contact / Friction = vector wear begins with the indenter as it is described");
  const auto& motion = input.motion;
  const bool repeats = motion.path ? motion.path->repeats : true;
  const bool by_force = motion.path ? motion.path->normal_force || motion.path->tangential_force
                                    : motion.normal_force || motion.tangential_force;
  for (const char* name : wear_kinetics_names)
    if (!repeats || by_force)
      entries.forbid("Wear", name,
                     "under Contact / Friction = vector wear needs prescribed displacements that repeat forever");
  if (repeats && !by_force) input.wear_kinetics = read_wear_kinetics(entries, input.notes);
}

void read_wear(const EntryReader& entries, Case& input) {
  if (input.contact.is_full()) return read_wear_in_the_plane(entries, input);
  if (const auto& path = input.motion.path) {
    for (const char* name : {"State", "Stick radius ratio"})
      entries.forbid("Wear", name, "the profile that a Motion / Path is limiting for is found by wear");
    const bool wears_by_it = path->repeats && !path->normal_force && !path->tangential_force;
    for (const char* name : wear_kinetics_names)
      if (!wears_by_it)
        entries.forbid("Wear", name, "wear needs a Motion / Path of displacements that repeats forever");
    if (wears_by_it) input.wear_kinetics = read_wear_kinetics(entries, input.notes);
    return;
  }
  if (entries.given("Wear", "State") && entries.one_of("Wear", "State", {"unworn", "limiting"}) == "limiting") {
    input.wear = Case::Wear::limiting;
    if (input.motion.normal_force || input.motion.tangential_force)
      entries.forbid("Wear", "Stick radius ratio", "under a prescribed force it follows from the motion");
    else
      input.worn_stick_ratio = entries.number(
          "Wear", "Stick radius ratio",
          {[](double x) { return x >= 0.01 && x <= 0.99; }, "a ratio of stick to unworn contact radius, 0.01 to 0.99"});
    for (const char* name : wear_kinetics_names) entries.forbid("Wear", name, "the limiting profile wears no more");
    for (const char* name :
         {"Normal harmonics", "Tangential harmonics", "Normal force harmonics", "Tangential force harmonics"})
      entries.forbid("Motion", name, "Wear / State = limiting prescribes the stick radius of one oscillation");
    return;
  }
  entries.forbid("Wear", "Stick radius ratio", "it belongs to State = limiting");
  if (entries.text("Motion", "Tangential amplitude") == "shakedown")
    entries.fail("Motion", "Tangential amplitude",
                 "a number in m; the word shakedown belongs to Wear / State = limiting");
  input.wear_kinetics = read_wear_kinetics(entries, input.notes);
}

bool moves_tangentially(const Case::Motion& motion) {
  const auto moves = [](const Case::Harmonic& harmonic) { return harmonic.amplitude > 0; };
  return motion.moves_across() || motion.tangential_amplitude != 0 || motion.tangential_force.value_or(0) > 0 ||
         std::any_of(motion.tangential_harmonics.begin(), motion.tangential_harmonics.end(), moves);
}

Case::Fields fields_of(const std::string& word) {
  if (word == "none") return Case::Fields::none;
  return word == "cycle" ? Case::Fields::cycle : Case::Fields::extremes;
}

}  // namespace

Case read_entries(const EntryReader& entries, Accuracy accuracy) {
  Case input;
  input.file = entries.file();
  input.indenter = read_indenter(entries, input.notes);
  input.elastomer = read_elastomer(entries, input.warnings, input.notes);
  input.friction_coefficient = entries.number("Friction", "Coefficient", positive_number);
  input.motion = read_motion(entries, input.notes);
  input.contact = read_contact(entries, input.motion);
  input.body = read_body(entries, moves_tangentially(input.motion));
  read_wear(entries, input);
  if (accuracy == Accuracy::needed || entries.given("Accuracy", "Tolerance"))
    input.tolerance = entries.number("Accuracy", "Tolerance", relative_tolerance);
  if (entries.given("Accuracy", "Cycle tolerance"))
    input.cycle_tolerance = entries.number("Accuracy", "Cycle tolerance", relative_tolerance);
  if (input.body.shape == Case::Body::Shape::mesh)
    entries.forbid("Accuracy", "Rings per radius", "rings are the edges of the Body / Mesh on its curve contact");
  else if (entries.given("Accuracy", "Rings per radius"))
    input.rings_per_radius = entries.whole("Accuracy", "Rings per radius", ring_count);
  if (entries.given("Accuracy", "Steps per cycle"))
    input.steps_per_cycle = static_cast<int>(entries.whole("Accuracy", "Steps per cycle", step_count));
  if (entries.given("Output", "Fields"))
    input.fields = fields_of(entries.one_of("Output", "Fields", {"none", "extremes", "cycle"}));
  input.measured = read_measured(entries, input.notes);
  entries.throw_problems();
  if (entries.given("Elastomer", "Duration of the test")) {
    const double seconds = entries.number("Elastomer", "Duration of the test", positive_number);
    entries.throw_problems();
    limit_to_test(seconds, input);
  }
  return input;
}

}  // namespace fretval
