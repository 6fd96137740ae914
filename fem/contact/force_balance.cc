#include "fem/contact/force_balance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

/// Forces less their values, known as closely as a search for their balance can make use of.
class Excess {
 public:
  Excess(const ForcesAt& forces, Eigen::VectorXd values, double enough)
      : forces_(forces), values_(std::move(values)), finest_(enough / 10), within_(1e5 * enough) {}

  /// What is left at displacements: known to a tenth of it, or as closely as it is ever asked for.
  Eigen::VectorXd at(const Eigen::VectorXd& displacements) {
    for (;;) {
      Eigen::VectorXd left = forces_(displacements, within_) - values_;
      const double size = left.lpNorm<Eigen::Infinity>(), known = within_;
      within_ = std::clamp(size / 100, finest_, within_);
      if (10 * known <= size || known <= finest_ || !left.allFinite()) return left;
    }
  }
  /// The same as closely as it is ever asked for.
  [[nodiscard]] Eigen::VectorXd closely(const Eigen::VectorXd& displacements) const {
    return forces_(displacements, finest_) - values_;
  }

 private:
  const ForcesAt& forces_;
  Eigen::VectorXd values_;
  double finest_, within_;
};

/// The balance of a single force, held between brackets: Broyden's method may leave the contact on its way, where the
/// force is flat.
BalanceOfForces displacement_for_one_force(Excess& excess, BalanceOfForces guess, double probe, double enough) {
  Eigen::VectorXd& at = guess.displacements;
  Eigen::MatrixXd& stiffness = guess.stiffness;
  std::optional<Point> last;
  const auto excess_at = [&](double displacement) {
    const double left = excess.at(Eigen::VectorXd::Constant(1, displacement))[0];
    const double secant = last ? (left - last->excess) / (displacement - last->displacement) : 0;
    if (secant > 0 && std::isfinite(secant)) stiffness = Eigen::MatrixXd::Constant(1, 1, secant);
    last = {displacement, left};
    return left;
  };
  if (stiffness.size() == 0) {
    excess_at(at[0]);
    excess_at(at[0] + probe);
  }
  if (stiffness.size() == 0) stiffness = Eigen::MatrixXd::Constant(1, 1, 1);
  const double scale = enough / roundoff_of_force;
  at[0] = displacement_for_force(excess_at, 0, {at[0], stiffness(0, 0), scale});
  return guess;
}

}  // namespace

BalanceOfForces displacements_for_forces(const ForcesAt& forces, const Eigen::VectorXd& values, BalanceOfForces guess,
                                         double probe, double enough) {
  Excess left_at(forces, values, enough);
  if (values.size() == 1) return displacement_for_one_force(left_at, std::move(guess), probe, enough);
  Eigen::VectorXd& at = guess.displacements;
  Eigen::MatrixXd& stiffness = guess.stiffness;
  Eigen::VectorXd excess = left_at.at(at);
  const auto measure = [&] {
    excess = left_at.closely(at);
    stiffness.resize(at.size(), at.size());
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      Eigen::VectorXd aside = at;
      aside[j] += probe;
      stiffness.col(j) = (left_at.closely(aside) - excess) / probe;
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
    const Eigen::VectorXd change = left_at.at(there) - excess;
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
