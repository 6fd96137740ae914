#include "mdr/layer/row_solver.h"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "mdr/support/checks.h"
#include "mdr/support/wide_registers.h"

namespace fretval::mdr {

namespace {

class Newton {
 public:
  Newton(const LayerModes& modes, const RowProblem& problem, const Eigen::ArrayXd& before, double y)
      : modes_(modes),
        problem_(problem),
        share_(modes.shape.transpose() * before.matrix()),
        y_(y),
        load_(before.size()),
        rim_load_(before.size()),
        at_limit_(before.size()),
        give_(before.size()) {
    update();
  }

  // True once the loads are found. Between changes of the limits they are linear, so that a step is exact; but for
  // rim loads, on which steps converge quadratically.
  bool solve(std::optional<double> sum) {
    constexpr int most_steps = 60, full_steps = 30;
    constexpr double roundoff = 1e-14, quadratically_near = 1e-7;
    for (int step = 0; step < most_steps; ++step) {
      const Eigen::ArrayXd before = at_limit_;
      const bool is_exact = (rim_load_ == 0).all() || is_solved(sum, quadratically_near);
      if (!advance(sum, step < full_steps ? 1 : 0.5)) return false;
      if (is_exact && (before == at_limit_).all() && step < full_steps) return true;
      if (is_solved(sum, roundoff)) return true;
    }
    return false;
  }

  [[nodiscard]] RowSolution solution() const { return {load_, rim_load_, coupling_, y_}; }

 private:
  void update() {
    coupling_.matrix().noalias() = modes_.pulled * share_;
    in_wide_registers([&] { find_loads(); });
    all_loads_ = (load_ + rim_load_).matrix();
    rest_.noalias() = modes_.shape.transpose() * all_loads_;
    rest_ -= share_;
  }

  // One pass over the springs without a branch, so that the compiler vectorises it.
  void find_loads() {
    const double *value = problem_.value.data(), *slope = problem_.slope.data(), *stretches = problem_.stretch.data(),
                 *lowest = problem_.lower.data(), *highest = problem_.upper.data(), *falls = problem_.fall.data(),
                 *coupling = coupling_.data();
    double *load = load_.data(), *rim_load = rim_load_.data(), *give = give_.data(), *at_limit = at_limit_.data();
    const double y = y_;
    constexpr double least_fall = std::numeric_limits<double>::min();  // where it is 0, nothing is within it
#pragma GCC ivdep
    for (Eigen::Index j = 0, n = load_.size(); j < n; ++j) {
      const double stretch = stretches[j], lower = lowest[j], upper = highest[j], fall = falls[j];
      const double wanted = (value[j] + slope[j] * y - coupling[j]) / stretch, above = wanted - lower;
      const double side = (wanted >= upper ? 1.0 : 0.0) - (above <= 0 ? 1.0 : 0.0);
      const double within = std::max(fall / 2 - std::abs(above), 0.0), share = within / std::max(fall, least_fall);
      at_limit[j] = side;
      load[j] = std::min(std::max(wanted, lower), upper);
      rim_load[j] = within * share / 2;
      give[j] = ((side == 0 ? 1.0 : 0.0) + (above < 0 ? share : -share)) / stretch;
    }
  }

  // A spring on the verge of its limit may go to and fro across it for ever, by roundoff.
  [[nodiscard]] bool is_solved(std::optional<double> sum, double tolerance) const {
    const double scale = tolerance * all_loads_.norm(), n = static_cast<double>(load_.size());
    return rest_.norm() <= scale && (!sum || std::abs(*sum - all_loads_.sum()) <= scale * std::sqrt(n));
  }

  bool advance(std::optional<double> sum, double damping) {
    const Eigen::Index n = share_.size(), n_all = n + (sum ? 1 : 0);
    Eigen::MatrixXd slope = Eigen::MatrixXd::Identity(n_all, n_all);
    slope.topLeftCorner(n, n) += modes_.response(give_);
    Eigen::VectorXd rest(n_all);
    rest.head(n) = rest_;
    if (sum) {
      rest[n] = *sum - all_loads_.sum();
      slope.bottomLeftCorner(1, n) = -(give_.matrix().transpose() * modes_.pulled);
      slope.topRightCorner(n, 1) = -(modes_.shape.transpose() * (give_ * problem_.slope).matrix());
      slope(n, n) = (give_ * problem_.slope).sum();
      if (slope(n, n) <= 0) return false;
    }
    if (n_all > 0) {
      const Eigen::VectorXd move = damping * slope.partialPivLu().solve(rest);
      if (!move.allFinite()) return false;
      share_ += move.head(n);
      if (sum) y_ += move[n];
    }
    update();
    return true;
  }

  const LayerModes& modes_;
  const RowProblem& problem_;
  Eigen::VectorXd share_;  // of all loads in each mode
  double y_;
  Eigen::ArrayXd coupling_, load_, rim_load_;
  Eigen::VectorXd all_loads_, rest_;  // rest: of the share of the loads in each mode
  Eigen::ArrayXd at_limit_;           // -1 lower, 1 upper, 0 between
  Eigen::ArrayXd give_;               // of both loads, by what the equation has on its right
};

[[noreturn]] void not_found() {
  throw std::runtime_error("the loads of the coupled springs were not found in a time step");
}

// Where Newton's method for both at once does not come to an end: the sum rises with y, so a bracket finds it.
RowSolution bracketed(const LayerModes& modes, const RowProblem& problem, const Eigen::ArrayXd& before, double guess,
                      double sum) {
  const auto at = [&](double y) {
    Newton newton(modes, problem, before, y);
    if (!newton.solve({})) not_found();
    return newton.solution();
  };
  const auto excess = [&](double y) {
    const RowSolution found = at(y);
    return (found.load + found.rim_load).sum() - sum;
  };
  double reach = (problem.value.abs().maxCoeff() + std::abs(guess)) * 1e-3, lower = guess, upper = guess;
  constexpr int most_doublings = 60;
  for (int i = 0; i < most_doublings && excess(lower) > 0; ++i) lower -= reach *= 2;
  for (int i = 0; i < most_doublings && excess(upper) < 0; ++i) upper += reach *= 2;
  if (excess(lower) > 0 || excess(upper) < 0) reject("sum of the loads in m", sum, "no position gives it");
  if (lower == upper) return at(lower);
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(excess, lower, upper,
                                                         boost::math::tools::eps_tolerance<double>(52), iterations);
  return at((bracket.first + bracket.second) / 2);
}

}  // namespace

RowSolution solve_row(const LayerModes& modes, const RowProblem& problem, const Eigen::ArrayXd& before, double guess,
                      std::optional<double> sum) {
  Newton newton(modes, problem, before, guess);
  if (newton.solve(sum)) return newton.solution();
  if (!sum) not_found();
  return bracketed(modes, problem, before, guess, *sum);
}

}  // namespace fretval::mdr
