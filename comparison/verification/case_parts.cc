#include "comparison/verification/case_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace fretval {
namespace {

Entries indenter(const char* shape, const Entries& lengths) {
  return with({{"Indenter / Shape", shape}}, lengths);
}

Entries elastomer(const std::string& rheology, double modulus, const Entries& rest) {
  return with({{"Elastomer / Rheology", rheology}, {"Elastomer / Relaxed shear modulus", entry_text(modulus)}}, rest);
}

}  // namespace

Entries parabola(double radius) {
  return indenter("parabola", {{"Indenter / Radius", entry_text(radius)}});
}

Entries cone(double degrees) {
  return indenter("cone", {{"Indenter / Slope angle", entry_text(degrees)}});
}

Entries power(double exponent, double depth, double radius) {
  return indenter("power", {{"Indenter / Exponent", entry_text(exponent)},
                            {"Indenter / Coefficient", entry_text(depth / std::pow(radius, exponent))}});
}

Entries rounded_flat(double flat_radius, double edge_radius) {
  return indenter("rounded flat", {{"Indenter / Flat radius", entry_text(flat_radius)},
                                   {"Indenter / Edge radius", entry_text(edge_radius)}});
}

Entries truncated_sphere(double radius, double flat_radius) {
  return indenter("truncated sphere",
                  {{"Indenter / Radius", entry_text(radius)}, {"Indenter / Flat radius", entry_text(flat_radius)}});
}

Entries measured_profile(const std::string& file) {
  return indenter("table", {{"Indenter / Table", file}});
}

Entries elastic(double modulus) {
  return elastomer("elastic", modulus, {});
}

Entries kelvin_voigt(double modulus, double viscosity) {
  return elastomer("kelvin voigt", modulus, {{"Elastomer / Viscosity", entry_text(viscosity)}});
}

Entries branches(const std::string& rheology, double modulus, std::vector<double> moduli,
                 const std::vector<double>& times) {
  for (double& branch : moduli) branch *= modulus;
  return elastomer(rheology, modulus,
                   {{"Elastomer / Branch moduli", fmt::format("{}", fmt::join(moduli, ", "))},
                    {"Elastomer / Branch times", fmt::format("{}", fmt::join(times, ", "))}});
}

Entries with_section(const Entries& entries, const Entries& section) {
  const std::string& some = section.begin()->first;
  const std::string name = some.substr(0, some.find(" / "));
  Entries rest = section;
  for (const auto& entry : entries)
    if (entry.first.rfind(name + " / ", 0) != 0) rest.insert(entry);
  return rest;
}

}  // namespace fretval
