#include "mdr/profiles/profile_table.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "mdr/profiles/convex_fit.h"
#include "mdr/profiles/profile_rows.h"
#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

constexpr std::size_t n_least_rows = 4;
constexpr std::size_t least_image_nodes = 800;

// A table whose tip is horizontal within this share of its steepest slope is smooth there, not a cone.
constexpr double horizontal_tip = 1e-6;

// Roundoff of slopes that should be equal, over the slopes.
constexpr double bend_roundoff = 1e-12;

// Least share of an interval between rows over which a kink is rounded.
constexpr double least_bend = 1e-3;

// Roundoff of a sum over all rows, over the largest image slope.
constexpr double slope_roundoff = 1e-9;

void require_rise(double steepest) {
  if (!(steepest > 0)) reject("largest slope of the profile table", steepest, "must be positive");
}

// Whether f'' keeps its sign from 0 to h in the cubic with this secant and these slopes at the ends.
bool bends_one_way(double secant, double left, double right) {
  const double slack = bend_roundoff * (std::abs(left) + std::abs(right));
  return (2 * left + right) / 3 <= secant + slack && secant <= (left + 2 * right) / 3 + slack;
}

// Two parabolas instead of a cubic that would bend down between convex rows, as next to a kink. Source: Schumaker, SIAM
// Journal on Numerical Analysis 20 (1983) 853. On a straight line up to a kink no convex curve of one tangent meets the
// rows; there the bend takes a narrow share of the interval.
void add_parabolas(PiecewiseCubic& height, double h, double secant, double left, double right) {
  const double share = std::max(least_bend, std::min(secant - left, right - secant) / (right - left));
  const double first = secant - left < right - secant ? h * (1 - share) : h * share, second = h - first;
  const double middle = (2 * h * secant - first * left - second * right) / h;
  const double f = height.coefficients.back()[0], start = height.nodes.back();
  height.coefficients.back() = {f, left, (middle - left) / (2 * first), 0};
  height.nodes.push_back(start + first);
  height.coefficients.push_back({f + first * (left + middle) / 2, middle, (right - middle) / (2 * second), 0});
}

PiecewiseCubic height_through(const std::vector<double>& r, const std::vector<double>& f, double lowest) {
  std::vector<double> rows = f;
  for (double& h : rows) h -= lowest;
  std::vector<double> slopes = monotone_slopes(r, rows);
  const double steepest = *std::max_element(slopes.begin(), slopes.end());
  require_rise(steepest);
  if (std::abs(slopes[0]) < horizontal_tip * steepest) slopes[0] = 0;
  const PiecewiseCubic cubic = hermite_cubic(r, rows, slopes);
  PiecewiseCubic height;
  for (std::size_t k = 0; k + 1 < r.size(); ++k) {
    height.nodes.push_back(r[k]);
    height.coefficients.push_back(cubic.coefficients[k]);
    const double h = r[k + 1] - r[k], secant = (rows[k + 1] - rows[k]) / h;
    const bool convex_rows = slopes[k] <= secant && secant <= slopes[k + 1];
    if (convex_rows && !bends_one_way(secant, slopes[k], slopes[k + 1]))
      add_parabolas(height, h, secant, slopes[k], slopes[k + 1]);
  }
  height.nodes.push_back(r.back());
  return height;
}

// (r f')', with which g'(x) = int_0^x (r f')'/sqrt(x^2-r^2) dr.
PiecewiseCubic radial_slope(const PiecewiseCubic& height_slope) {
  PiecewiseCubic result{height_slope.nodes, {}};
  for (std::size_t k = 0; k < height_slope.coefficients.size(); ++k) {
    const auto& c = height_slope.coefficients[k];
    const double start = height_slope.nodes[k];
    result.coefficients.push_back({c[0] + start * c[1], 2 * (c[1] + start * c[2]), 3 * c[2], 0});
  }
  return result;
}

std::vector<double> refined(const std::vector<double>& nodes) {
  const std::size_t parts = 1 + least_image_nodes / nodes.size();
  std::vector<double> fine;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    for (std::size_t part = 0; part < parts; ++part) {
      const double share = static_cast<double>(part) / static_cast<double>(parts);
      fine.push_back(nodes[k] + share * (nodes[k + 1] - nodes[k]));
    }
  }
  fine.push_back(nodes.back());
  return fine;
}

std::vector<FallOfImage> falls_of(const std::vector<double>& x, const std::vector<double>& g,
                                  const std::vector<double>& slopes) {
  const double tolerance = slope_roundoff * *std::max_element(slopes.begin(), slopes.end());
  std::vector<FallOfImage> falls;
  bool fell = false;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const bool falls_to = k > 0 && g[k] < g[k - 1] - tolerance * (x[k] - x[k - 1]);
    const bool fall = slopes[k] < -tolerance || falls_to;
    if (fall && !fell) falls.push_back({falls_to ? x[k - 1] : x[k], x[k]});
    if (fall || (fell && g[k] < g[k - 1])) falls.back().to = x[k];
    fell = fall;
  }
  return falls;
}

void take_image(ProfileTable& table) {
  const PiecewiseCubic& height_slope = table.height_slope;
  const PiecewiseCubic radial = radial_slope(height_slope);
  const std::vector<double> x = refined(height_slope.nodes);
  const double on_axis = table.height.coefficients[0][0];  // of a hollow indenter; the image of a constant is itself
  std::vector<double> g{on_axis}, slopes{pi / 2 * height_slope.coefficients[0][0]};
  for (std::size_t k = 1; k < x.size(); ++k) {
    g.push_back(on_axis + x[k] * abel_integral_below(height_slope, 0, x[k], x[k]));
    slopes.push_back(abel_integral_below(radial, 0, x[k], x[k]));
  }
  table.falls = falls_of(x, g, slopes);
  table.image = hermite_cubic(x, g, slopes);
}

void require_finite_pieces(const PiecewiseCubic& cubic) {
  for (std::size_t k = 0; k < cubic.coefficients.size(); ++k)
    for (const double c : cubic.coefficients[k])
      if (!std::isfinite(c))
        reject("profile table at r in m", cubic.nodes[k],
               "the heights or their slopes are beyond the range of double; must be of the size of a profile");
}

ProfileTable table_of(const PiecewiseCubic& height) {
  require_finite_pieces(height);
  ProfileTable table;
  table.height = height;
  table.height_slope = derivative(table.height);
  take_image(table);
  require_finite_pieces(table.image);
  table.image_slope = derivative(table.image);
  return table;
}

ProfileTable rising(ProfileTable table) {
  if (!table.falls.empty())
    reject("profile table at r in m", table.falls.front().from,
           "the one-dimensional image g falls here, so the contact would not be a full circle, which MDR assumes; "
           "use a convex profile or remove the bump or dip");
  return table;
}

void require_table(const std::vector<double>& r, const std::vector<double>& f) {
  require_profile_rows(r, f, n_least_rows);
  if (r[0] != 0) reject("first radius of the profile table", r[0], "must be 0, the axis");
}

}  // namespace

ProfileTable profile_table(const std::vector<double>& r, const std::vector<double>& f, double noise) {
  require_non_negative("noise of the profile table in m", noise);
  if (noise > 0) {
    const ConvexFit fit = convex_fit(r, f, noise);
    require_rise(value(derivative(fit.height), fit.height.nodes.back()));
    return rising(table_of(fit.height));
  }
  require_table(r, f);
  return rising(table_of(height_through(r, f, f[0])));
}

ProfileTable profile_table_as_it_is(const std::vector<double>& r, const std::vector<double>& f) {
  require_table(r, f);
  return table_of(height_through(r, f, *std::min_element(f.begin(), f.end())));
}

double end_radius(const ProfileTable& profile) {
  return profile.height.nodes.back();
}

double shape(const ProfileTable& profile, double r) {
  return value(profile.height, r);
}

double shape_slope(const ProfileTable& profile, double r) {
  return value(profile.height_slope, r);
}

double transform(const ProfileTable& profile, double x) {
  return value(profile.image, std::abs(x));
}

double transform_slope(const ProfileTable& profile, double x) {
  return value(profile.image_slope, x);
}

double transform_integral(const ProfileTable& profile, double x) {
  return integral(profile.image, x);
}

double inverse_transform(const ProfileTable& profile, double depth) {
  const PiecewiseCubic& image = profile.image;
  // First node above the depth; a plateau of g belongs to the contact.
  const auto above = std::upper_bound(image.coefficients.begin(), image.coefficients.end(), depth,
                                      [](double d, const auto& piece) { return d < piece[0]; });
  const auto k = static_cast<std::size_t>(above - image.coefficients.begin());
  if (k == 0) return 0;
  const auto excess = [&](double x) { return value(image, x) - depth; };
  const double lower = image.nodes[k - 1], upper = image.nodes[k];
  if (excess(lower) >= 0) return lower;
  if (excess(upper) <= 0) return upper;
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(excess, lower, upper,
                                                         boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
}

double abel_slope_integral(const ProfileTable& profile, double r, double a) {
  return abel_integral_above(profile.image_slope, r, a);
}

double abel_depth_integral(const ProfileTable& profile, double lower, double upper, double r) {
  return abel_integral_below(profile.image, lower, upper, r);
}

}  // namespace fretval::mdr
