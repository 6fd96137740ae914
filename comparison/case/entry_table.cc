#include "comparison/case/entry_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "comparison/support/closest.h"

namespace fretval {
namespace {

using D = Dimension;

const char* const needed = "an error";

SectionTraits indenter_entries() {
  return {
      "Indenter",
      {{"Shape",
        {},
        "parabola, sphere, cone, power, rounded flat, truncated sphere, table",
        needed,
        "the profile f(r)"},
       {"Radius",
        {D::length},
        "positive",
        needed,
        "of curvature; parabola f = r²/(2R), sphere f = R - √(R² - r²), truncated sphere"},
       {"Slope angle", {D::angle}, "0 to 90 deg", needed, "cone: between generatrix and surface, f = r tan(angle)"},
       {"Coefficient", {D::varying}, "positive", needed, "power: b of f = b rⁿ, in m^(1-n)"},
       {"Exponent", {D::number}, "0.5 to 20", needed, "power: n of f = b rⁿ"},
       {"Flat radius", {D::length}, "positive", needed, "rounded flat, truncated sphere: of the flat face"},
       {"Edge radius", {D::length}, "positive", needed, "rounded flat: of its edge"},
       {"Table",
        {},
        "a file, relative to the case file",
        needed,
        "table: CSV of r and f, units in its second line; r from 0 outwards, or from negative to positive through "
        "the apex at 0, whose halves are averaged; any profile, heights counted from the lowest row: where MDR does "
        "not hold, finite elements answer alone"},
       {"Table noise",
        {D::length},
        "not negative",
        "0",
        "table: standard deviation of its heights; above 0 a convex profile is fitted instead of interpolated"},
       {"Table alignment",
        {},
        "raw, fit",
        "raw",
        "table; fit: a raw trace across the indenter, whose apex, tilt and sign follow from itself, and its noise "
        "where "
        "no Table noise is set"}}};
}

SectionTraits elastomer_entries() {
  return {"Elastomer",
          {{"Rheology",
            {},
            "elastic, kelvin voigt, standard solid, prony, fractional zener, table",
            needed,
            "the law of the body in time"},
           {"Relaxed shear modulus",
            {D::pressure},
            "positive",
            needed,
            "G'(0), of the body at rest; Young's over 2 (1 + ν), a third of it for ν = 1/2"},
           {"Viscosity", {D::viscosity}, "positive", "none; kelvin voigt: an error", "of a dashpot beside the springs"},
           {"Branch moduli",
            {D::pressure},
            "positive, a list",
            needed,
            "standard solid and fractional zener one, prony any number"},
           {"Branch times", {D::time}, "positive, a list", needed, "relaxation times, as many"},
           {"Branch ratios",
            {D::number},
            "positive, a list with a sum below 1",
            "Branch moduli",
            "prony: moduli of the branches over the instantaneous one, g_i"},
           {"Branches",
            {},
            "a file, relative to the case file",
            "Branch moduli and Branch times",
            "prony: table of moduli, or of ratios to the instantaneous one, and times; or an Abaqus *VISCOELASTIC, "
            "TIME=PRONY; may say E0"},
           {"Instantaneous shear modulus",
            {D::pressure},
            "positive",
            "the Relaxed shear modulus",
            "prony, of a file of Branches or Branch ratios: G at once, of which the branches take their shares"},
           {"Shore A",
            {D::number},
            "10 to 95",
            "the Relaxed shear modulus",
            "hardness, from which the modulus follows by Gent's formula, within some 20 %"},
           {"Duration of the test",
            {D::time},
            "positive",
            "for ever",
            "what relaxes more slowly is a spring; standard solid, prony, table"},
           {"Fractional order", {D::number}, "above 0, at most 1", needed, "fractional zener: of its element"},
           {"Poisson ratio", {D::number}, "0 to 0.5", "0.5, incompressible", "ν of the body, the same at all times"},
           {"Table",
            {},
            "a file, relative to the case file",
            needed,
            "table: CSV of f, G' and G'' or tan delta, units in its second line; a Prony body is fitted"},
           {"Table modulus",
            {},
            "shear, Young",
            needed,
            "table: which moduli it has; E = 2 (1 + ν) G; Branches: where names do not tell"},
           {"Temperature",
            {D::temperature},
            "above that of the shift's pole",
            "that of the data",
            "of the case; shifts all times (Williams, Landel, Ferry)"},
           {"Reference temperature", {D::temperature}, "any", "an error with a Temperature", "of the data"},
           {"WLF C1", {D::number}, "positive", "an error with a Temperature", "of the shift"},
           {"WLF C2", {D::difference}, "positive", "an error with a Temperature", "of the shift"}}};
}

SectionTraits body_entries() {
  return {
      "Body",
      {{"Shape", {}, "half space, layer, cylinder, mesh", "half space", "what the indenter is pressed into"},
       {"Thickness", {D::length}, "positive", needed, "layer, cylinder: down to their flat, rigid base"},
       {"Radius", {D::length}, "positive", needed, "cylinder: of its side, which is free"},
       {"Base",
        {},
        "bonded, frictionless",
        needed,
        "layer, cylinder, mesh: what their base does; a frictionless one holds nothing against a tangential motion"},
       {"Mesh",
        {},
        "a file, relative to the case file",
        needed,
        "mesh: a .msh file (gmsh, ASCII, version 2.2 or 4.1) of the meridian section, x for r and y for z, of "
        "quadrilaterals or triangles; physical curves contact (level, from r = 0 on; its edges are the rings), axis "
        "and base, all others are free"},
       {"Mesh unit", {D::length}, "a unit or a length", "m", "mesh: what the coordinates of the file are in"},
       {"Relative moduli",
        {},
        "names with a positive number each, a list",
        "1 of all",
        "mesh: moduli of physical surfaces over those of the Elastomer, as `pad 1, skin 8`; all share its G(t)/G(0); "
        "1 of those that are not named"}}};
}

SectionTraits motion_entries() {
  return {
      "Motion",
      {{"Indentation", {D::length}, "positive", needed, "d0, its mean"},
       {"Normal amplitude", {D::length}, "not negative", needed, "Δd of d0 + Δd cos(2π f t)"},
       {"Normal force", {D::force}, "positive", "an Indentation", "its mean, prescribed instead of the indentation"},
       {"Normal force amplitude", {D::force}, "not negative", "an error with a Normal force", "of the normal force"},
       {"Normal frequency", {D::frequency}, "positive", needed, "f of the normal motion"},
       {"Normal harmonics",
        {D::length, D::frequency, D::angle},
        "triples, a list",
        "none",
        "more cosines: amplitude, frequency, phase of each"},
       {"Normal force harmonics", {D::force, D::frequency, D::angle}, "triples, a list", "none", "of the normal force"},
       {"Tangential amplitude",
        {D::length},
        "not negative, or the word shakedown",
        needed,
        "u_x0; shakedown: the one that the limiting profile belongs to"},
       {"Tangential force amplitude",
        {D::force},
        "not negative",
        "a Tangential amplitude",
        "prescribed instead of the amplitude"},
       {"Tangential frequency", {D::frequency}, "positive", needed, "of the tangential motion; any ratio"},
       {"Tangential harmonics", {D::length, D::frequency, D::angle}, "triples, a list", "none", "likewise"},
       {"Tangential force harmonics",
        {D::force, D::frequency, D::angle},
        "triples, a list",
        "none",
        "of the tangential force"},
       {"Transverse amplitude",
        {D::length},
        "not negative",
        "it moves along x alone",
        "u_y0, of a motion across the tangential one; with Contact / Friction = vector"},
       {"Transverse frequency", {D::frequency}, "positive", "the Tangential frequency", "of u_y"},
       {"Transverse phase", {D::angle}, "any", "an error with a Transverse amplitude", "of u_y"},
       {"Transverse harmonics", {D::length, D::frequency, D::angle}, "triples, a list", "none", "of u_y, likewise"},
       {"Phase",
        {D::angle},
        "any, or the word free",
        needed,
        "φ0 of the tangential motion; free: the two are not synchronised"},
       {"Path",
        {},
        "a file, relative to the case file",
        "oscillations",
        "any motion instead of oscillations: CSV of t, d or the force F_N, u_x or the force F_x, units in its second "
        "line; "
        "linear between its rows"},
       {"Path repeats",
        {},
        "once, forever",
        "an error with a Path",
        "once: one pass, from rest without tangential force at the first row; forever: the last row is the first "
        "again; a record that does not close is folded to its mean cycle"},
       {"Path tolerance",
        {D::varying},
        "above 0 and below 1, or a length or force with its unit",
        "of more than 2000 rows an eighth of the Accuracy / Tolerance",
        "how far the path may be from the rows of a record, of which so many are kept; a number is a share of the "
        "largest values"}}};
}

std::vector<SectionTraits> all_sections() {
  return {
      indenter_entries(),
      elastomer_entries(),
      {"Friction",
       {{"Coefficient", {D::number}, "positive", needed, "μ of Coulomb's law"},
        {"Law", {}, "unidirectional, vector", "unidirectional", "the same as Contact / Friction"}}},
      {"Contact",
       {{"Friction",
         {},
         "unidirectional, vector",
         "unidirectional",
         "unidirectional: the traction keeps the direction of the motion, as MDR assumes; vector: it has any, against "
         "the slip"},
        {"Coupling",
         {},
         "off, on",
         "off",
         "on: pressures displace along the surface, and tractions across it, as in any body but an incompressible "
         "half-space; with Friction = vector"}}},
      body_entries(),
      motion_entries(),
      {"Wear",
       {{"State", {}, "unworn, limiting", "unworn", "limiting: the profile in which nothing wears any more"},
        {"Stick radius ratio",
         {D::number},
         "0.01 to 0.99",
         "an error with State = limiting",
         "limiting: c over the unworn contact radius at the largest indentation"},
        {"Law", {}, "archard, energy, power", "archard", "of the course of wear"},
        {"Coefficient",
         {D::wear_rate},
         "not negative",
         "no wear",
         "worn depth per pressure and path of slip; energy: per energy of friction and area; power: in Pa^-exponent, "
         "without a unit"},
        {"Exponent", {D::number}, "0.25 to 4", "an error with Law = power", "power: of the pressure"},
        {"Cycles", {D::number}, "not negative", "until nothing wears any more", "of the motion"},
        {"Until",
         {D::number},
         "1e-12 to 1",
         "not used",
         "ends when the volume worn off in a cycle has fallen to this share of the first"},
        {"Profile",
         {},
         "a CSV file with columns r, f and their units",
         "unworn",
         "heights that the indenter has worn to before, as fretval run writes them (`worn_profile.csv`) or somebody "
         "has "
         "measured; wear goes on from there"},
        {"Worn rings",
         {},
         "a CSV file with columns r outer, worn depth and their units",
         "unworn",
         "instead of Profile: what the rings of an earlier run have lost (`worn_rings.csv`), to the last digit"}}},
      {"Accuracy",
       {{"Tolerance",
         {D::number},
         "1e-5 to 0.1",
         "an error; `fretval mdr` needs none",
         "relative to the contact radius, on the stick radii; a tenth of it on contact radius and force"},
        {"Cycle tolerance",
         {D::number},
         "1e-5 to 0.1",
         "they come along, with their bars",
         "relative, on forces and energies of a cycle of a locked motion; over what sliding would cost on the mean "
         "force and, a tenth of it, on what friction takes"},
        {"Rings per radius", {D::number}, "a whole number, 16 to 640", "what the tolerance asks for", "of the mesh"},
        {"Steps per cycle", {D::number}, "a whole number, 16 to 10000", "what the tolerance asks for", "in time"}}},
      {"Measured",
       {{"Loops",
         {},
         "a file, relative to the case file",
         "none",
         "table of forces F_N, F_x, and of t, d, u_x where it has them, over a cycle or a pass, with units"},
        {"Stick radius", {D::length}, "positive", "none", "of the periodic state, or of a pass"},
        {"Stick radius uncertainty", {D::length}, "not negative", "an error with a Stick radius", "standard deviation"},
        {"Contact radius", {D::length}, "positive", "none", "the largest one"},
        {"Contact radius uncertainty",
         {D::length},
         "not negative",
         "an error with a Contact radius",
         "standard deviation"}}},
      {"Output",
       {{"Fields",
         {},
         "none, extremes, cycle",
         "extremes; in a sweep, and without a proof, none",
         "instants of the last period to show in ParaView: none, those of the smallest and largest indentation, or "
         "24"}}},
      {"Sweep",
       {{"Entry", {}, "SECTION / ENTRY", "a single case", "one case for each value of this entry"},
        {"Values", {}, "a list, or first : step : last", "an error with an Entry", "in the units of the entry"}}}};
}

std::vector<std::string> section_names() {
  std::vector<std::string> names;
  for (const auto& section : case_sections()) names.emplace_back(section.name);
  return names;
}

const SectionTraits* find_section(const std::string& name) {
  for (const auto& section : case_sections())
    if (section.name == name) return &section;
  return nullptr;
}

std::string names_in(const SectionTraits& section) {
  std::string list;
  for (const auto& entry : section.entries) list += (list.empty() ? "" : ", ") + std::string(entry.name);
  return list;
}

std::string lower_letters(const std::string& text) {
  std::string letters;
  for (const char c : text)
    if (std::isalpha(static_cast<unsigned char>(c)))
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

/// With the full stop that it lacks, and a blank.
std::string as_sentence(const std::string& hint) {
  return hint + (!hint.empty() && hint.back() == '?' ? " " : ". ");
}

/// What people write who come from other programs.
std::string known_elsewhere(const std::string& name) {
  const auto letters = lower_letters(name);
  if (letters.find("poisson") != std::string::npos || letters == "nu")
    return "; write Elastomer / Poisson ratio = 0.49, say; it is 1/2 where it is not set";
  if (letters.find("young") != std::string::npos || letters == "e")
    return "; write Relaxed shear modulus = E/3, or E/(2 (1 + ν)) with an Elastomer / Poisson ratio";
  return "";
}

}  // namespace

const std::vector<SectionTraits>& case_sections() {
  static const auto all = all_sections();
  return all;
}

const EntryTraits* find_entry(const std::string& section, const std::string& name) {
  const auto* found = find_section(section);
  if (!found) return nullptr;
  for (const auto& entry : found->entries)
    if (entry.name == name) return &entry;
  return nullptr;
}

bool is_entry(const std::string& section, const std::string& name) {
  return find_entry(section, name) != nullptr;
}

bool is_section(const std::string& section) {
  return find_section(section) != nullptr;
}

std::string valid_entries() {
  std::string list;
  for (const auto& section : case_sections())
    list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", section.name, names_in(section));
  return list;
}

std::string no_such_section(const std::string& section, Problems& problems) {
  problems.meant.insert(closest(section, section_names()));
  return fmt::format("subsection {}: no such subsection{}Valid subsections: {}", section,
                     as_sentence(did_you_mean(section, section_names())), fmt::join(section_names(), ", "));
}

std::string no_such_entry(const std::string& section, const std::string& name, Problems& problems) {
  std::vector<std::string> here, elsewhere;
  for (const auto& other : case_sections())
    for (const auto& entry : other.entries) {
      if (other.name == section)
        here.emplace_back(entry.name);
      else if (closest(name, {entry.name}) == entry.name)
        elsewhere.push_back(fmt::format("{} / {}", other.name, entry.name));
    }
  problems.meant.insert(section + " / " + closest(name, here));
  std::string hint = known_elsewhere(name);
  if (hint.empty()) hint = did_you_mean(name, here);
  if (hint.empty() && !elsewhere.empty()) hint = fmt::format("; did you mean {}?", fmt::join(elsewhere, " or "));
  const auto* owner = find_section(section);
  return fmt::format("{}{}: no such entry{}Valid entries{}: {}", section.empty() ? "" : section + " / ", name,
                     as_sentence(hint), owner ? std::string(" of ") + owner->name : "",
                     owner ? names_in(*owner) : valid_entries());
}

std::string entries_reference() {
  std::string text =
      "# Entries of a case file\n\n`fretval explain --entries` prints this page; `fretval new` writes a case file to "
      "begin "
      "with.\n\nA case file (`.prm`) has subsections of entries, `set NAME = VALUE`; what follows a # is a comment. "
      "`include FILE` lines\nbefore the first subsection take over another file, whose entries may be set again. The "
      "same "
      "in JSON: sections as objects\nof entries, lists as arrays.\n\nNumbers may have a unit of what the entry "
      "measures; "
      "without one they are in the unit of the table. In a list each number\nhas a unit, or none, or the last one for "
      "all.\n\n| measured in | also |\n| --- | --- |\n";
  for (const auto dimension : {D::length, D::frequency, D::pressure, D::time, D::angle, D::viscosity, D::force,
                               D::temperature, D::difference, D::wear_rate})
    text += fmt::format("| {} | {} |\n", base_unit(dimension), other_units(dimension));
  for (const auto& section : case_sections()) {
    text += fmt::format(
        "\n## {}\n\n| entry | values | unit | where it is not set | meaning |\n| --- | --- | --- | --- | --- |\n",
        section.name);
    for (const auto& entry : section.entries) {
      std::vector<std::string> units;
      for (const auto dimension : entry.dimensions) units.push_back(base_unit(dimension));
      text += fmt::format("| {} | {} | {} | {} | {} |\n", entry.name, entry.values, fmt::join(units, ", "),
                          entry.without, entry.about);
    }
  }
  return text;
}

}  // namespace fretval
