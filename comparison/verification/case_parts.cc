#include "comparison/verification/case_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "comparison/case_file/entry_lookup.h"

namespace fretval {
namespace {

/// A section with its deciding entry.
Entries section(const char* deciding, const std::string& choice, const std::map<std::string, double>& numbers) {
  return with_numbers({{deciding, choice}}, numbers);
}

}  // namespace

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
