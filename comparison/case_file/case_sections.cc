#include "comparison/case_file/case_sections.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "comparison/case/oscillations.h"
#include "comparison/data/aligned_trace.h"
#include "comparison/data/master_curve.h"
#include "comparison/data/path_table.h"
#include "comparison/data/table_units.h"
#include "comparison/support/constants.h"
#include "mdr/motion/commensurability.h"
#include "mdr/profiles/profile_csv.h"
#include "mdr/rheology/modulus_table.h"
#include "mdr/rheology/time_temperature.h"

namespace fretval {
namespace {

/// Relaxation times belong to the reference temperature; the case may be at another one.
void shift_to_temperature(const EntryReader& entries, Case::Elastomer& elastomer) {
  const std::string section = "Elastomer";
  if (!entries.given(section, "Temperature")) {
    entries.forbid_all(section, {"Reference temperature", "WLF C1", "WLF C2"}, "it belongs to a Temperature");
    return;
  }
  const double temperature = entries.number(section, "Temperature");
  const double reference = entries.number(section, "Reference temperature");
  const double c1 = entries.number(section, "WLF C1");
  const double c2 = entries.number(section, "WLF C2");
  if (std::isnan(temperature + reference + c1 + c2)) return;
  try {
    const double factor = mdr::wlf_shift(c1, c2, reference, temperature);
    for (double& time : elastomer.branch_times) time *= factor;
    elastomer.viscosity *= factor;
    elastomer.shift = Case::TemperatureShift{temperature, reference, c1, c2};
    if (elastomer.master_curve)
      for (double& frequency : elastomer.master_curve->frequency) frequency /= factor;
  } catch (const std::invalid_argument& error) {
    entries.add_problem(fmt::format("{}: {} / Temperature: {}", entries.file(), section, error.what()));
  }
}

/// Those that move something: one of amplitude 0 would ask for steps of its frequency.
std::vector<Case::Harmonic> read_harmonics(const EntryReader& entries, const std::string& name) {
  std::vector<Case::Harmonic> harmonics;
  if (!entries.given("Motion", name)) return harmonics;
  const auto values = entries.numbers("Motion", name);
  const auto valid =
      fmt::format("triples of amplitude in {} (not negative), frequency in Hz (positive) and phase in deg",
                  name.find("force") == std::string::npos ? "m" : "N");
  if (values.size() % 3 != 0) entries.fail("Motion", name, valid);
  for (std::size_t k = 0; k + 2 < values.size(); k += 3) {
    const Case::Harmonic one{values[k], values[k + 1], values[k + 2]};
    if (!(one.amplitude >= 0 && one.frequency > 0)) entries.fail("Motion", name, valid);
    if (one.amplitude > 0) harmonics.push_back(one);
  }
  return harmonics;
}

void read_normal_motion(const EntryReader& entries, Case::Motion& motion) {
  const std::string section = "Motion";
  if (entries.given(section, "Normal force")) {
    entries.forbid_all(section, {"Indentation", "Normal amplitude", "Normal harmonics"},
                       "the Normal force is prescribed");
    motion.normal_force =
        Case::NormalForce{entries.number(section, "Normal force"), entries.number(section, "Normal force amplitude")};
    motion.normal_harmonics = read_harmonics(entries, "Normal force harmonics");
    return;
  }
  entries.forbid_all(section, {"Normal force amplitude", "Normal force harmonics"}, "it belongs to a Normal force");
  motion.normal_harmonics = read_harmonics(entries, "Normal harmonics");
  motion.indentation = entries.number(section, "Indentation");
  motion.normal_amplitude = entries.number(section, "Normal amplitude");
}

void read_tangential_motion(const EntryReader& entries, Case::Motion& motion) {
  const std::string section = "Motion";
  if (entries.given(section, "Tangential force amplitude")) {
    entries.forbid_all(section, {"Tangential amplitude", "Tangential harmonics"},
                       "the Tangential force amplitude is prescribed");
    motion.tangential_force = entries.number(section, "Tangential force amplitude");
    motion.tangential_harmonics = read_harmonics(entries, "Tangential force harmonics");
    return;
  }
  entries.forbid(section, "Tangential force harmonics", "it belongs to a Tangential force amplitude");
  motion.tangential_harmonics = read_harmonics(entries, "Tangential harmonics");
  motion.tangential_amplitude = entries.text(section, "Tangential amplitude") == "shakedown"
                                    ? std::nan("")
                                    : entries.number(section, "Tangential amplitude");
}

/// In two directions MDR steps a period of the motion.
void require_repetition(const EntryReader& entries, const Case::Motion& motion) {
  const auto frequencies = moving_frequencies(motion);
  const bool are_valid = std::all_of(frequencies.begin(), frequencies.end(), [](double f) { return f > 0; });
  if (!are_valid || mdr::commensurate_groups(frequencies).size() < 2) return;
  entries.fail("Motion", "Tangential frequency",
               fmt::format("a motion in two directions that repeats: frequencies in ratios of whole numbers, to twelve "
                           "digits, instead of {:.12g} Hz",
                           fmt::join(frequencies, ", ")));
}

/// The transverse motion: a displacement, or a force where the tangential motion is prescribed by one.
void read_transverse_motion(const EntryReader& entries, Case::Motion& motion) {
  const std::string section = "Motion";
  const bool by_force = motion.tangential_force.has_value();
  const char *amplitude = by_force ? "Transverse force amplitude" : "Transverse amplitude",
             *harmonics = by_force ? "Transverse force harmonics" : "Transverse harmonics";
  if (by_force)
    entries.forbid_all(section, {"Transverse amplitude", "Transverse harmonics"},
                       "beside a Tangential force amplitude it is a Transverse force amplitude");
  else
    entries.forbid_all(section, {"Transverse force amplitude", "Transverse force harmonics"},
                       "it belongs to a Tangential force amplitude");
  if (!entries.given(section, amplitude)) {
    entries.forbid_all(section, {"Transverse frequency", "Transverse phase", harmonics},
                       fmt::format("it belongs to a {}", amplitude));
    return;
  }
  const bool has_frequency = entries.given(section, "Transverse frequency");
  Case::Harmonic first;
  first.amplitude = entries.number(section, amplitude);
  first.frequency = has_frequency ? entries.number(section, "Transverse frequency") : motion.tangential_frequency;
  first.phase = entries.number(section, "Transverse phase");
  motion.transverse = {first};
  for (const auto& harmonic : read_harmonics(entries, harmonics)) motion.transverse.push_back(harmonic);
  if (!motion.phase)
    entries.fail(section, "Phase", "an angle in deg: in two directions the motion is computed with a fixed phase");
  require_repetition(entries, motion);
}

/// The tolerance of a path: given, relative or with a unit, or a share of the tolerance of the case.
PathTolerance read_path_tolerance(const EntryReader& entries) {
  const std::string section = "Motion", name = "Path tolerance";
  PathTolerance tolerance;
  if (!entries.given(section, name)) {
    constexpr double share = 0.125;
    if (const auto of_case = read_measure(entries.text("Accuracy", "Tolerance"), Dimension::number))
      tolerance.relative = share * std::max(of_case->value, 0.0);
    return tolerance;
  }
  tolerance.is_given = true;
  const auto text = entries.text(section, name);
  const auto plain = read_measure(text, Dimension::number), length = read_measure(text, Dimension::length),
             force = read_measure(text, Dimension::force);
  if (plain && plain->value > 0 && plain->value < 1)
    tolerance.relative = plain->value;
  else if (length && length->has_unit && length->value > 0)
    tolerance.length = length->value;
  else if (force && force->has_unit && force->value > 0)
    tolerance.force = force->value;
  else
    entries.fail(section, name,
                 "a share of the largest values, above 0 and below 1, or a positive length or force with its unit");
  return tolerance;
}

/// A path stands in the place of all other entries of the section.
Case::Motion read_path_motion(const EntryReader& entries, std::vector<std::string>& notes) {
  const std::string section = "Motion";
  entries.forbid_all(section, names_but(section, {"Path", "Path repeats", "Path tolerance"}), "the Path is the motion");
  const bool repeats = entries.word(section, "Path repeats") == "forever";
  const auto file = entries.path(section, "Path");
  if (file.empty()) return {};
  try {
    return motion_along(read_path_table(file, repeats, read_path_tolerance(entries), notes));
  } catch (const InputError& error) {
    entries.add_problem(error.what());
    return {};
  }
}

/// A raw trace of a profilometer.
void align_table(const EntryReader& entries, Case::Indenter& indenter, std::vector<std::string>& notes) {
  try {
    indenter.trace = read_aligned_trace(indenter.table, indenter.table_noise);
    const auto& trace = *indenter.trace;
    notes.push_back(fmt::format(
        "{}: aligned: apex at {:.6g} ± {:.2g} m, tilt {:.4g} ± {:.2g} deg, heights {}, noise {:.2g} m", indenter.table,
        trace.apex, trace.apex_uncertainty, std::atan(trace.tilt) * degrees_per_radian,
        trace.tilt_uncertainty * degrees_per_radian, trace.heights_upwards ? "upwards" : "downwards", trace.noise));
  } catch (const InputError& error) {
    entries.add_problem(error.what());
  }
}

}  // namespace

std::string read_table_path(const EntryReader& entries, const std::string& section, const std::string& name,
                            std::vector<std::string>& notes) {
  auto file = entries.path(section, name);
  try {
    if (file.empty()) return file;
    if (auto skipped = require_units(file, mdr::profile_columns()); !skipped.empty())
      notes.push_back(std::move(skipped));
  } catch (const InputError& error) {
    entries.add_problem(error.what());
  }
  return file;
}

Case::Indenter read_indenter(const EntryReader& entries, std::vector<std::string>& notes) {
  const std::string section = "Indenter";
  const auto shape = entries.kind<Case::Shape>(section, "Shape");
  if (!shape) return {};
  Case::Indenter indenter;
  indenter.shape = *shape;
  entries.read_fields(section, entries.text(section, "Shape"), indenter);
  if (shape == Case::Shape::table) {
    indenter.table = read_table_path(entries, section, "Table", notes);
    if (entries.says(section, "Table alignment", "fit") && !indenter.table.empty())
      align_table(entries, indenter, notes);
  }
  return indenter;
}

Case::Elastomer read_elastomer(const EntryReader& entries, std::vector<std::string>& warnings,
                               std::vector<std::string>& notes) {
  const std::string section = "Elastomer";
  Case::Elastomer elastomer;
  const auto rheology = entries.kind<Case::Rheology>(section, "Rheology");
  if (!rheology) return elastomer;
  elastomer.rheology = *rheology;
  entries.read_fields(section, elastomer.rheology_name(), elastomer);
  if (rheology == Case::Rheology::prony && !entries.given(section, "Branches"))
    entries.forbid(section, "Table modulus", "it belongs to a Table or a file of Branches");
  if (rheology == Case::Rheology::table) {
    const bool youngs = entries.word(section, "Table modulus") == "Young";
    const auto table = entries.path(section, "Table");
    try {
      if (!table.empty()) {
        if (auto skipped = require_units(table, mdr::modulus_columns()); !skipped.empty())
          notes.push_back(std::move(skipped));
        fit_master_curve(table, youngs, elastomer, warnings);
      }
    } catch (const InputError& error) {
      entries.add_problem(error.what());
    }
  } else {
    read_relaxed_modulus(entries, elastomer, notes);
  }
  if (find_entry(section, "Branch times")->belongs_to(elastomer.rheology_name()))
    read_branches(entries, elastomer, notes);
  if (rheology == Case::Rheology::kelvin_voigt || entries.given(section, "Viscosity"))
    elastomer.viscosity = entries.number(section, "Viscosity");
  shift_to_temperature(entries, elastomer);
  return elastomer;
}

Case::Body read_body(const EntryReader& entries, bool tangential) {
  const std::string section = "Body";
  Case::Body body;
  if (entries.given(section, "Shape")) {
    const auto shape = entries.kind<Case::Body::Shape>(section, "Shape");
    if (!shape) return {};
    body.shape = *shape;
  }
  entries.read_fields(section, Case::Body::shape_names[static_cast<std::size_t>(body.shape)], body);
  if (body.is_half_space()) return body;
  if (body.shape == Case::Body::Shape::mesh) read_mesh_entries(entries, body);
  // A base that is missing has been reported already.
  body.is_bonded = entries.word(section, "Base") != "frictionless";
  if (!body.is_bonded && tangential)
    entries.fail(section, "Base",
                 "bonded: nothing but a base to which it is bonded holds the body against the tangential motion");
  if (!body.is_bonded && body.grid && !has_level_base(*body.grid))
    entries.fail(section, "Base",
                 fmt::format("bonded: the base of {} is not level, on which it could slide", body.mesh));
  return body;
}

Case::Motion read_motion(const EntryReader& entries, std::vector<std::string>& notes) {
  const std::string section = "Motion";
  Case::Motion motion;
  if (entries.given(section, "Path")) return read_path_motion(entries, notes);
  entries.forbid_all(section, {"Path repeats", "Path tolerance"}, "it belongs to a Path");
  read_normal_motion(entries, motion);
  read_tangential_motion(entries, motion);
  motion.normal_frequency = entries.number(section, "Normal frequency");
  motion.tangential_frequency = entries.number(section, "Tangential frequency");
  if (entries.text(section, "Phase") != "free") motion.phase = entries.number(section, "Phase");
  read_transverse_motion(entries, motion);
  return motion;
}

Case::Contact read_contact(const EntryReader& entries, const Case::Motion& motion) {
  Case::Contact contact;
  const bool by_law = entries.says("Friction", "Law", "vector"),
             by_contact = entries.says("Contact", "Friction", "vector");
  contact.vector_friction = by_contact || by_law;
  if (by_law && entries.given("Contact", "Friction") && !by_contact)
    entries.fail("Contact", "Friction", "vector, or no Friction / Law = vector beside it");
  contact.coupled = entries.says("Contact", "Coupling", "on");
  contact.second_algorithm = entries.says("Contact", "Second algorithm", "on");
  if (contact.second_algorithm && !contact.vector_friction)
    entries.fail("Contact", "Second algorithm", "off, or Contact / Friction = vector: it is one for that contact");
  if (contact.coupled && !contact.vector_friction)
    entries.fail("Contact", "Coupling",
                 "off, or Contact / Friction = vector: coupled, tractions have radial parts of any direction");
  if (contact.vector_friction && !motion.path && !motion.phase)
    entries.fail("Motion", "Phase", "an angle in deg: with friction as a vector the phase is fixed");
  if (motion.moves_across() && !contact.vector_friction)
    entries.fail("Contact", "Friction", "vector: the motion goes in two directions");
  return contact;
}

}  // namespace fretval
