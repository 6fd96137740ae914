#include "mdr/motion/record_reduction.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

using Values = std::vector<double>;

/// Means of so many neighbours, with what is left over in the last one.
Values means_of(const Values& values, std::size_t n) {
  Values means;
  for (std::size_t begin = 0; begin < values.size(); begin += n) {
    const std::size_t end = std::min(begin + n, values.size());
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += values[i];
    means.push_back(sum / static_cast<double>(end - begin));
  }
  if (values.size() % n != 0 && means.size() > 2) means.pop_back();  // noisier than the others
  return means;
}

/// What means of neighbours take off a smooth course, a 24th of the second difference, and the broken line between them
/// an eighth.
double smoothing_of(const Values& means) {
  double largest = 0;
  for (std::size_t i = 1; i + 1 < means.size(); ++i)
    largest = std::max(largest, std::abs(means[i - 1] - 2 * means[i] + means[i + 1]));
  return largest / 6;
}

struct Averaging {
  std::size_t n = 1;                  ///< rows to a mean
  double normal = 0, tangential = 0;  ///< errors of a mean
};

constexpr double deviations = 4;  // that hardly a mean among thousands exceeds
constexpr std::size_t least_means = 64;

Averaging averaging_of(const Record& record, double normal_tolerance, double tangential_tolerance) {
  const double normal_noise = white_noise_of(record.normal), tangential_noise = white_noise_of(record.tangential);
  const auto errors_at = [&](std::size_t n) {
    const double share = deviations / std::sqrt(static_cast<double>(n));
    return Averaging{n, share * normal_noise + smoothing_of(means_of(record.normal, n)),
                     share * tangential_noise + smoothing_of(means_of(record.tangential, n))};
  };
  if (deviations * normal_noise <= normal_tolerance && deviations * tangential_noise <= tangential_tolerance) return {};
  Averaging best;
  double least = INFINITY;
  for (std::size_t n = 2; record.time.size() / n >= least_means; n *= 2) {
    const auto one = errors_at(n);
    const double worst = std::max(one.normal / normal_tolerance, one.tangential / tangential_tolerance);
    if (worst >= least) continue;
    least = worst;
    best = one;
  }
  return best;
}

/// How far a row is from the chord of two others, over the tolerances.
struct Distance {
  const Record& record;
  double normal_tolerance, tangential_tolerance;

  double operator()(std::size_t i, std::size_t begin, std::size_t end) const {
    const double share = (record.time[i] - record.time[begin]) / (record.time[end] - record.time[begin]);
    const auto off = [&](const Values& values) {
      return std::abs(values[i] - values[begin] - share * (values[end] - values[begin]));
    };
    return std::max(off(record.normal) / normal_tolerance, off(record.tangential) / tangential_tolerance);
  }
};

/// Keeps the rows between two that are kept.
void keep_between(std::size_t first, std::size_t last, const Distance& distance, std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    std::size_t farthest = begin;
    double largest = 1;
    for (std::size_t i = begin + 1; i < end; ++i)
      if (const double one = distance(i, begin, end); one > largest) {
        largest = one;
        farthest = i;
      }
    if (farthest == begin) continue;
    kept[farthest] = true;
    open.emplace_back(begin, farthest);
    open.emplace_back(farthest, end);
  }
}

/// extremes: whether those of the signals are kept in any case; among noisy means they are chance.
std::vector<std::size_t> kept_rows(const Record& record, const Distance& distance, bool extremes) {
  const std::size_t n = record.time.size();
  std::vector<bool> kept(n);
  kept.front() = kept.back() = true;
  for (const auto* values : {&record.normal, &record.tangential}) {
    if (!extremes) break;
    const auto [least, most] = std::minmax_element(values->begin(), values->end());
    kept[static_cast<std::size_t>(least - values->begin())] = true;
    kept[static_cast<std::size_t>(most - values->begin())] = true;
  }
  std::vector<std::size_t> fixed;
  for (std::size_t i = 0; i < n; ++i)
    if (kept[i]) fixed.push_back(i);
  for (std::size_t k = 0; k + 1 < fixed.size(); ++k) keep_between(fixed[k], fixed[k + 1], distance, kept);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < n; ++i)
    if (kept[i]) rows.push_back(i);
  return rows;
}

double on_line(const Values& time, const Values& values, std::size_t piece, double t) {
  const double share = (t - time[piece]) / (time[piece + 1] - time[piece]);
  return values[piece] + share * (values[piece + 1] - values[piece]);
}

/// Values at the knots of the broken line that is closest to all rows: a tridiagonal system.
Values closest_line(const Values& time, const Values& values, const Values& knots) {
  const std::size_t n = knots.size();
  Values diagonal(n), beside(n), right(n);
  std::size_t piece = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    while (piece + 2 < n && time[i] > knots[piece + 1]) ++piece;
    const double share = (time[i] - knots[piece]) / (knots[piece + 1] - knots[piece]);
    diagonal[piece] += (1 - share) * (1 - share);
    diagonal[piece + 1] += share * share;
    beside[piece] += share * (1 - share);
    right[piece] += (1 - share) * values[i];
    right[piece + 1] += share * values[i];
  }
  for (std::size_t k = 1; k < n; ++k) {
    const double factor = beside[k - 1] / diagonal[k - 1];
    diagonal[k] -= factor * beside[k - 1];
    right[k] -= factor * right[k - 1];
  }
  right[n - 1] /= diagonal[n - 1];
  for (std::size_t k = n - 1; k-- > 0;) right[k] = (right[k] - beside[k] * right[k + 1]) / diagonal[k];
  return right;
}

/// Largest standard deviation of a value at a knot, over that of the rows: the diagonal of the inverse of that matrix,
/// from its pivots from either end.
double deviation_at_knots(const Values& time, const Values& knots) {
  const std::size_t n = knots.size();
  Values diagonal(n), beside(n);
  std::size_t piece = 0;
  for (const double t : time) {
    while (piece + 2 < n && t > knots[piece + 1]) ++piece;
    const double share = (t - knots[piece]) / (knots[piece + 1] - knots[piece]);
    diagonal[piece] += (1 - share) * (1 - share);
    diagonal[piece + 1] += share * share;
    beside[piece] += share * (1 - share);
  }
  Values forward = diagonal, backward = diagonal;
  for (std::size_t k = 1; k < n; ++k) forward[k] -= beside[k - 1] * beside[k - 1] / forward[k - 1];
  for (std::size_t k = n - 1; k-- > 0;) backward[k] -= beside[k] * beside[k] / backward[k + 1];
  double largest = 0;
  for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, 1 / (forward[k] + backward[k] - diagonal[k]));
  return std::sqrt(largest);
}

/// Largest distance of the rows, or of means of n of them, from a broken line.
double distance_from_line(const Values& time, const Values& values, const Values& knots, const Values& heights,
                          std::size_t n) {
  Values off(time.size());
  std::size_t piece = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    while (piece + 2 < knots.size() && time[i] > knots[piece + 1]) ++piece;
    off[i] = values[i] - on_line(knots, heights, piece, time[i]);
  }
  double largest = 0;
  for (const double mean : means_of(off, n)) largest = std::max(largest, std::abs(mean));
  return largest;
}

}  // namespace

double white_noise_of(const Values& values) {
  if (values.size() < 3) return 0;
  Values differences;
  for (std::size_t i = 1; i + 1 < values.size(); ++i)
    differences.push_back(std::abs(values[i - 1] - 2 * values[i] + values[i + 1]));
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  const double median_of_normal = 0.67449, weights = std::sqrt(6.0);  // of 1, -2, 1
  return *middle / (median_of_normal * weights);
}

ReducedRecord reduced(const Record& record, double normal_tolerance, double tangential_tolerance, std::size_t n_most) {
  require_positive("tolerance of the normal signal", normal_tolerance);
  require_positive("tolerance of the tangential signal", tangential_tolerance);
  if (record.time.size() < 2) reject("rows of a record", static_cast<double>(record.time.size()), "must be at least 2");
  if (n_most < 4) reject("rows of a reduced record", static_cast<double>(n_most), "must be at least 4");
  const auto averaging = averaging_of(record, normal_tolerance, tangential_tolerance);
  Record means = record;
  if (averaging.n > 1)
    means = {means_of(record.time, averaging.n), means_of(record.normal, averaging.n),
             means_of(record.tangential, averaging.n)};
  double normal = std::max(normal_tolerance, averaging.normal),
         tangential = std::max(tangential_tolerance, averaging.tangential);
  auto rows = kept_rows(means, {means, normal, tangential}, averaging.n == 1);
  // The tolerance alone cannot leave less than both ends and the extremes, which are six.
  while (rows.size() > std::max<std::size_t>(n_most, 6)) {
    normal *= 2;
    tangential *= 2;
    rows = kept_rows(means, {means, normal, tangential}, averaging.n == 1);
  }
  ReducedRecord result{};
  for (const std::size_t row : rows) {
    result.record.time.push_back(means.time[row]);
    result.record.normal.push_back(means.normal[row]);
    result.record.tangential.push_back(means.tangential[row]);
  }
  auto& [time, normal_values, tangential_values] = result.record;
  if (averaging.n > 1) {
    time.front() = record.time.front();
    time.back() = record.time.back();
    normal_values = closest_line(record.time, record.normal, time);
    tangential_values = closest_line(record.time, record.tangential, time);
  }
  // Means of fewer rows than a piece has are compared with the line, so that what the line misses does not average out.
  const std::size_t n_seen = std::max<std::size_t>(1, averaging.n / 4);
  result.normal_error = distance_from_line(record.time, record.normal, time, normal_values, n_seen);
  result.tangential_error = distance_from_line(record.time, record.tangential, time, tangential_values, n_seen);
  if (averaging.n > 1) {
    constexpr double of_hundreds = 3;  // deviations, that hardly one among hundreds exceeds
    const double deviation = of_hundreds * deviation_at_knots(record.time, time);
    result.normal_error += deviation * white_noise_of(record.normal);
    result.tangential_error += deviation * white_noise_of(record.tangential);
  }
  return result;
}

}  // namespace fretval::mdr
