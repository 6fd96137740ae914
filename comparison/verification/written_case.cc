#include "comparison/verification/written_case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "comparison/case_file/case_file.h"
#include "comparison/case_file/entry_lookup.h"
#include "comparison/reference/mdr_case.h"
#include "mdr/profiles/profile.h"
#include "mdr/stick/shakedown_amplitude.h"

namespace fretval {
namespace {

/// A section with its deciding entry.
Entries section(const char* deciding, const std::string& choice, const std::map<std::string, double>& numbers) {
  return with_numbers({{deciding, choice}}, numbers);
}

}  // namespace

std::string entry_text(double value) {
  return fmt::format("{}", value);
}

Entries with(Entries entries, const Entries& changes) {
  for (const auto& [place, value] : changes) entries[place] = value;
  return entries;
}

Entries with_numbers(Entries entries, const std::map<std::string, double>& changes) {
  for (const auto& [place, value] : changes) entries[place] = entry_text(value);
  return entries;
}

Entries with_stick_ratio(const Entries& entries, double stick_ratio, double factor) {
  const auto input = case_of(entries, "case");
  const auto mdr = mdr_case(input);
  const double contact_radius = mdr::inverse_transform(mdr.profile, mdr::maximum_indentation(mdr.motion));
  const auto amplitude = mdr::tangential_amplitude_for_shakedown(
      mdr.body, mdr.friction_coefficient, one_harmonic_each_of(input, mdr, "Motion / Tangential amplitude"),
      mdr::transform(mdr.profile, stick_ratio * contact_radius));
  if (!amplitude) throw InputError(fmt::format("no tangential amplitude shakes down at c/a = {:g}", stick_ratio));
  return with(entries, {{"Motion / Tangential amplitude", entry_text(factor * *amplitude)}});
}

std::string case_text(const Entries& entries) {
  std::string text;
  for (const auto& [place, value] : entries) {
    const auto [section, entry] = place_of(place);
    text += fmt::format("subsection {}\n  set {} = {}\nend\n", section, entry, value);
  }
  return text;
}

Case case_of(const Entries& entries, const std::string& name, const std::string& file) {
  Case input = read_case_text(case_text(entries), file);
  input.name = name;
  return input;
}

Entries parabola(double radius) {
  return section("Indenter / Shape", "parabola", {{"Indenter / Radius", radius}});
}

Entries sphere(double radius) {
  return section("Indenter / Shape", "sphere", {{"Indenter / Radius", radius}});
}

Entries cone(double degrees) {
  return section("Indenter / Shape", "cone", {{"Indenter / Slope angle", degrees}});
}

Entries power(double exponent, double coefficient) {
  return section("Indenter / Shape", "power",
                 {{"Indenter / Exponent", exponent}, {"Indenter / Coefficient", coefficient}});
}

Entries rounded_flat(double flat_radius, double edge_radius) {
  return section("Indenter / Shape", "rounded flat",
                 {{"Indenter / Flat radius", flat_radius}, {"Indenter / Edge radius", edge_radius}});
}

Entries truncated_sphere(double radius, double flat_radius) {
  return section("Indenter / Shape", "truncated sphere",
                 {{"Indenter / Radius", radius}, {"Indenter / Flat radius", flat_radius}});
}

Entries elastic(double modulus) {
  return section("Elastomer / Rheology", "elastic", {{"Elastomer / Relaxed shear modulus", modulus}});
}

Entries kelvin_voigt(double modulus, double viscosity) {
  return section("Elastomer / Rheology", "kelvin voigt",
                 {{"Elastomer / Relaxed shear modulus", modulus}, {"Elastomer / Viscosity", viscosity}});
}

Entries branches(const std::string& rheology, double modulus, const std::vector<double>& moduli,
                 const std::vector<double>& times) {
  return with(section("Elastomer / Rheology", rheology, {{"Elastomer / Relaxed shear modulus", modulus}}),
              {{"Elastomer / Branch moduli", fmt::format("{}", fmt::join(moduli, ", "))},
               {"Elastomer / Branch times", fmt::format("{}", fmt::join(times, ", "))}});
}

Entries with_section(const Entries& entries, const Entries& section) {
  const auto name = place_of(section.begin()->first).section;
  Entries rest = section;
  for (const auto& entry : entries)
    if (place_of(entry.first).section != name) rest.insert(entry);
  return rest;
}

}  // namespace fretval
