#include "mdr/stick/path_depths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mdr/support/checks.h"

namespace fretval::mdr {
namespace {

struct Piece {
  double begin, rate, duration;
};

std::vector<Piece> pieces_of(const SampledPath& path, PathDirection direction) {
  const bool normal = direction == PathDirection::normal;
  const auto& values = normal ? path.normal : path.tangential;
  const double rest = normal ? 0 : rest_of(path).tangential;
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < path.n_pieces(); ++k) {
    const double duration = path.time[k + 1] - path.time[k];
    pieces.push_back({values[k] - rest, (values[k + 1] - values[k]) / duration, duration});
  }
  return pieces;
}

/// h of a branch at the end of a piece.
double after(const Piece& piece, double modulus_ratio, double time, double before) {
  const double z = piece.duration / time;
  return std::exp(-z) * before - modulus_ratio * time * piece.rate * std::expm1(-z);
}

/// h of a branch at the first row.
double at_start(const std::vector<Piece>& pieces, const SampledPath& path, double modulus_ratio, double time) {
  if (!path.repeats) return 0;
  double left = 0;
  for (const auto& piece : pieces) left = after(piece, modulus_ratio, time, left);
  return -left / std::expm1(-path.duration() / time);
}

double largest_magnitude(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// factor T - N.
ExponentialSum demand(const ExponentialSum& tangential, double factor, const ExponentialSum& normal) {
  ExponentialSum sum = normal;
  sum.constant = factor * tangential.constant - normal.constant;
  sum.slope = factor * tangential.slope - normal.slope;
  for (std::size_t i = 0; i < sum.rates.size(); ++i)
    sum.coefficients[i] = factor * tangential.coefficients[i] - normal.coefficients[i];
  return sum;
}

}  // namespace

std::vector<ExponentialSum> path_response(const PronyBody& body, const SampledPath& path, PathDirection direction) {
  const auto pieces = pieces_of(path, direction);
  std::vector<ExponentialSum> sums;
  for (const auto& piece : pieces)
    sums.push_back({piece.begin + body.viscosity / body.relaxed_modulus * piece.rate, piece.rate, {}, {}});
  for (std::size_t i = 0; i < body.branch_times.size(); ++i) {
    const double time = body.branch_times[i], ratio = body.branch_moduli[i] / body.relaxed_modulus;
    double h = at_start(pieces, path, ratio, time);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const double steady = ratio * time * pieces[k].rate;
      sums[k].constant += steady;
      sums[k].coefficients.push_back(h - steady);
      sums[k].rates.push_back(1 / time);
      h = after(pieces[k], ratio, time, h);
    }
  }
  return sums;
}

PathDepths path_stick_depths(const PronyBody& body, double mu, const SampledPath& path) {
  constexpr double accuracy = 1e-12;
  validate(path);
  if (path.has_forces()) throw std::invalid_argument("stick depths along a path: it prescribes a force");
  require_positive("coefficient of friction", mu);
  const auto normal = path_response(body, path, PathDirection::normal),
             tangential = path_response(body, path, PathDirection::tangential);
  const double error = accuracy * largest_magnitude(path.normal), pull = 2 / (3 * mu);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double forward = -infinity, backward = -infinity;
  for (std::size_t k = 0; k < normal.size(); ++k) {
    const double duration = path.time[k + 1] - path.time[k];
    forward = std::max(forward, supremum(demand(tangential[k], pull, normal[k]), duration, error));
    backward = std::max(backward, supremum(demand(tangential[k], -pull, normal[k]), duration, error));
  }
  PathDepths depths{-std::max(forward, backward), {}};
  if (path.repeats) depths.shakedown = -(forward + backward) / 2;
  return depths;
}

StickRadii stick_radii(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path) {
  const auto depths = path_stick_depths(body, mu, path);
  const auto radius = [&](double depth) {
    return depth > 0 ? std::optional(inverse_transform(profile, depth)) : std::nullopt;
  };
  return {radius(depths.first_slip), depths.shakedown ? radius(*depths.shakedown) : std::nullopt};
}

}  // namespace fretval::mdr
