#include "comparison/accuracy/distance_to_limit.h"

#include <algorithm>
#include <limits>

namespace fretval {
namespace {

using Point = Eigen::Vector2d;

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double length = along.squaredNorm();
  const double share = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
  return (p - a - share * along).norm();
}

/// Distance of a point from a chain: segments are looked at outwards from the one beside the point, as long as they may
/// be nearer than the nearest so far.
double distance_to_chain(const Point& p, const ProfileChain& chain) {
  const auto right =
      std::lower_bound(chain.begin(), chain.end(), p.x(), [](const Point& vertex, double r) { return vertex.x() < r; });
  double nearest = std::numeric_limits<double>::infinity();
  for (auto b = std::max(right, chain.begin() + 1); b != chain.end() && (b - 1)->x() - p.x() < nearest; ++b)
    nearest = std::min(nearest, distance_to_segment(p, *(b - 1), *b));
  for (auto b = right; b > chain.begin() + 1 && p.x() - (b - 1)->x() < nearest; --b)
    nearest = std::min(nearest, distance_to_segment(p, *(b - 2), *(b - 1)));
  return nearest;
}

}  // namespace

/// The points get denser towards the stick radius, where the worn depth rises like a root.
ProfileChain chain_of(const WearLimit& limit, double contact_radius, double end) {
  constexpr int n = 1000;
  ProfileChain chain;
  const auto add = [&](double r) {
    chain.emplace_back(r / contact_radius, limit.height(r) / limit.maximum_indentation);
  };
  const double c = limit.stick_radius, a = limit.outer_radius;
  for (int i = 0; i < n; ++i) add(c * i / n);
  for (int i = 0; i < n; ++i) add(c + (a - c) * i * i / (1.0 * n * n));
  for (int i = 0; i <= n; ++i) add(a + std::max(end - a, 0.0) * i / n);
  return chain;
}

double distance_between(const ProfileChain& points, const ProfileChain& chain) {
  double largest = 0;
  for (const auto& point : points) largest = std::max(largest, distance_to_chain(point, chain));
  return largest;
}

}  // namespace fretval
