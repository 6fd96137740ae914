#include <fmt/format.h>

#include "comparison/verification/extremes/extreme_rows.h"

namespace fretval {
namespace {

constexpr double radius = 1e-3;  // m

/// A contact of about the radius, flat up to the given share of it.
Entries flat_up_to(double flat_share) {
  const double flat = flat_share * radius, rest = radius - flat;
  return rounded_flat(flat, rest * radius / (2 * usual_indentation));
}

Entries measured(const char* file) {
  return measured_profile(std::string(FRETVAL_EXTREMES_CASES) + "/" + file);
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
  const auto add = [&](const char* family, const std::string& value, const Entries& indenter) {
    const auto entries = with_section(with(extremes_base(), {{"Motion / Normal amplitude", "1e-5"}}), indenter);
    rows.push_back({family, value, with_stick_ratio(entries, 0, 0.5)});
  };
  for (const double n : {0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0, 20.0})
    add("power law", fmt::format("n = {:g}", n), power(n, usual_indentation, radius));
  for (const double degrees : {1e-3, 1.0, 45.0, 89.0}) add("cone", fmt::format("{:g} deg", degrees), cone(degrees));
  for (const double share : {0.01, 0.5, 0.9, 0.99})
    add("flat with a rounded edge", fmt::format("b = {:g} mm", share), flat_up_to(share));
  for (const double share : {0.01, 0.3, 0.55})
    add("sphere with a flat", fmt::format("b = {:g} mm", share), truncated_sphere(1e-2, share * radius));
  add("measured profile", "flat face", measured("flat-face.csv"));
  rows.push_back({"measured profile", "terrace", with_section(extremes_base(), measured("terrace.csv")), "convex"});
  for (const double ratio : {0.1, 0.5, 0.99})
    rows.push_back({"limiting profile", fmt::format("c/a = {:g}", ratio), limiting(ratio)});
  return rows;
}

}  // namespace fretval
