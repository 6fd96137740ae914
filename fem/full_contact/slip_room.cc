#include "fem/full_contact/slip_room.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fretval::fem {
namespace {

constexpr int n_halvings = 38;  // golden sections: 0.618^38 = 1e-8

/// The least value of a convex function between two places.
template <class Function>
double least(const Function& f, double low, double high) {
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  double left = high - ratio * (high - low), right = low + ratio * (high - low);
  double at_left = f(left), at_right = f(right);
  for (int i = 0; i < n_halvings && high > low; ++i) {
    if (at_left < at_right) {
      high = std::exchange(right, left);
      at_right = at_left;
      at_left = f(left = high - ratio * (high - low));
    } else {
      low = std::exchange(left, right);
      at_left = at_right;
      at_right = f(right = low + ratio * (high - low));
    }
  }
  return std::min(at_left, at_right);
}

}  // namespace

double slip_room(const Eigen::VectorXd& x, const Eigen::VectorXd& y, const Eigen::VectorXd& limit) {
  const auto excess = [&](double at_x, double at_y) {
    return (((x.array() - at_x).square() + (y.array() - at_y).square()).sqrt() - limit.array()).maxCoeff();
  };
  const auto least_along_y = [&](double at_x) {
    return least([&](double at_y) { return excess(at_x, at_y); }, y.minCoeff(), y.maxCoeff());
  };
  return -least(least_along_y, x.minCoeff(), x.maxCoeff());
}

}  // namespace fretval::fem
