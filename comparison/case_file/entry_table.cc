#include "comparison/case_file/entry_table.h"

#include <fmt/format.h>

#include <cmath>

namespace fretval {
namespace {

using D = Dimension;
using Indenter = Case::Indenter;

const char* const needed = "an error";

const ValidNumber any_number{[](double) { return true; }, "a finite number", "any"};
const ValidNumber positive_number{[](double x) { return x > 0; }, "a positive number", "positive"};
const ValidNumber not_negative_number{[](double x) { return x >= 0; }, "a number that is not negative", "not negative"};
const ValidNumber triples{any_number.accepts, any_number.description, "triples, a list"};
const ValidNumber temperature{any_number.accepts, any_number.description, "above that of the shift's pole"};
const ValidNumber acute_angle{[](double x) { return x > 0 && x < 90; }, "an angle between 0 and 90 degrees",
                              "0 to 90 deg"};
const ValidNumber power_of_radius{[](double x) { return x >= 0.5 && x <= 20; }, "a number between 0.5 and 20",
                                  "0.5 to 20"};
const ValidNumber relaxed_modulus{
    positive_number.accepts,
    "a positive modulus in Pa: a body that relaxes to nothing (Maxwell) has no permanent stick", positive_number.brief};
const ValidNumber hardness{[](double x) { return x >= 10 && x <= 95; }, "a hardness from 10 to 95", "10 to 95"};
const ValidNumber order_of_element{[](double x) { return x > 0 && x <= 1; }, "a number above 0 and at most 1",
                                   "above 0, at most 1"};
const ValidNumber ratio_of_poisson{[](double x) { return x >= 0 && x <= 0.5; }, "a number from 0 to 0.5", "0 to 0.5"};
const ValidNumber stick_ratio{[](double x) { return x >= 0.01 && x <= 0.99; },
                              "a ratio of stick to unworn contact radius, 0.01 to 0.99", "0.01 to 0.99"};
const ValidNumber power_of_pressure{[](double x) { return x >= 0.25 && x <= 4; },
                                    "an exponent of the pressure, 0.25 to 4", "0.25 to 4"};
const ValidNumber share_of_first_rate{[](double x) { return x >= 1e-12 && x < 1; },
                                      "a share of the first wear rate, 1e-12 to 1", "1e-12 to 1"};
const ValidNumber relative_tolerance{[](double x) { return x >= 1e-5 && x <= 0.1; }, "a number between 1e-5 and 0.1",
                                     "1e-5 to 0.1"};

bool is_whole(double x, double least, double most) {
  return x == std::floor(x) && x >= least && x <= most;
}
// The error budget halves them, and fewer than 8 tell nothing.
const ValidNumber ring_count{[](double x) { return is_whole(x, 16, 640); }, "a whole number from 16 to 640",
                             "a whole number, 16 to 640"};
const ValidNumber step_count{[](double x) { return is_whole(x, 16, 10000); }, "a whole number from 16 to 10000",
                             "a whole number, 16 to 10000"};

/// Name of an entry: its words in a file, and its symbol at the axis of a plot.
struct Name {
  const char *words, *symbol;

  Name(const char* words_, const char* symbol_ = "") : words(words_), symbol(symbol_) {}
};

EntryTraits entry(const Name& name, std::vector<Dimension> dimensions, EntryValues values, const char* without,
                  const char* about, std::vector<std::string> owners = {}, Field field = {}) {
  return {name.words, name.symbol, std::move(dimensions), std::move(values), without, about, std::move(owners), field};
}

SectionTraits indenter_entries() {
  return {
      "Indenter",
      {entry("Shape", {}, Case::shape_names, needed, "the profile f(r)"),
       entry({"Radius", "R"}, {D::length}, positive_number, needed,
             "of curvature; parabola f = r²/(2R), sphere f = R - √(R² - r²), truncated sphere",
             {"parabola", "sphere", "truncated sphere"}, &Indenter::radius),
       entry({"Slope angle", "θ"}, {D::angle}, acute_angle, needed,
             "cone: between generatrix and surface, f = r tan(angle)", {"cone"}, &Indenter::slope_angle),
       entry("Coefficient", {D::varying}, positive_number, needed, "power: b of f = b rⁿ, in m^(1-n)", {"power"},
             &Indenter::coefficient),
       entry({"Exponent", "n"}, {D::number}, power_of_radius, needed, "power: n of f = b rⁿ", {"power"},
             &Indenter::exponent),
       entry({"Flat radius", "b"}, {D::length}, positive_number, needed,
             "rounded flat, truncated sphere: of the flat face", {"rounded flat", "truncated sphere"},
             &Indenter::flat_radius),
       entry("Edge radius", {D::length}, positive_number, needed, "rounded flat: of its edge", {"rounded flat"},
             &Indenter::edge_radius),
       entry("Table", {}, "a file, relative to the case file", needed,
             "table: CSV of r and f, units in its second line; r from 0 outwards, or from negative to positive through "
             "the apex at 0, whose halves are averaged; any profile, heights counted from the lowest row: where MDR "
             "does not hold, finite elements answer alone",
             {"table"}),
       entry("Table noise", {D::length}, not_negative_number, "0",
             "table: standard deviation of its heights; above 0 a convex profile is fitted instead of interpolated",
             {"table"}, &Indenter::table_noise),
       entry("Table alignment", {}, {"raw", "fit"}, "raw",
             "table; fit: a raw trace across the indenter, whose apex, tilt and sign follow from itself, and its noise "
             "where no Table noise is set",
             {"table"})}};
}

SectionTraits elastomer_entries() {
  const std::vector<std::string> with_branches{"standard solid", "prony", "fractional zener"},
      all_but_table{"elastic", "kelvin voigt", "standard solid", "prony", "fractional zener"};
  return {
      "Elastomer",
      {entry("Rheology", {}, Case::rheology_names, needed, "the law of the body in time"),
       entry({"Relaxed shear modulus", "G'(0)"}, {D::pressure}, relaxed_modulus, needed,
             "G'(0), of the body at rest; Young's over 2 (1 + ν), a third of it for ν = 1/2", all_but_table),
       entry({"Viscosity", "η"}, {D::viscosity}, positive_number, "none; kelvin voigt: an error",
             "of a dashpot beside the springs", {"kelvin voigt", "prony"}),
       entry({"Branch moduli", "G_1"}, {D::pressure}, {positive_number, ", a list"}, needed,
             "standard solid and fractional zener one, prony any number", with_branches),
       entry({"Branch times", "τ"}, {D::time}, {positive_number, ", a list"}, needed, "relaxation times, as many",
             with_branches),
       entry("Branch ratios", {D::number}, {positive_number, ", a list with a sum below 1"}, "Branch moduli",
             "prony: moduli of the branches over the instantaneous one, g_i", {"prony"}),
       entry("Branches", {}, "a file, relative to the case file", "Branch moduli and Branch times",
             "prony: table of moduli, or of ratios to the instantaneous one, and times; or an Abaqus *VISCOELASTIC, "
             "TIME=PRONY; may say E0",
             {"prony"}),
       entry("Instantaneous shear modulus", {D::pressure}, positive_number, "the Relaxed shear modulus",
             "prony, of a file of Branches or Branch ratios: G at once, of which the branches take their shares",
             {"prony"}),
       entry("Shore A", {D::number}, hardness, "the Relaxed shear modulus",
             "hardness, from which the modulus follows by Gent's formula, within some 20 %", all_but_table),
       entry("Duration of the test", {D::time}, positive_number, "for ever",
             "what relaxes more slowly is a spring; standard solid, prony, table",
             {"standard solid", "prony", "table"}),
       entry({"Fractional order", "α"}, {D::number}, order_of_element, needed, "fractional zener: of its element",
             {"fractional zener"}, &Case::Elastomer::fractional_order),
       entry({"Poisson ratio", "ν"}, {D::number}, ratio_of_poisson, "0.5, incompressible",
             "ν of the body, the same at all times", {}, &Case::Elastomer::poisson_ratio),
       entry("Table", {}, "a file, relative to the case file", needed,
             "table: CSV of f, G' and G'' (or E', E'') or tan delta, units in its second line; a Prony body is fitted",
             {"table"}),
       entry("Table modulus", {}, {"shear", "Young"}, needed,
             "table: which moduli it has; E = 2 (1 + ν) G; Branches: where names do not tell", {"table", "prony"}),
       entry({"Temperature", "T"}, {D::temperature}, temperature, "that of the data",
             "of the case; shifts all times (Williams, Landel, Ferry)"),
       entry("Reference temperature", {D::temperature}, any_number, "an error with a Temperature", "of the data"),
       entry("WLF C1", {D::number}, positive_number, "an error with a Temperature", "of the shift"),
       entry("WLF C2", {D::difference}, positive_number, "an error with a Temperature", "of the shift")}};
}

SectionTraits body_entries() {
  return {
      "Body",
      {entry("Shape", {}, Case::Body::shape_names, "half space", "what the indenter is pressed into"),
       entry({"Thickness", "H"}, {D::length}, positive_number, needed,
             "layer, cylinder: down to their flat, rigid base", {"layer", "cylinder"}, &Case::Body::thickness),
       entry({"Radius", "B"}, {D::length}, positive_number, needed, "cylinder: of its side, which is free",
             {"cylinder"}, &Case::Body::radius),
       entry(
           "Base", {}, {"bonded", "frictionless"}, needed,
           "layer, cylinder, mesh: what their base does; a frictionless one holds nothing against a tangential motion",
           {"layer", "cylinder", "mesh"}),
       entry("Mesh", {}, "a file, relative to the case file", needed,
             "mesh: a .msh file (gmsh, ASCII, version 2.2 or 4.1) of the meridian section, x for r and y for z, of "
             "quadrilaterals or triangles; physical curves contact (level, from r = 0 on; its edges are the rings), "
             "axis and base, all others are free",
             {"mesh"}),
       entry("Mesh unit", {D::length}, "a unit or a length", "m", "mesh: what the coordinates of the file are in",
             {"mesh"}),
       entry("Relative moduli", {}, "names with a positive number each, a list", "1 of all",
             "mesh: moduli of physical surfaces over those of the Elastomer, as `pad 1, skin 8`; all share its "
             "G(t)/G(0); 1 of those that are not named",
             {"mesh"})}};
}

SectionTraits motion_entries() {
  return {
      "Motion",
      {entry({"Indentation", "d_0"}, {D::length}, positive_number, needed, "d0, its mean"),
       entry({"Normal amplitude", "Δd"}, {D::length}, not_negative_number, needed, "Δd of d0 + Δd cos(2π f t)"),
       entry({"Normal force", "F_0"}, {D::force}, positive_number, "an Indentation",
             "its mean, prescribed instead of the indentation"),
       entry({"Normal force amplitude", "ΔF"}, {D::force}, not_negative_number, "an error with a Normal force",
             "of the normal force"),
       entry({"Normal frequency", "f"}, {D::frequency}, positive_number, needed, "f of the normal motion"),
       entry("Normal harmonics", {D::length, D::frequency, D::angle}, triples, "none",
             "more cosines: amplitude, frequency, phase of each"),
       entry("Normal force harmonics", {D::force, D::frequency, D::angle}, triples, "none", "of the normal force"),
       entry({"Tangential amplitude", "u_{x0}"}, {D::length}, {not_negative_number, ", or the word shakedown"}, needed,
             "u_x0; shakedown: the one that the limiting profile belongs to"),
       entry({"Tangential force amplitude", "F_x"}, {D::force}, not_negative_number, "a Tangential amplitude",
             "prescribed instead of the amplitude"),
       entry({"Tangential frequency", "f_x"}, {D::frequency}, positive_number, needed,
             "of the tangential motion; any ratio"),
       entry("Tangential harmonics", {D::length, D::frequency, D::angle}, triples, "none", "likewise"),
       entry("Tangential force harmonics", {D::force, D::frequency, D::angle}, triples, "none",
             "of the tangential force"),
       entry("Transverse amplitude", {D::length}, not_negative_number, "it moves along x alone",
             "u_y0, of a motion across the tangential one; with Contact / Friction = vector"),
       entry("Transverse frequency", {D::frequency}, positive_number, "the Tangential frequency", "of u_y"),
       entry("Transverse phase", {D::angle}, any_number, "an error with a Transverse amplitude", "of u_y"),
       entry("Transverse harmonics", {D::length, D::frequency, D::angle}, triples, "none", "of u_y, likewise"),
       entry("Transverse force amplitude", {D::force}, not_negative_number, "no force across",
             "F_y0 across a Tangential force amplitude, with the frequency and phase of u_y"),
       entry("Transverse force harmonics", {D::force, D::frequency, D::angle}, triples, "none", "of F_y, likewise"),
       entry({"Phase", "φ_0"}, {D::angle}, {any_number, ", or the word free"}, needed,
             "φ0 of the tangential motion; free: the two are not synchronised"),
       entry("Path", {}, "a file, relative to the case file", "oscillations",
             "any motion instead of oscillations: CSV of t, d or the force F_N, u_x or the force F_x, and u_y or F_y "
             "for friction as a vector, units in its second line; linear between its rows"),
       entry("Path repeats", {}, {"once", "forever"}, "an error with a Path",
             "once: one pass, from rest without tangential force at the first row; forever: the last row is the first "
             "again; a record that does not close is folded to its mean cycle"),
       entry("Path tolerance", {D::varying}, "above 0 and below 1, or a length or force with its unit",
             "of more than 2000 rows an eighth of the Accuracy / Tolerance",
             "how far the path may be from the rows of a record, of which so many are kept; a number is a share of the "
             "largest values")}};
}

std::vector<SectionTraits> all_sections() {
  return {
      indenter_entries(),
      elastomer_entries(),
      {"Friction",
       {entry({"Coefficient", "μ"}, {D::number}, positive_number, needed, "μ of Coulomb's law"),
        entry("Law", {}, {"unidirectional", "vector"}, "unidirectional", "the same as Contact / Friction")}},
      {"Contact",
       {entry("Friction", {}, {"unidirectional", "vector"}, "unidirectional",
              "unidirectional: the traction keeps the direction of the motion, as MDR assumes; vector: it has any, "
              "against the slip"),
        entry("Coupling", {}, {"off", "on"}, "off",
              "on: pressures displace along the surface, and tractions across it, as in any body but an incompressible "
              "half-space; with Friction = vector"),
        entry("Second algorithm", {}, {"off", "on"}, "off",
              "on: each step is solved once more, by projected gradients, and the largest difference of a traction or "
              "pressure is told; several times as long; with Friction = vector")}},
      body_entries(),
      motion_entries(),
      {"Wear",
       {entry("State", {}, {"unworn", "limiting"}, "unworn", "limiting: the profile in which nothing wears any more"),
        entry({"Stick radius ratio", "c/a"}, {D::number}, stick_ratio, "an error with State = limiting",
              "limiting: c over the unworn contact radius at the largest indentation"),
        entry("Law", {}, Case::wear_law_names, "archard", "of the course of wear"),
        entry("Coefficient", {D::wear_rate}, not_negative_number, "no wear",
              "worn depth per pressure and path of slip; energy: per energy of friction and area; power: in "
              "Pa^-exponent, without a unit"),
        entry("Exponent", {D::number}, power_of_pressure, "an error with Law = power", "power: of the pressure"),
        entry("Cycles", {D::number}, not_negative_number, "until nothing wears any more", "of the motion"),
        entry("Until", {D::number}, share_of_first_rate, "not used",
              "ends when the volume worn off in a cycle has fallen to this share of the first"),
        entry("Profile", {}, "a CSV file with columns r, f and their units", "unworn",
              "heights that the indenter has worn to before, as fretval run writes them (`worn_profile.csv`) or "
              "somebody has measured; wear goes on from there"),
        entry("Worn rings", {}, "a CSV file with columns r outer, worn depth and their units", "unworn",
              "instead of Profile: what the rings of an earlier run have lost (`worn_rings.csv`), to the last digit")}},
      {"Accuracy",
       {entry("Tolerance", {D::number}, relative_tolerance, "an error; `fretval mdr` needs none",
              "relative to the contact radius, on the stick radii; a tenth of it on contact radius and force"),
        entry("Cycle tolerance", {D::number}, relative_tolerance, "they come along, with their bars",
              "relative, on forces and energies of a cycle of a locked motion; over what sliding would cost on the "
              "mean force and, a tenth of it, on what friction takes"),
        entry("Rings per radius", {D::number}, ring_count, "what the tolerance asks for", "of the mesh"),
        entry("Steps per cycle", {D::number}, step_count, "what the tolerance asks for", "in time")}},
      {"Measured",
       {entry("Loops", {}, "a file, relative to the case file", "none",
              "table of forces F_N, F_x, and of t, d, u_x where it has them, over a cycle or a pass, with units"),
        entry("Stick radius", {D::length}, positive_number, "none", "of the periodic state, or of a pass"),
        entry("Stick radius uncertainty", {D::length}, not_negative_number, "an error with a Stick radius",
              "standard deviation"),
        entry("Contact radius", {D::length}, positive_number, "none", "the largest one"),
        entry("Contact radius uncertainty", {D::length}, not_negative_number, "an error with a Contact radius",
              "standard deviation")}},
      {"Output",
       {entry("Fields", {}, {"none", "extremes", "cycle"}, "extremes; in a sweep, and without a proof, none",
              "instants of the last period to show in ParaView: none, those of the smallest and largest indentation, "
              "or 24")}},
      {"Sweep",
       {entry("Entry", {}, "SECTION / ENTRY", "a single case", "one case for each value of this entry"),
        entry("Values", {}, "a list, or first : step : last", "an error with an Entry", "in the units of the entry"),
        entry("Second entry", {}, "SECTION / ENTRY", "a line of cases",
              "a map: one case for each value of the entry with each of this one; the report shows where the contact "
              "sticks, slips in part, and slides"),
        entry("Second values", {}, "a list, or first : step : last", "an error with a Second entry", "in its units")}}};
}

}  // namespace

EntryValues::EntryValues(const char* const* first, const char* const* last)
    : text(fmt::format("{}", fmt::join(first, last, ", "))), words(first, last) {}

const std::vector<SectionTraits>& case_sections() {
  static const auto all = all_sections();
  return all;
}

}  // namespace fretval
