#include "comparison/case_file/new_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/case/case.h"
#include "comparison/case_file/entry_lookup.h"
#include "comparison/support/constants.h"
#include "comparison/support/text.h"

namespace fretval {
namespace {

struct Entry {
  const char* name;
  std::string value;
};
using Entries = std::vector<Entry>;

Entries shape_entries(const std::string& shape, const std::string& stem) {
  if (shape == "parabola" || shape == "sphere") return {{"Radius", "10 mm"}};
  if (shape == "cone") return {{"Slope angle", "5 deg"}};
  if (shape == "power") return {{"Coefficient", "4e4"}, {"Exponent", "3"}};
  if (shape == "rounded flat") return {{"Flat radius", "0.5 mm"}, {"Edge radius", "10 mm"}};
  if (shape == "truncated sphere") return {{"Radius", "10 mm"}, {"Flat radius", "0.5 mm"}};
  return {{"Table", stem + "-profile.csv"}};
}

Entries rheology_entries(const std::string& rheology, const std::string& stem) {
  if (rheology == "table") return {{"Table", stem + "-moduli.csv"}, {"Table modulus", "shear"}};
  Entries entries{{"Relaxed shear modulus", "1 MPa"}};
  const auto add = [&](const Entries& more) { entries.insert(entries.end(), more.begin(), more.end()); };
  if (rheology == "kelvin voigt") add({{"Viscosity", "0.1 MPa s"}});
  if (rheology == "standard solid") add({{"Branch moduli", "1 MPa"}, {"Branch times", "0.1 s"}});
  if (rheology == "prony") add({{"Branch moduli", "1, 0.5 MPa"}, {"Branch times", "0.1, 1 s"}});
  if (rheology == "fractional zener")
    add({{"Branch moduli", "1 MPa"}, {"Branch times", "0.1 s"}, {"Fractional order", "0.5"}});
  return entries;
}

/// Each entry with its meaning, and what it may be where there is room for that.
std::string section_text(const std::string& section, const Entries& entries, bool commented = false) {
  std::string text = fmt::format("{}subsection {}\n", commented ? "# " : "", section);
  for (const auto& [name, value] : entries) {
    const auto* traits = find_entry(section, name);
    auto line =
        fmt::format("{}  {:<38}# {}", commented ? "# " : "", fmt::format("set {} = {}", name, value), traits->about);
    constexpr std::size_t widest = 118;
    if (const auto rest = fmt::format("; {}", traits->values.text); line.size() + rest.size() <= widest) line += rest;
    text += line + "\n";
  }
  return text + (commented ? "# end\n\n" : "end\n\n");
}

/// r²/(2 R) with R = 10 mm.
std::string profile_table() {
  std::string text = "# In the place of a measured profile: a sphere of radius 10 mm, r^2/(2 R).\nr,f\nmm,um\n";
  for (int k = 0; k <= 40; ++k) text += fmt::format("{:.3f},{:.5f}\n", 0.05 * k, 0.125 * k * k);
  return text;
}

/// G = G0 + G1 iωτ/(1 + iωτ) with G0 = G1 = 1 MPa, τ = 0.1 s.
std::string modulus_table() {
  std::string text =
      "# In the place of measured moduli: a standard solid, 1 MPa beside 1 MPa with 0.1 s.\nf,G',G''\n"
      "Hz,MPa,MPa\n";
  for (int k = -12; k <= 16; ++k) {
    const double f = std::pow(10.0, k / 8.0), x = 2 * pi * f * 0.1;
    text += fmt::format("{:.6g},{:.8g},{:.8g}\n", f, 1 + x * x / (1 + x * x), x / (1 + x * x));
  }
  return text;
}

void require_choice(const char* option, const std::string& word, const std::vector<std::string>& choices) {
  if (std::find(choices.begin(), choices.end(), word) == choices.end())
    throw InputError(fmt::format("{} {}: expected one of {}{}", option, word, fmt::join(choices, ", "),
                                 did_you_mean(word, choices)));
}

}  // namespace

const std::vector<std::string>& new_case_shapes() {
  return find_entry("Indenter", "Shape")->values.words;
}

const std::vector<std::string>& new_case_rheologies() {
  return find_entry("Elastomer", "Rheology")->values.words;
}

std::map<std::string, std::string> new_case_files(const std::string& stem, const NewCase& choice) {
  require_choice("--shape", choice.shape, new_case_shapes());
  require_choice("--rheology", choice.rheology, new_case_rheologies());
  const auto with = [](const char* name, const std::string& value, const Entries& more) {
    Entries entries{{name, value}};
    entries.insert(entries.end(), more.begin(), more.end());
    return entries;
  };
  std::string text = fmt::format(
      "# A rigid indenter oscillates on an incompressible viscoelastic half-space. Numbers may have a unit; without "
      "one they\n# are SI, angles in degrees, frequencies in Hz. `fretval explain {0}.prm` says what the case is, "
      "`fretval run\n# {0}.prm` computes it, `fretval explain --entries` lists every entry.\n\n",
      stem);
  text += section_text("Indenter", with("Shape", choice.shape, shape_entries(choice.shape, stem)));
  text += section_text("Elastomer", with("Rheology", choice.rheology, rheology_entries(choice.rheology, stem)));
  text += section_text("Friction", {{"Coefficient", "0.5"}});
  text += section_text("Motion", {{"Indentation", "0.1 mm"},
                                  {"Normal amplitude", "20 um"},
                                  {"Normal frequency", "1 Hz"},
                                  {"Tangential amplitude", "15 um"},
                                  {"Tangential frequency", "1 Hz"},
                                  {"Phase", "60 deg"}});
  text += section_text("Accuracy", {{"Tolerance", "1e-3"}});
  text += "# A motion that was measured, instead of the one above: a table of t, d and u_x with a line of units.\n" +
          section_text("Motion", {{"Path", stem + "-path.csv"}, {"Path repeats", "forever"}}, true);
  text += "# How the indenter wears.\n" + section_text("Wear", {{"Coefficient", "1e-13"}, {"Cycles", "1e6"}}, true);
  text += "# One case for each value of an entry.\n" +
          section_text("Sweep", {{"Entry", "Motion / Phase"}, {"Values", "0 : 15 : 180 deg"}}, true);
  text.pop_back();
  std::map<std::string, std::string> files{{stem + ".prm", text}};
  if (choice.shape == "table") files[stem + "-profile.csv"] = profile_table();
  if (choice.rheology == "table") files[stem + "-moduli.csv"] = modulus_table();
  return files;
}

}  // namespace fretval
