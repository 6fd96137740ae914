#include "mdr/layer/row_solver.h"

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
  Newton(const LayerModes& modes, ModeEquations& equations, const RowProblem& problem, const Eigen::ArrayXd& before,
         double y)
      : modes_(modes),
        equations_(equations),
        problem_(problem),
        share_(modes.shares_of(before)),
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
    coupling_ = modes_.coupling_of(share_);
    in_wide_registers([&] { find_loads(); });
    all_loads_ = load_ + rim_load_;
    rest_ = modes_.shares_of(all_loads_) - share_;
  }

  // One pass over the springs without a branch, so that the compiler vectorises it.
  void find_loads() {
    const double *value = problem_.value.data(), *slope = problem_.slope.data(), *stretches = problem_.stretch.data(),
                 *lowest = problem_.lower.data(), *highest = problem_.upper.data(), *falls = problem_.fall.data(),
                 *falls_beyond = problem_.beyond.data(), *coupling = coupling_.data();
    double *load = load_.data(), *rim_load = rim_load_.data(), *give = give_.data(), *at_limit = at_limit_.data();
    const double y = y_;
    constexpr double least_fall = std::numeric_limits<double>::min();  // where it is 0, nothing is within it
#pragma GCC ivdep
    for (Eigen::Index j = 0, n = load_.size(); j < n; ++j) {
      const double stretch = stretches[j], lower = lowest[j], upper = highest[j];
      const double wanted = (value[j] + slope[j] * y - coupling[j]) / stretch, above = wanted - lower;
      const double side = (wanted >= upper ? 1.0 : 0.0) - (above <= 0 ? 1.0 : 0.0);
      const double fall = above < 0 ? falls_beyond[j] : falls[j], of_load = falls[j] / std::max(fall, least_fall);
      const double within = std::max(fall / 2 - std::abs(above), 0.0),
                   share = of_load * within / std::max(fall, least_fall);
      at_limit[j] = side;
      load[j] = std::min(std::max(wanted, lower), upper);
      rim_load[j] = within * share / 2;
      give[j] = ((side == 0 ? 1.0 : 0.0) + (above < 0 ? share : -share)) / stretch;
    }
  }

  // A spring on the verge of its limit may go to and fro across it for ever, by roundoff.
  [[nodiscard]] bool is_solved(std::optional<double> sum, double tolerance) const {
    const double scale = tolerance * all_loads_.matrix().norm(), n = static_cast<double>(load_.size());
    return rest_.norm() <= scale && (!sum || std::abs(*sum - all_loads_.sum()) <= scale * std::sqrt(n));
  }

  bool advance(std::optional<double> sum, double damping) {
    equations_.take(give_);
    Eigen::VectorXd move = equations_.solve(rest_);
    double move_of_y = 0;
    if (sum) {
      const Eigen::ArrayXd by_y = give_ * problem_.slope;
      const double give_of_sum = by_y.sum();
      if (give_of_sum <= 0) return false;
      const Eigen::VectorXd of_y = equations_.solve(modes_.shares_of(by_y));
      const auto taken_by_coupling = [&](const Eigen::VectorXd& share) {
        return (give_ * modes_.coupling_of(share)).sum();
      };
      move_of_y = (*sum - all_loads_.sum() + taken_by_coupling(move)) / (give_of_sum - taken_by_coupling(of_y));
      move += move_of_y * of_y;
    }
    if (!move.allFinite() || !std::isfinite(move_of_y)) return false;
    share_ += damping * move;
    y_ += damping * move_of_y;
    update();
    return true;
  }

  const LayerModes& modes_;
  ModeEquations& equations_;
  const RowProblem& problem_;
  Eigen::VectorXd share_;  // of all loads in each mode
  double y_;
  Eigen::ArrayXd coupling_, load_, rim_load_, all_loads_;
  Eigen::VectorXd rest_;     // of the share of the loads in each mode
  Eigen::ArrayXd at_limit_;  // -1 lower, 1 upper, 0 between
  Eigen::ArrayXd give_;      // of both loads, by what the equation has on its right
};

}  // namespace

RowSolver::RowSolver(const LayerModes& modes) : modes_(modes), equations_(modes) {}

// Where Newton's method for both at once does not come to an end: the sum rises with y, so a bracket finds it.
RowSolution RowSolver::bracketed(const RowProblem& problem, const Eigen::ArrayXd& before, double guess, double sum) {
  const auto at = [&](double y) { return solve(problem, before, y); };
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

RowSolution RowSolver::solve(const RowProblem& problem, const Eigen::ArrayXd& before, double guess,
                             std::optional<double> sum) {
  Newton newton(modes_, equations_, problem, before, guess);
  if (newton.solve(sum)) return newton.solution();
  if (!sum) throw std::runtime_error("the loads of the coupled springs were not found in a time step");
  return bracketed(problem, before, guess, *sum);
}

}  // namespace fretval::mdr
