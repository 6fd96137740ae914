#include "mdr/profiles/two_sided_scan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

constexpr double largest_share = 0.05;    // of the range of heights
constexpr double largest_deviations = 6;  // of the noise
constexpr double same_radius = 1e-9;      // of the last radius

struct Half {
  std::vector<double> r, f;
};

Half half_of(const std::vector<double>& r, const std::vector<double>& f, double side) {
  Half half;
  for (std::size_t i = 0; i < r.size(); ++i)
    if (side * r[i] >= 0) {
      half.r.push_back(std::abs(r[i]));
      half.f.push_back(f[i]);
    }
  if (side < 0) {
    std::reverse(half.r.begin(), half.r.end());
    std::reverse(half.f.begin(), half.f.end());
  }
  if (half.r.size() < 2)
    reject("rows of a two-sided scan with " + std::string(side < 0 ? "r <= 0" : "r >= 0"),
           static_cast<double>(half.r.size()), "must be at least 2");
  return half;
}

// Within the first and the last radius.
double height_at(const Half& half, double r) {
  const auto above = std::upper_bound(half.r.begin() + 1, half.r.end() - 1, r);
  const auto k = static_cast<std::size_t>(above - half.r.begin());
  const double share = (r - half.r[k - 1]) / (half.r[k] - half.r[k - 1]);
  return half.f[k - 1] + share * (half.f[k] - half.f[k - 1]);
}

std::vector<double> radii_of_both(const Half& left, const Half& right) {
  const double begin = std::max(left.r.front(), right.r.front()), end = std::min(left.r.back(), right.r.back());
  if (!(begin < end))
    reject("first radius of one half of a two-sided scan", begin, "must be inside the last one of the other half");
  std::vector<double> all = left.r, radii;
  all.insert(all.end(), right.r.begin(), right.r.end());
  std::sort(all.begin(), all.end());
  for (const double r : all)
    if (r >= begin && r <= end && (radii.empty() || r - radii.back() > same_radius * end)) radii.push_back(r);
  return radii;
}

}  // namespace

double MeanOfHalves::range() const {
  const auto [lowest, highest] = std::minmax_element(f.begin(), f.end());
  return *highest - *lowest;
}

MeanOfHalves mean_of_halves(const std::vector<double>& r, const std::vector<double>& f) {
  const Half left = half_of(r, f, -1), right = half_of(r, f, 1);
  MeanOfHalves mean;
  mean.r = radii_of_both(left, right);
  for (const double radius : mean.r) {
    const double one = height_at(left, radius), other = height_at(right, radius);
    mean.f.push_back((one + other) / 2);
    if (std::abs(one - other) <= mean.largest_difference) continue;
    mean.largest_difference = std::abs(one - other);
    mean.radius_of_difference = radius;
  }
  return mean;
}

void require_axisymmetric(const MeanOfHalves& mean, double noise) {
  const double range = mean.range();
  if (mean.largest_difference <= largest_share * range + largest_deviations * noise) return;
  std::ostringstream message;
  message.precision(3);
  message << "the halves of the scan differ by " << mean.largest_difference << " m at r = " << mean.radius_of_difference
          << " m, " << 100 * mean.largest_difference / range << " % of the range of heights: must be at most "
          << 100 * largest_share << " % for an axisymmetric indenter; is r = 0 its apex?";
  throw std::invalid_argument(message.str());
}

}  // namespace fretval::mdr
