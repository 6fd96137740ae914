#include "comparison/case_file/case_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/case_file/elastomer_moduli.h"
#include "comparison/case_file/mesh_entries.h"
#include "comparison/data/aligned_trace.h"
#include "comparison/data/master_curve.h"
#include "comparison/data/path_table.h"
#include "comparison/data/table_units.h"
#include "comparison/support/constants.h"
#include "mdr/profiles/profile_csv.h"
#include "mdr/rheology/modulus_table.h"
#include "mdr/rheology/time_temperature.h"

namespace fretval {
namespace {

const double degrees = 180 / pi;

struct Owner {
  const char* entry;
  std::vector<std::string> choices;  // of the entry that decides
};

/// Forbids the entries of a section that belong to other choices of one of its entries.
void forbid_others(const EntryReader& entries, const std::string& section, const std::string& deciding,
                   const std::string& choice, const std::vector<Owner>& owners) {
  for (const auto& [entry, choices] : owners)
    if (std::find(choices.begin(), choices.end(), choice) == choices.end())
      entries.forbid(section, entry,
                     fmt::format("it belongs to {} = {}, not to {}", deciding, fmt::join(choices, " or "), choice));
}

/// Relaxation times belong to the reference temperature; the case may be at another one.
void shift_to_temperature(const EntryReader& entries, Case::Elastomer& elastomer) {
  const std::string section = "Elastomer";
  if (!entries.given(section, "Temperature")) {
    for (const char* name : {"Reference temperature", "WLF C1", "WLF C2"})
      entries.forbid(section, name, "it belongs to a Temperature");
    return;
  }
  const double temperature = entries.number(section, "Temperature", any_number);
  const double reference = entries.number(section, "Reference temperature", any_number);
  const double c1 = entries.number(section, "WLF C1", positive_number);
  const double c2 = entries.number(section, "WLF C2", positive_number);
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

std::vector<Case::Harmonic> read_harmonics(const EntryReader& entries, const std::string& name) {
  std::vector<Case::Harmonic> harmonics;
  if (!entries.given("Motion", name)) return harmonics;
  const auto values = entries.numbers("Motion", name, any_number);
  const auto valid =
      fmt::format("triples of amplitude in {} (not negative), frequency in Hz (positive) and phase in deg",
                  name.find("force") == std::string::npos ? "m" : "N");
  if (values.size() % 3 != 0) entries.fail("Motion", name, valid);
  for (std::size_t k = 0; k + 2 < values.size(); k += 3) {
    harmonics.push_back({values[k], values[k + 1], values[k + 2]});
    if (!(harmonics.back().amplitude >= 0 && harmonics.back().frequency > 0)) entries.fail("Motion", name, valid);
  }
  return harmonics;
}

void read_normal_motion(const EntryReader& entries, Case::Motion& motion) {
  const std::string section = "Motion";
  if (entries.given(section, "Normal force")) {
    for (const char* name : {"Indentation", "Normal amplitude", "Normal harmonics"})
      entries.forbid(section, name, "the Normal force is prescribed");
    motion.normal_force = Case::NormalForce{entries.number(section, "Normal force", positive_number),
                                            entries.number(section, "Normal force amplitude", not_negative_number)};
    motion.normal_harmonics = read_harmonics(entries, "Normal force harmonics");
    return;
  }
  for (const char* name : {"Normal force amplitude", "Normal force harmonics"})
    entries.forbid(section, name, "it belongs to a Normal force");
  motion.normal_harmonics = read_harmonics(entries, "Normal harmonics");
  motion.indentation = entries.number(section, "Indentation", positive_number);
  motion.normal_amplitude = entries.number(section, "Normal amplitude", not_negative_number);
}

void read_tangential_motion(const EntryReader& entries, Case::Motion& motion) {
  const std::string section = "Motion";
  if (entries.given(section, "Tangential force amplitude")) {
    for (const char* name : {"Tangential amplitude", "Tangential harmonics"})
      entries.forbid(section, name, "the Tangential force amplitude is prescribed");
    motion.tangential_force = entries.number(section, "Tangential force amplitude", not_negative_number);
    motion.tangential_harmonics = read_harmonics(entries, "Tangential force harmonics");
    return;
  }
  entries.forbid(section, "Tangential force harmonics", "it belongs to a Tangential force amplitude");
  motion.tangential_harmonics = read_harmonics(entries, "Tangential harmonics");
  motion.tangential_amplitude = entries.text(section, "Tangential amplitude") == "shakedown"
                                    ? std::nan("")
                                    : entries.number(section, "Tangential amplitude", not_negative_number);
}

/// Of displacements, or of forces where the tangential motion is prescribed by one.
void read_transverse_motion(const EntryReader& entries, Case::Motion& motion) {
  const std::string section = "Motion";
  const bool by_force = motion.tangential_force.has_value();
  const char *amplitude = by_force ? "Transverse force amplitude" : "Transverse amplitude",
             *harmonics = by_force ? "Transverse force harmonics" : "Transverse harmonics";
  for (const char* name : {"Transverse amplitude", "Transverse harmonics"})
    if (by_force)
      entries.forbid(section, name, "beside a Tangential force amplitude it is a Transverse force amplitude");
  for (const char* name : {"Transverse force amplitude", "Transverse force harmonics"})
    if (!by_force) entries.forbid(section, name, "it belongs to a Tangential force amplitude");
  if (!entries.given(section, amplitude)) {
    for (const char* name : {"Transverse frequency", "Transverse phase", harmonics})
      entries.forbid(section, name, fmt::format("it belongs to a {}", amplitude));
    return;
  }
  const bool has_frequency = entries.given(section, "Transverse frequency");
  Case::Harmonic first;
  first.amplitude = entries.number(section, amplitude, not_negative_number);
  first.frequency =
      has_frequency ? entries.number(section, "Transverse frequency", positive_number) : motion.tangential_frequency;
  first.phase = entries.number(section, "Transverse phase", any_number);
  motion.transverse = {first};
  for (const auto& harmonic : read_harmonics(entries, harmonics)) motion.transverse.push_back(harmonic);
  if (!motion.phase)
    entries.fail(section, "Phase", "an angle in deg: in two directions the motion is computed with a fixed phase");
}

/// Given, relative or with a unit; or a share of the tolerance of the case.
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

/// Instead of all other entries of the section.
Case::Motion read_path_motion(const EntryReader& entries, std::vector<std::string>& notes) {
  const std::string section = "Motion";
  for (const char* name :
       {"Indentation", "Normal amplitude", "Normal force", "Normal force amplitude", "Normal frequency",
        "Normal harmonics", "Normal force harmonics", "Tangential amplitude", "Tangential force amplitude",
        "Tangential frequency", "Tangential harmonics", "Tangential force harmonics", "Transverse amplitude",
        "Transverse frequency", "Transverse phase", "Transverse harmonics", "Transverse force amplitude",
        "Transverse force harmonics", "Phase"})
    entries.forbid(section, name, "the Path is the motion");
  const bool repeats = entries.one_of(section, "Path repeats", {"once", "forever"}) == "forever";
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
    notes.push_back(
        fmt::format("{}: aligned: apex at {:.6g} ± {:.2g} m, tilt {:.4g} ± {:.2g} deg, heights {}, noise {:.2g} m",
                    indenter.table, trace.apex, trace.apex_uncertainty, std::atan(trace.tilt) * degrees,
                    trace.tilt_uncertainty * degrees, trace.heights_upwards ? "upwards" : "downwards", trace.noise));
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
  const auto& names = Case::shape_names;
  const std::string shape = entries.one_of(section, "Shape", {names.begin(), names.end()});
  if (shape.empty()) return {};
  forbid_others(entries, section, "Shape", shape,
                {{"Radius", {"parabola", "sphere", "truncated sphere"}},
                 {"Slope angle", {"cone"}},
                 {"Coefficient", {"power"}},
                 {"Exponent", {"power"}},
                 {"Flat radius", {"rounded flat", "truncated sphere"}},
                 {"Edge radius", {"rounded flat"}},
                 {"Table", {"table"}},
                 {"Table noise", {"table"}},
                 {"Table alignment", {"table"}}});
  Case::Indenter indenter;
  indenter.shape = static_cast<Case::Shape>(std::find(names.begin(), names.end(), shape) - names.begin());
  if (shape == "parabola" || shape == "sphere" || shape == "truncated sphere")
    indenter.radius = entries.number(section, "Radius", positive_number);
  if (shape == "rounded flat" || shape == "truncated sphere")
    indenter.flat_radius = entries.number(section, "Flat radius", positive_number);
  if (shape == "rounded flat") indenter.edge_radius = entries.number(section, "Edge radius", positive_number);
  if (shape == "cone")
    indenter.slope_angle = entries.number(
        section, "Slope angle", {[](double x) { return x > 0 && x < 90; }, "an angle between 0 and 90 degrees"});
  if (shape == "power") {
    indenter.coefficient = entries.number(section, "Coefficient", positive_number);
    indenter.exponent = entries.number(section, "Exponent",
                                       {[](double x) { return x >= 0.5 && x <= 20; }, "a number between 0.5 and 20"});
  }
  if (shape == "table") {
    indenter.table = read_table_path(entries, section, "Table", notes);
    if (entries.given(section, "Table noise"))
      indenter.table_noise = entries.number(section, "Table noise", not_negative_number);
    if (entries.given(section, "Table alignment") &&
        entries.one_of(section, "Table alignment", {"raw", "fit"}) == "fit" && !indenter.table.empty())
      align_table(entries, indenter, notes);
  }
  return indenter;
}

Case::Elastomer read_elastomer(const EntryReader& entries, std::vector<std::string>& warnings,
                               std::vector<std::string>& notes) {
  const std::string section = "Elastomer";
  Case::Elastomer elastomer;
  elastomer.rheology = entries.one_of(
      section, "Rheology", {"elastic", "kelvin voigt", "standard solid", "prony", "fractional zener", "table"});
  if (elastomer.rheology.empty()) return elastomer;
  if (entries.given(section, "Poisson ratio"))
    elastomer.poisson_ratio = entries.number(section, "Poisson ratio",
                                             {[](double x) { return x >= 0 && x <= 0.5; }, "a number from 0 to 0.5"});
  const std::vector<std::string> with_branches{"standard solid", "prony", "fractional zener"};
  forbid_others(entries, section, "Rheology", elastomer.rheology,
                {{"Relaxed shear modulus", {"elastic", "kelvin voigt", "standard solid", "prony", "fractional zener"}},
                 {"Shore A", {"elastic", "kelvin voigt", "standard solid", "prony", "fractional zener"}},
                 {"Branches", {"prony"}},
                 {"Branch ratios", {"prony"}},
                 {"Instantaneous shear modulus", {"prony"}},
                 {"Duration of the test", {"standard solid", "prony", "table"}},
                 {"Branch moduli", with_branches},
                 {"Branch times", with_branches},
                 {"Viscosity", {"kelvin voigt", "prony"}},
                 {"Fractional order", {"fractional zener"}},
                 {"Table", {"table"}},
                 {"Table modulus", {"table", "prony"}}});
  if (elastomer.rheology == "prony" && !entries.given(section, "Branches"))
    entries.forbid(section, "Table modulus", "it belongs to a Table or a file of Branches");
  if (elastomer.rheology == "table") {
    const bool youngs = entries.one_of(section, "Table modulus", {"shear", "Young"}) == "Young";
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
  if (std::find(with_branches.begin(), with_branches.end(), elastomer.rheology) != with_branches.end())
    read_branches(entries, elastomer, notes);
  if (elastomer.rheology == "kelvin voigt" || entries.given(section, "Viscosity"))
    elastomer.viscosity = entries.number(section, "Viscosity", positive_number);
  if (elastomer.rheology == "fractional zener")
    elastomer.fractional_order = entries.number(
        section, "Fractional order", {[](double x) { return x > 0 && x <= 1; }, "a number above 0 and at most 1"});
  shift_to_temperature(entries, elastomer);
  return elastomer;
}

Case::Body read_body(const EntryReader& entries, bool tangential) {
  const std::string section = "Body";
  const auto& names = Case::Body::shape_names;
  std::string shape = names.front();
  if (entries.given(section, "Shape")) shape = entries.one_of(section, "Shape", {names.begin(), names.end()});
  if (shape.empty()) return {};
  forbid_others(entries, section, "Shape", shape,
                {{"Thickness", {"layer", "cylinder"}},
                 {"Radius", {"cylinder"}},
                 {"Base", {"layer", "cylinder", "mesh"}},
                 {"Mesh", {"mesh"}},
                 {"Mesh unit", {"mesh"}},
                 {"Relative moduli", {"mesh"}}});
  Case::Body body;
  body.shape = static_cast<Case::Body::Shape>(std::find(names.begin(), names.end(), shape) - names.begin());
  if (body.is_half_space()) return body;
  if (body.shape == Case::Body::Shape::mesh)
    read_mesh_entries(entries, body);
  else
    body.thickness = entries.number(section, "Thickness", positive_number);
  if (body.shape == Case::Body::Shape::cylinder) body.radius = entries.number(section, "Radius", positive_number);
  // A base that is missing has been said once.
  body.is_bonded = entries.one_of(section, "Base", {"bonded", "frictionless"}) != "frictionless";
  if (!body.is_bonded && tangential)
    entries.fail(section, "Base",
                 "bonded: nothing but a base to which it is bonded holds the body against the "
                 "tangential motion");
  if (!body.is_bonded && body.grid && !has_level_base(*body.grid))
    entries.fail(section, "Base",
                 fmt::format("bonded: the base of {} is not level, on which it could slide", body.mesh));
  return body;
}

Case::Motion read_motion(const EntryReader& entries, std::vector<std::string>& notes) {
  const std::string section = "Motion";
  Case::Motion motion;
  if (entries.given(section, "Path")) return read_path_motion(entries, notes);
  for (const char* name : {"Path repeats", "Path tolerance"}) entries.forbid(section, name, "it belongs to a Path");
  read_normal_motion(entries, motion);
  read_tangential_motion(entries, motion);
  motion.normal_frequency = entries.number(section, "Normal frequency", positive_number);
  motion.tangential_frequency = entries.number(section, "Tangential frequency", positive_number);
  if (entries.text(section, "Phase") != "free") motion.phase = entries.number(section, "Phase", any_number);
  read_transverse_motion(entries, motion);
  return motion;
}

Case::Contact read_contact(const EntryReader& entries, const Case::Motion& motion) {
  const auto is_vector = [&](const char* section, const char* name) {
    return entries.given(section, name) && entries.one_of(section, name, {"unidirectional", "vector"}) == "vector";
  };
  Case::Contact contact;
  const bool by_law = is_vector("Friction", "Law");
  contact.vector_friction = is_vector("Contact", "Friction") || by_law;
  if (by_law && entries.given("Contact", "Friction") && !is_vector("Contact", "Friction"))
    entries.fail("Contact", "Friction", "vector, or no Friction / Law = vector beside it");
  const auto is_on = [&](const char* name) {
    return entries.given("Contact", name) && entries.one_of("Contact", name, {"off", "on"}) == "on";
  };
  contact.coupled = is_on("Coupling");
  contact.second_algorithm = is_on("Second algorithm");
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
