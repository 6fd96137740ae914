#include "comparison/simulation/fem_case/profile_in_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/support/constants.h"

namespace fretval {

std::function<double(double)> profile_in(const Units& units, const Case::Indenter& indenter,
                                         const mdr::Profile& unworn) {
  const double length = units.length, depth = units.depth;
  // Written out rather than taken from mdr/, so that an error there cannot cancel in the comparison.
  switch (indenter.shape) {
    case Case::Shape::parabola:
      return [factor = length * length / (2 * indenter.radius * depth)](double r) { return factor * r * r; };
    case Case::Shape::sphere:
      return [share = length / indenter.radius, radius = indenter.radius / depth](double r) {
        const double sine = std::min(share * r, 1.0);  // beyond its equator a sphere has no surface
        return radius * sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
      };
    case Case::Shape::cone:
      return [factor = std::tan(indenter.slope_angle * degree) * length / depth](double r) { return factor * r; };
    case Case::Shape::power:
      return [factor = indenter.coefficient * std::pow(length, indenter.exponent) / depth,
              n = indenter.exponent](double r) { return factor * std::pow(r, n); };
    case Case::Shape::rounded_flat:
      return [factor = length * length / (2 * indenter.edge_radius * depth), flat = indenter.flat_radius / length](
                 double r) { return r > flat ? factor * (r - flat) * (r - flat) : 0; };
    case Case::Shape::truncated_sphere:
      return [factor = length * length / (2 * indenter.radius * depth), flat = indenter.flat_radius / length](
                 double r) { return r > flat ? factor * (r - flat) * (r + flat) : 0; };
    case Case::Shape::table:
      break;
  }
  // The heights between measured points are data; what MDR adds is their transform. Beyond the rows nothing touches.
  const double end =
      mdr::falls_of_image(unworn).empty() ? std::numeric_limits<double>::infinity() : mdr::end_radius(unworn);
  return [unworn, length, depth, end](double r) { return mdr::shape(unworn, std::min(r * length, end)) / depth; };
}

std::function<double(double)> profile_in(const Units& units, const LimitingIndenter& limiting) {
  return [height = limiting.height, length = units.length, depth = units.depth](double r) {
    return height(r * length) / depth;
  };
}

double farthest_depth(const Case& input, const mdr::Profile& profile, double depth) {
  constexpr int n_parts = 20000;
  const double end = mdr::end_radius(profile);
  const auto is_deep = [&](int i) { return mdr::shape(profile, end * i / n_parts) <= depth; };
  if (is_deep(n_parts))
    throw InputError(fmt::format(
        "{}: Indenter / Table = {}: its last row, at r = {:g} m, is {:g} m above the lowest one, and the largest "
        "indentation is {:g} m; expected rows up to a radius at which the indenter is higher than that",
        input.file, input.indenter.table, end, mdr::shape(profile, end), depth));
  int last = n_parts - 1;
  while (last > 0 && !is_deep(last)) --last;
  return end * (last + 1) / n_parts;
}

}  // namespace fretval
