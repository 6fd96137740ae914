#include "mdr/plane/plane_balance.h"

#include <Eigen/LU>
#include <stdexcept>

namespace fretval::mdr {
namespace {

using Eigen::ArrayXd;
using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double no_load = 1e-300;

/// The load that the springs bear, and its derivative by u.
struct Borne {
  Vector2d sum;
  Matrix2d stiffness;
};

/// A spring that slips gives way along its load, and turns the rest: most/|z| (I - z z^T/|z|^2) in the place of I.
Borne borne_at(const Vector2d& u, const PlaneLines& lines) {
  const ArrayXd x = lines.x + lines.stiffness * u[0], y = lines.y + lines.stiffness * u[1],
                kept = shares_within(lines.most, x, y),
                turning = (kept < 1).select(kept / (x.square() + y.square()).max(no_load), 0);
  Borne borne;
  const ArrayXd &width = lines.width, weighted = width * turning;
  borne.sum << (width * kept * x).sum(), (width * kept * y).sum();
  const double straight = (width * kept).sum(), xy = (weighted * x * y).sum();
  borne.stiffness << straight - (weighted * x.square()).sum(), -xy, -xy, straight - (weighted * y.square()).sum();
  borne.stiffness *= lines.stiffness;
  return borne;
}

}  // namespace

ArrayXd shares_within(const ArrayXd& most, const ArrayXd& x, const ArrayXd& y) {
  const ArrayXd size = (x.square() + y.square()).sqrt();
  return (size > most).select(most / size.max(no_load), 1);
}

Vector2d way_for_forces(const Vector2d& sum, const PlaneLines& lines) {
  constexpr int most_steps = 200, most_halvings = 60;
  const double enough = 1e-12 * (lines.width * lines.most).sum();
  Vector2d u(0, 0);
  auto borne = borne_at(u, lines);
  for (int k = 0; k < most_steps; ++k) {
    const Vector2d lack = sum - borne.sum;
    if (lack.norm() <= enough) return u;
    Vector2d step = borne.stiffness.partialPivLu().solve(lack);
    if (!step.allFinite()) step = lack / (lines.stiffness * lines.width.sum());
    for (int halving = 0; halving < most_halvings; ++halving, step /= 2) {
      const auto there = borne_at(u + step, lines);
      if (!((sum - there.sum).norm() < lack.norm())) continue;
      u += step;
      borne = there;
      break;
    }
  }
  throw std::runtime_error("no displacement was found at which the springs bear the prescribed tangential forces");
}

}  // namespace fretval::mdr
