#include "fem/full_contact/slip_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace fretval::fem {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Vector2d;

struct Circle {
  Vector2d centre;
  double radius;
};

/// How far the outermost of some circles reaches from a place.
double reach(const std::vector<Circle>& circles, const Vector2d& place) {
  double farthest = 0;
  for (const auto& circle : circles) farthest = std::max(farthest, (circle.centre - place).norm() + circle.radius);
  return farthest;
}

/// The centre of the smallest circle that touches two others from outside. Not finite if they have one centre.
Vector2d centre_around(const Circle& a, const Circle& b) {
  const Vector2d way = b.centre - a.centre;
  const double distance = way.norm();
  return a.centre + (distance + b.radius - a.radius) / (2 * distance) * way;
}

/// The two places from which three circles reach equally far. With the first centre as origin and r the distance to it,
/// s_i . o = (s_i^2 - d_i^2)/2 - r d_i, d_i the first radius minus the other, is linear in r, and |o| = r is quadratic
/// (Apollonius). Not finite where there are none.
std::array<Vector2d, 2> centres_around(const Circle& a, const Circle& b, const Circle& c) {
  Matrix2d ways;
  ways << (b.centre - a.centre).transpose(), (c.centre - a.centre).transpose();
  const Vector2d less(a.radius - b.radius, a.radius - c.radius),
      squares = (ways.rowwise().squaredNorm() - less.cwiseAbs2()) / 2;
  const Matrix2d inverse = ways.inverse();
  const Vector2d at_zero = inverse * squares, slope = inverse * less;
  const double quadratic = slope.squaredNorm() - 1, half = at_zero.dot(slope), constant = at_zero.squaredNorm(),
               root = std::sqrt(half * half - quadratic * constant), larger = half + std::copysign(root, half);
  const auto place = [&](double r) -> Vector2d { return a.centre + at_zero - r * slope; };
  return {place(larger / quadratic), place(constant / larger)};
}

/// The circles that hold the smallest circle around some others, three at most, and its centre.
struct Basis {
  std::vector<Circle> holding;
  Vector2d centre;
  double radius = std::numeric_limits<double>::infinity();
};

/// Of the circles of a basis and one that reaches beyond it. The new one holds in any case.
Basis basis_with(const Basis& before, const Circle& beyond) {
  auto all = before.holding;
  all.push_back(beyond);
  Basis best;
  const auto consider = [&](const Vector2d& centre, std::vector<Circle> holding) {
    if (!centre.allFinite()) return;
    const double radius = reach(all, centre);
    if (radius < best.radius) best = {std::move(holding), centre, radius};
  };
  consider(beyond.centre, {beyond});
  for (auto a = before.holding.begin(); a != before.holding.end(); ++a) {
    consider(centre_around(beyond, *a), {beyond, *a});
    for (auto b = before.holding.begin(); b != a; ++b)
      for (const auto& centre : centres_around(beyond, *a, *b)) consider(centre, {beyond, *a, *b});
  }
  return best;
}

}  // namespace

double slip_room(const Eigen::VectorXd& x, const Eigen::VectorXd& y, const Eigen::VectorXd& limit) {
  const double most = limit.maxCoeff();
  Basis basis{{}, {x[0], y[0]}, -1};
  for (;;) {
    Index k = 0;
    const double farthest = (((x.array() - basis.centre[0]).square() + (y.array() - basis.centre[1]).square()).sqrt() +
                             most - limit.array())
                                .maxCoeff(&k);
    if (farthest <= basis.radius) return most - farthest;
    auto next = basis_with(basis, {{x[k], y[k]}, most - limit[k]});
    if (!(next.radius > basis.radius)) return most - farthest;  // roundoff
    basis = std::move(next);
  }
}

}  // namespace fretval::fem
