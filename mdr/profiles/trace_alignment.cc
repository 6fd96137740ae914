#include "mdr/profiles/trace_alignment.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Values = std::vector<double>;

constexpr std::size_t least_trace_rows = 32;
constexpr Index most_splines = 40;
constexpr double least_side = 0.125;  // of the length of the trace
constexpr double end_margin = 1e-3;   // likewise
constexpr double usual_tilt = 2 * pi / 180;

/// Values of the four cubic B-splines that are not zero at a place between two knots one apart.
std::array<double, 4> splines_at(double share) {
  const double a = share, b = 1 - share;
  return {b * b * b / 6, (4 - 6 * a * a + 3 * a * a * a) / 6, (4 - 6 * b * b + 3 * b * b * b) / 6, a * a * a / 6};
}

/// Slopes of the four cubic B-splines of splines_at(), per piece.
std::array<double, 4> slopes_at(double share) {
  const double a = share, b = 1 - share;
  return {-b * b / 2, -2 * a + 1.5 * a * a, 2 * b - 1.5 * b * b, a * a / 2};
}

/// What is left of the heights by the best even course and tilt for an apex.
struct EvenFit {
  double sum_of_squares, n_free;  ///< n_free: rows less parameters
  double tilt, tilt_variance;     ///< variance over that of the heights
  VectorXd course;                ///< coefficients of the splines
  double reach;                   ///< m, that the splines share
  MatrixXd covariance;            ///< of the coefficients, over the variance of the heights
};

/// Distance from the apex to which both sides of the trace reach.
double common_reach(const Values& x, double apex) {
  return std::min(apex - x.front(), x.back() - apex);
}

/// prior: what the square of a tilt over that of the usual one counts, a variance of heights.
EvenFit even_fit(const Values& x, const Values& z, double apex, double prior) {
  const auto n_all = static_cast<Index>(x.size());
  const Index n = std::min(most_splines, std::max<Index>(8, n_all / 8)), n_pieces = n - 3;
  MatrixXd normal = MatrixXd::Zero(n + 1, n + 1);
  VectorXd right = VectorXd::Zero(n + 1);
  double squares = 0;
  // The splines reach to the end of the longer side: rows without a counterpart on the other side tell nothing, but so
  // the same rows count for every apex.
  const double reach = std::max(apex - x.front(), x.back() - apex) * (1 + 1e-12);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = (x[i] - apex) / reach;
    const double place = std::abs(u) * static_cast<double>(n_pieces);
    const auto piece = std::min(static_cast<Index>(place), n_pieces - 1);
    const auto values = splines_at(place - static_cast<double>(piece));
    for (Index a = 0; a < 4; ++a) {
      const double value = values[static_cast<std::size_t>(a)];
      for (Index b = 0; b <= a; ++b) normal(piece + a, piece + b) += value * values[static_cast<std::size_t>(b)];
      normal(n, piece + a) += u * value;
      right(piece + a) += value * z[i];
    }
    normal(n, n) += u * u;
    right(n) += u * z[i];
    squares += z[i] * z[i];
  }
  const double usual = usual_tilt * reach;  // tilt of the scaled coordinate
  normal(n, n) += prior / (usual * usual);
  // Parts of the course between rows that are far apart have nothing to hold them.
  normal.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff();
  const Eigen::LDLT<MatrixXd> factor(normal.selfadjointView<Eigen::Lower>());
  const VectorXd solution = factor.solve(right);
  VectorXd unit = VectorXd::Zero(n + 1);
  unit(n) = 1;
  return {std::max(squares - right.dot(solution), 0.0),
          std::max(static_cast<double>(n_all - n - 2), 1.0),
          solution(n) / reach,
          factor.solve(unit)(n) / (reach * reach),
          solution.head(n),
          reach,
          factor.solve(MatrixXd::Identity(n + 1, n + 1)).topLeftCorner(n, n)};
}

/// Closest parabola: curvature and the place of its vertex.
std::pair<double, double> parabola_through(const Values& x, const Values& z) {
  const double middle = (x.front() + x.back()) / 2, half = (x.back() - x.front()) / 2;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = (x[i] - middle) / half;
    const Eigen::Vector3d row(1, u, u * u);
    normal += row * row.transpose();
    right += row * z[i];
  }
  const Eigen::Vector3d c = normal.ldlt().solve(right);
  return {c(2), middle - half * c(1) / (2 * c(2))};
}

void require_trace(const Values& x, const Values& z) {
  if (x.size() != z.size() || x.size() < least_trace_rows)
    reject("rows of a trace", static_cast<double>(std::min(x.size(), z.size())),
           "must be at least " + std::to_string(least_trace_rows) + ", of places and heights");
  for (std::size_t i = 0; i < x.size(); ++i) {
    require_finite("height of the trace", z[i]);
    if (i > 0 && !(x[i] > x[i - 1])) reject("place in the trace", x[i], "must be greater than the one before");
  }
}

/// The variance that roundoff makes in the sums of squares, so that a trace without noise has a scale.
double least_variance(const Values& z) {
  const auto [least, most] = std::minmax_element(z.begin(), z.end());
  return std::pow(1e-7 * (*most - *least), 2);
}

Values less_mean(Values z) {
  double mean = 0;
  for (const double value : z) mean += value / static_cast<double>(z.size());
  for (double& value : z) value -= mean;
  return z;
}

/// Standard deviation of the apex: the noise over what is left, without the part that a tilt takes, of how the heights
/// change with it, h'(|u|) sign(u). What noise alone makes of h' tells nothing. A tilt by which the apex may be off has
/// the usual size at most.
double apex_deviation(const Values& x, double apex, const EvenFit& fit, double variance) {
  const auto n_pieces = static_cast<double>(fit.course.size() - 3);
  double squares = 0, of_tilt = 0, squares_of_places = 0, by_noise = 0;
  for (const double place : x) {
    if (std::abs(place - apex) > common_reach(x, apex)) continue;  // without a counterpart a row tells nothing
    const double u = place - apex, at = std::abs(u) / fit.reach * n_pieces;
    const auto piece = std::min(static_cast<Index>(at), fit.course.size() - 4);
    const auto slopes = slopes_at(at - static_cast<double>(piece));
    const Eigen::Vector4d weights = n_pieces / fit.reach * Eigen::Map<const Eigen::Vector4d>(slopes.data());
    const double change = (u < 0 ? -1 : 1) * weights.dot(fit.course.segment<4>(piece));
    squares += change * change;
    of_tilt += change * u;
    squares_of_places += u * u;
    by_noise += variance * weights.dot(fit.covariance.block<4, 4>(piece, piece) * weights);
  }
  const double tilt_of_apex = of_tilt / squares_of_places;
  const double by_course = std::max(squares - of_tilt * tilt_of_apex - 2 * by_noise, 0.0);
  // The noise of the course adds to that of the heights.
  const double told = by_course > 0 ? by_course / variance / (1 + by_noise / by_course) : 0;
  return 1 / std::sqrt(told + std::pow(tilt_of_apex / usual_tilt, 2) + 1 / (squares_of_places));
}

/// Sum of squares of the residuals as a function of the apex.
struct Misfit {
  const Values& x;
  const Values& z;
  double prior;

  double operator()(double apex) const { return even_fit(x, z, apex, prior).sum_of_squares; }
};

}  // namespace

TraceAlignment align_trace(const Values& x, const Values& heights) {
  require_trace(x, heights);
  const auto z = less_mean(heights);
  const double length = x.back() - x.front(), margin = least_side * length;
  const auto [curvature, vertex] = parabola_through(x, z);
  const double first = x.front() + margin, last = x.back() - margin;
  const double guess = std::clamp(vertex, first, last);
  double prior = least_variance(z);
  TraceAlignment alignment{guess, 0, 0, 0, 0, curvature < 0};
  // The noise, which weighs what is known of tilts, is that of the fit before.
  for (int round = 0; round < 3; ++round) {
    const Misfit misfit{x, z, prior};
    constexpr int n_places = 64;
    double best = alignment.apex, least = misfit(best);
    const double width = round == 0 ? length / 8 : length / 64;
    const double begin = std::max(first, best - width), end = std::min(last, best + width);
    for (int k = 0; k <= n_places; ++k) {
      const double place = begin + (end - begin) * k / n_places, value = misfit(place);
      if (value < least) {
        least = value;
        best = place;
      }
    }
    const double step = (end - begin) / n_places;
    std::uintmax_t n_most = 60;
    alignment.apex = boost::math::tools::brent_find_minima(misfit, std::max(first, best - step),
                                                           std::min(last, best + step), 40, n_most)
                         .first;
    const auto fit = even_fit(x, z, alignment.apex, prior);
    prior = std::max(fit.sum_of_squares / fit.n_free, least_variance(z));
  }
  if (alignment.apex <= first + end_margin * length || alignment.apex >= last - end_margin * length)
    reject("apex of the trace in m", alignment.apex,
           "must be inside it, with at least an eighth of its length on either side");
  const auto fit = even_fit(x, z, alignment.apex, prior);
  alignment.tilt = fit.tilt;
  alignment.noise = std::sqrt(prior);
  alignment.apex_uncertainty = apex_deviation(x, alignment.apex, fit, prior);
  const double off = std::min({alignment.apex_uncertainty, alignment.apex - first, last - alignment.apex});
  const double before = even_fit(x, z, alignment.apex - off, prior).tilt,
               after = even_fit(x, z, alignment.apex + off, prior).tilt;
  alignment.tilt_uncertainty = std::hypot((after - before) / 2 * alignment.apex_uncertainty / off,
                                          std::sqrt(prior * std::max(fit.tilt_variance, 0.0)));
  return alignment;
}

std::array<TraceAlignment, 2> neighbours_of(const TraceAlignment& alignment, const Values& x, const Values& heights) {
  const auto z = less_mean(heights);
  const auto at = [&](double apex) {
    auto other = alignment;
    other.apex = apex;
    other.tilt = even_fit(x, z, apex, alignment.noise * alignment.noise).tilt;
    return other;
  };
  const double length = x.back() - x.front();
  return {at(std::max(alignment.apex - alignment.apex_uncertainty, x.front() + least_side * length)),
          at(std::min(alignment.apex + alignment.apex_uncertainty, x.back() - least_side * length))};
}

AlignedProfile aligned_profile(const TraceAlignment& alignment, const Values& x, const Values& z) {
  const double reach = common_reach(x, alignment.apex), sign = alignment.heights_upwards ? -1 : 1;
  std::vector<std::pair<double, double>> rows;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = x[i] - alignment.apex;
    if (std::abs(u) <= reach) rows.emplace_back(std::abs(u), sign * (z[i] - alignment.tilt * u));
  }
  std::sort(rows.begin(), rows.end());
  // More would show a tip that noise has sharpened.
  constexpr std::size_t most_rows = 200;
  const std::size_t n = std::max<std::size_t>(2, rows.size() / most_rows);
  AlignedProfile profile{{}, {}, alignment.noise / std::sqrt(static_cast<double>(n))};
  for (std::size_t begin = 0; begin + n <= rows.size(); begin += n) {
    double r = 0, f = 0;
    for (std::size_t i = begin; i < begin + n; ++i) {
      r += rows[i].first / static_cast<double>(n);
      f += rows[i].second / static_cast<double>(n);
    }
    if (!profile.r.empty() && !(r > profile.r.back())) continue;
    profile.r.push_back(r);
    profile.f.push_back(f);
  }
  const double lowest = *std::min_element(profile.f.begin(), profile.f.end());
  for (double& f : profile.f) f -= lowest;
  return profile;
}

}  // namespace fretval::mdr
