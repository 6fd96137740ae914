#include "comparison/accuracy/distance_to_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fretval {
namespace {

using Point = Eigen::Vector2d;

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double length = along.squaredNorm();
  const double share = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
  return (p - a - share * along).norm();
}

/// The curve as a chain of points, denser and denser towards the stick radius, where it rises like a root.
std::vector<Point> curve_of(const mdr::LimitingProfile& limit, double contact_radius, double end) {
  constexpr int n = 1000;
  std::vector<Point> curve;
  const auto add = [&](double r) {
    curve.emplace_back(r / contact_radius, mdr::shape(limit, r) / limit.maximum_indentation);
  };
  const double c = limit.stick_radius, a = limit.outer_radius;
  for (int i = 0; i < n; ++i) add(c * i / n);
  for (int i = 0; i < n; ++i) add(c + (a - c) * i * i / (1.0 * n * n));
  for (int i = 0; i <= n; ++i) add(a + std::max(end - a, 0.0) * i / n);
  return curve;
}

}  // namespace

double distance_to_limit(const mdr::LimitingProfile& limit, double contact_radius, const Eigen::VectorXd& r,
                         const Eigen::VectorXd& f) {
  const auto curve = curve_of(limit, contact_radius, r.maxCoeff());
  double largest = 0;
  for (Eigen::Index i = 0; i < r.size(); ++i) {
    const Point point(r[i] / contact_radius, f[i] / limit.maximum_indentation);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < curve.size(); ++k)
      nearest = std::min(nearest, distance_to_segment(point, curve[k - 1], curve[k]));
    largest = std::max(largest, nearest);
  }
  return largest;
}

}  // namespace fretval
