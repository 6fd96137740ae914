#include "mdr/layer/row_solver.h"

#include <Eigen/LU>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "mdr/support/checks.h"

namespace fretval::mdr {

namespace {

class Newton {
 public:
  Newton(const LayerModes& modes, const RowProblem& problem, const Eigen::ArrayXd& before, double y)
      : modes_(modes),
        problem_(problem),
        pulled_(modes.shape * modes.strength.matrix().asDiagonal()),
        share_(modes.shape.transpose() * before.matrix()),
        y_(y) {
    update();
  }

  // True once the loads are found; then they are exact, as they are linear between changes of the limits.
  bool solve(std::optional<double> sum) {
    constexpr int most_steps = 60, full_steps = 30;
    for (int step = 0; step < most_steps; ++step) {
      const Eigen::ArrayXi before = at_limit_;
      if (!advance(sum, step < full_steps ? 1 : 0.5)) return false;
      if ((before == at_limit_).all() && step < full_steps) return true;
      if (is_solved(sum)) return true;
    }
    return false;
  }

  [[nodiscard]] double sum() const { return load_.sum(); }
  [[nodiscard]] RowSolution solution() const { return {load_, coupling_, y_}; }
  void move_to(double y) {
    y_ = y;
    update();
  }

 private:
  void update() {
    coupling_ = (pulled_ * share_).array();
    const Eigen::ArrayXd wanted = (problem_.value + problem_.slope * y_ - coupling_) / problem_.stretch;
    load_ = wanted.max(problem_.lower).min(problem_.upper);
    at_limit_ = (wanted >= problem_.upper).cast<int>() - (wanted <= problem_.lower).cast<int>();
  }

  // A spring on the verge of its limit may go to and fro across it for ever, by roundoff.
  [[nodiscard]] bool is_solved(std::optional<double> sum) const {
    constexpr double roundoff = 1e-14;
    const double scale = roundoff * load_.matrix().norm(), n = static_cast<double>(load_.size());
    return (modes_.shape.transpose() * load_.matrix() - share_).norm() <= scale &&
           (!sum || std::abs(*sum - load_.sum()) <= scale * std::sqrt(n));
  }

  bool advance(std::optional<double> sum, double damping) {
    const Eigen::Index n = share_.size(), n_all = n + (sum ? 1 : 0);
    const Eigen::ArrayXd give = (at_limit_ == 0).select(1 / problem_.stretch, 0.0);
    Eigen::MatrixXd slope = Eigen::MatrixXd::Identity(n_all, n_all);
    Eigen::VectorXd rest(n_all);
    rest.head(n) = modes_.shape.transpose() * load_.matrix() - share_;
    const auto [first, n_giving] = range_between_limits();
    slope.topLeftCorner(n, n).noalias() +=
        modes_.shape.middleRows(first, n_giving).transpose() *
        (give.segment(first, n_giving).matrix().asDiagonal() * pulled_.middleRows(first, n_giving));
    if (sum) {
      rest[n] = *sum - load_.sum();
      slope.bottomLeftCorner(1, n) = -(give.matrix().transpose() * pulled_);
      slope.topRightCorner(n, 1) = -(modes_.shape.transpose() * (give * problem_.slope).matrix());
      slope(n, n) = (give * problem_.slope).sum();
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

  // The first spring that is between its limits, and how many there are up to the last one: all others give nothing.
  [[nodiscard]] std::pair<Eigen::Index, Eigen::Index> range_between_limits() const {
    Eigen::Index first = 0, end = at_limit_.size();
    while (first < end && at_limit_[first] != 0) ++first;
    while (end > first && at_limit_[end - 1] != 0) --end;
    return {first, end - first};
  }

  const LayerModes& modes_;
  const RowProblem& problem_;
  Eigen::MatrixXd pulled_;
  Eigen::VectorXd share_;  // of the loads in each mode
  double y_;
  Eigen::ArrayXd load_, coupling_;
  Eigen::ArrayXi at_limit_;  // -1 lower, 1 upper, 0 between
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
  const auto excess = [&](double y) { return at(y).load.sum() - sum; };
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
