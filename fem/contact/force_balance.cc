#include "fem/contact/force_balance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "fem/support/solver_error.h"

namespace fretval::fem {
namespace {

constexpr double roundoff_of_force = 1e-13;
constexpr int most_trials = 200;
constexpr int enough_secants = 8;  // smooth forces need three to five

struct Point {
  double displacement, excess;
};

/// The nearest points on either side of the balance.
struct Bracket {
  std::optional<Point> below, above;

  void add(const Point& point) { (point.excess < 0 ? below : above) = point; }
  [[nodiscard]] bool closed() const { return below && above; }
  [[nodiscard]] double middle() const { return (below->displacement + above->displacement) / 2; }
  [[nodiscard]] bool contains(double displacement) const {
    return (!below || displacement > below->displacement) && (!above || displacement < above->displacement);
  }
  [[nodiscard]] double width() const { return above->displacement - below->displacement; }
};

}  // namespace

double displacement_for_force(const std::function<double(double)>& force, double value, const BalanceGuess& guess) {
  const auto at = [&](double displacement) { return Point{displacement, force(displacement) - value}; };
  const double small_force = roundoff_of_force * guess.scale, small_displacement = small_force / guess.stiffness;
  Bracket bracket;
  Point last = at(guess.displacement);
  double stiffness = guess.stiffness;
  for (int k = 0; k < most_trials; ++k) {
    if (std::abs(last.excess) <= small_force) return last.displacement;
    bracket.add(last);
    if (bracket.closed() && bracket.width() <= small_displacement) return bracket.middle();
    double next = last.displacement - last.excess / stiffness;
    if (bracket.closed() && (k > enough_secants || !bracket.contains(next))) next = bracket.middle();
    const Point point = at(next);
    const double secant = (point.excess - last.excess) / (point.displacement - last.displacement);
    // Where nothing resists the force is flat, and the step is doubled each time.
    stiffness = secant > 0 ? secant : stiffness / 2;
    last = point;
  }
  throw SolverError(
      fmt::format("no displacement of the indenter was found for a force of {:g}: {:g} is left of it at {:g}", value,
                  last.excess, last.displacement));
}

namespace {

/// The balance of a single force, held between brackets: Broyden's method may leave the contact on its way, where the
/// force is flat.
BalanceOfForces displacement_for_one_force(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& forces,
                                           const Eigen::VectorXd& values, BalanceOfForces guess, double probe,
                                           double enough) {
  Eigen::VectorXd& at = guess.displacements;
  Eigen::MatrixXd& stiffness = guess.stiffness;
  std::optional<Point> last;
  const auto force_at = [&](double displacement) {
    const double force = forces(Eigen::VectorXd::Constant(1, displacement))[0];
    const double secant = last ? (force - last->excess) / (displacement - last->displacement) : 0;
    if (secant > 0 && std::isfinite(secant)) stiffness = Eigen::MatrixXd::Constant(1, 1, secant);
    last = {displacement, force};
    return force;
  };
  if (stiffness.size() == 0) {
    force_at(at[0]);
    force_at(at[0] + probe);
  }
  if (stiffness.size() == 0) stiffness = Eigen::MatrixXd::Constant(1, 1, 1);
  const double scale = enough / roundoff_of_force;
  at[0] = displacement_for_force(force_at, values[0], {at[0], stiffness(0, 0), scale});
  return guess;
}

}  // namespace

BalanceOfForces displacements_for_forces(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& forces,
                                         const Eigen::VectorXd& values, BalanceOfForces guess, double probe,
                                         double enough) {
  if (values.size() == 1) return displacement_for_one_force(forces, values, guess, probe, enough);
  Eigen::VectorXd& at = guess.displacements;
  Eigen::MatrixXd& stiffness = guess.stiffness;
  Eigen::VectorXd excess = forces(at) - values;
  const auto measure = [&] {
    stiffness.resize(at.size(), at.size());
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      Eigen::VectorXd aside = at;
      aside[j] += probe;
      stiffness.col(j) = (forces(aside) - values - excess) / probe;
    }
  };
  const auto is_found = [&] { return excess.lpNorm<Eigen::Infinity>() <= enough; };
  // Where nearly all of the contact slips the forces bend off, and hardly resist in their own direction: an old
  // stiffness misleads, and a whole step goes too far. Damping shortens it in that direction.
  constexpr double least_gain = 0.1;  // of what the stiffness promises
  constexpr double first_damping = 1e-3, harder = 4, softer = 8;
  const auto identity = Eigen::MatrixXd::Identity(at.size(), at.size());
  bool is_measured = false;
  double damping = 0;
  for (int k = 0; k < most_trials && !is_found(); ++k) {
    if (stiffness.size() == 0) {
      measure();
      is_measured = true;
    }
    const Eigen::VectorXd step = -(stiffness + damping * identity).partialPivLu().solve(excess), there = at + step;
    if (!there.allFinite()) break;
    const Eigen::VectorXd change = forces(there) - values - excess;
    if (!change.allFinite()) break;
    const double before = excess.norm(), after = (excess + change).norm(),
                 promised = before - (excess + stiffness * step).norm();
    if (before - after > least_gain * promised) {
      stiffness += (change - stiffness * step) * step.transpose() / step.squaredNorm();
      at = there;
      excess += change;
      damping /= softer;
    } else if (is_measured) {
      damping = std::max(harder * damping, first_damping * stiffness.norm());
      continue;
    }
    if (after > before / 2 && !is_measured) stiffness.resize(0, 0);
    is_measured = false;
  }
  if (is_found()) return guess;
  throw NoBalance(fmt::format("no displacements of the indenter were found that balance its forces: {:g} is left",
                              excess.lpNorm<Eigen::Infinity>()));
}

}  // namespace fretval::fem
