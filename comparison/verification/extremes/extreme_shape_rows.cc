#include <fmt/format.h>

#include <cmath>

#include "comparison/verification/extremes/extreme_rows.h"

namespace fretval {
namespace {

constexpr double indentation = 1e-4, radius = 1e-3;  // m

Entries no_shape() {
  return with(extremes_base(), {{"Indenter / Radius", ""}});
}

/// f = indentation (r/radius)^n
Entries power(double exponent) {
  return with(no_shape(), {{"Indenter / Shape", "power"},
                           {"Indenter / Exponent", entry_text(exponent)},
                           {"Indenter / Coefficient", entry_text(indentation / std::pow(radius, exponent))}});
}

Entries cone(double degrees) {
  return with(no_shape(), {{"Indenter / Shape", "cone"}, {"Indenter / Slope angle", entry_text(degrees)}});
}

/// A contact of about the radius, flat up to the given share of it.
Entries rounded_flat(double flat_share) {
  const double flat = flat_share * radius, rest = radius - flat;
  return with(no_shape(), {{"Indenter / Shape", "rounded flat"},
                           {"Indenter / Flat radius", entry_text(flat)},
                           {"Indenter / Edge radius", entry_text(rest * radius / (2 * indentation))}});
}

Entries truncated_sphere(double flat_share) {
  return with(extremes_base(),
              {{"Indenter / Shape", "truncated sphere"}, {"Indenter / Flat radius", entry_text(flat_share * radius)}});
}

Entries table(const char* file) {
  return with(no_shape(), {{"Indenter / Shape", "table"}, {"Indenter / Table", extremes_table(file)}});
}

Entries limiting(double stick_ratio) {
  return with(extremes_base(), {{"Wear / State", "limiting"},
                                {"Wear / Stick radius ratio", entry_text(stick_ratio)},
                                {"Motion / Normal amplitude", "1e-7"},
                                {"Motion / Tangential amplitude", "shakedown"}});
}

}  // namespace

std::vector<ExtremeRow> extreme_shape_rows() {
  std::vector<ExtremeRow> rows;
  // Half the amplitude of sliding: a stick radius of a given ratio may lie on the flat of a face.
  const auto add = [&](const char* family, const std::string& value, const Entries& entries) {
    rows.push_back({family, value, with_stick_ratio(with(entries, {{"Motion / Normal amplitude", "1e-5"}}), 0, 0.5)});
  };
  for (const double n : {0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0, 20.0})
    add("power law", fmt::format("n = {:g}", n), power(n));
  for (const double degrees : {1e-3, 1.0, 45.0, 89.0}) add("cone", fmt::format("{:g} deg", degrees), cone(degrees));
  for (const double share : {0.01, 0.5, 0.9, 0.99})
    add("flat with a rounded edge", fmt::format("b = {:g} mm", share), rounded_flat(share));
  for (const double share : {0.01, 0.3, 0.55})
    add("sphere with a flat", fmt::format("b = {:g} mm", share), truncated_sphere(share));
  add("measured profile", "flat face", table("flat-face.csv"));
  rows.push_back({"measured profile", "terrace", table("terrace.csv"), "convex"});
  for (const double ratio : {0.1, 0.5, 0.99})
    rows.push_back({"limiting profile", fmt::format("c/a = {:g}", ratio), limiting(ratio)});
  return rows;
}

}  // namespace fretval
