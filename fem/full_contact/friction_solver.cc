#include "fem/full_contact/friction_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fem/full_contact/conjugate_gradients.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

/// Remainder that is accepted where the iteration stalls, as roundoff may do with many rings: it is a tenth of the
/// accuracy of prescribed forces.
constexpr double enough_where_it_stalls = 1e-10;
/// Linear systems that would have taken this many applications fewer with a new inverse pay for one: blocks of N rows
/// take N^3 operations to invert, 4 to 6 N^2 to apply with their inverse, and have one or two rows for each ring.
double price_of_inverse(Index n_rings) {
  return static_cast<double>(n_rings) / 2;
}
/// Where the contact grows, a new inverse has an eighth more rings than have a limit. It serves until it has a third
/// more.
Index with_room(Index n_rings) {
  return n_rings + (n_rings + 7) / 8;
}
constexpr double most_room = 4.0 / 3;

/// State of each point: whether it slips, the normal (x, y) of the rim of its disc there, and the stiffness of the rim.
struct Rims {
  MatrixXd x, y, stiffness;
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> slips;

  Rims(Index n_rings, Index n_angles)
      : x(n_rings, n_angles), y(n_rings, n_angles), stiffness(n_rings, n_angles), slips(n_rings, n_angles) {}
};

/// Finds the points that slip, and moves them onto the rims of their discs. A point slips where t + rho (q - K t), with
/// rho the inverse of the diagonal of K, leaves its disc.
Rims find_rims(const SurfaceOperator& op, const MatrixXd& residual, const MatrixXd& limit, MatrixXd& traction) {
  const Index n = limit.rows(), m = limit.cols();
  Rims rims(n, m);
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i) {
      const double weight = 1 / op.diagonal()[i], x = traction(i, j) + weight * residual(i, j),
                   y = traction(i, m + j) + weight * residual(i, m + j), length = std::hypot(x, y);
      rims.slips(i, j) = length > limit(i, j) || limit(i, j) == 0;
      rims.x(i, j) = length > 0 ? x / length : 1;
      rims.y(i, j) = length > 0 ? y / length : 0;
      rims.stiffness(i, j) = 0;
      if (!rims.slips(i, j) || limit(i, j) == 0) continue;
      rims.stiffness(i, j) = std::hypot(residual(i, j), residual(i, m + j)) / limit(i, j);
      traction(i, j) = limit(i, j) * rims.x(i, j);
      traction(i, m + j) = limit(i, j) * rims.y(i, j);
    }
  return rims;
}

/// Projects a field at points that slip onto the direction of their rims, and to zero where there is no limit.
void keep_to_rims(const Rims& rims, const MatrixXd& limit, MatrixXd& field) {
  const Index n = limit.rows(), m = limit.cols();
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i) {
      if (!rims.slips(i, j)) continue;
      const double along = limit(i, j) == 0 ? 0 : rims.x(i, j) * field(i, m + j) - rims.y(i, j) * field(i, j);
      field(i, j) = -rims.y(i, j) * along;
      field(i, m + j) = rims.x(i, j) * along;
    }
}

/// Root of the ratio between the traction that moves each point alone by a unit, 1/(diagonal of K + stiffness of its
/// rim), and the same with the stiffness of its ring that the inverse was made with.
Eigen::ArrayXXd scale_of_points(const SurfaceOperator& op, const Eigen::ArrayXd& of_rings, const Rims& rims) {
  const Eigen::ArrayXd alone = op.diagonal().array();
  return ((rims.stiffness.array().colwise() + alone).inverse().colwise() * (of_rings.head(alone.size()) + alone))
      .sqrt();
}

/// x and y of a field times a number per point.
MatrixXd scaled(MatrixXd field, const Eigen::ArrayXXd& by) {
  field.leftCols(by.cols()).array() *= by;
  field.rightCols(by.cols()).array() *= by;
  return field;
}

double product(const MatrixXd& a, const MatrixXd& b) {
  return a.cwiseProduct(b).sum();
}

bool is_on_rim(const Eigen::Vector2d& traction, double limit) {
  constexpr double roundoff = 1e-14;
  return limit > 0 && traction.norm() >= (1 - roundoff) * limit;
}

class Newton {
 public:
  /// op: on the rings that have a limit, all: on all rings.
  Newton(const SurfaceOperator& op, const SurfaceOperator& all, const MatrixXd& pull, const MatrixXd& limit,
         const MatrixXd& guess, FrictionSolver::Preconditioner& preconditioner)
      : op_(op), all_(all), limit_(limit), largest_(limit.maxCoeff()), preconditioner_(preconditioner) {
    solution_.traction = onto_discs(guess, limit);
    op.apply(solution_.traction, image_);
    solution_.residual = pull - image_;
    solution_.applications = 1;
  }

  /// Whether the solution is found.
  bool is_done(double enough) {
    solution_.remainder = friction_remainder(op_, solution_.residual, limit_, solution_.traction) / largest_;
    least_remainder_ = std::min(least_remainder_, solution_.remainder);
    return solution_.remainder <= enough;
  }

  void iterate(double enough) {
    ++solution_.iterations;
    const auto newton = as_far_as_it_lowers(newton_step(enough));
    if (halves_least_remainder(newton)) return go(newton, 1);
    const auto down = as_far_as_it_lowers(gradient_step());
    const auto& better = lowering(newton) > lowering(down) ? newton : down;
    go(better, better.share);
  }

  FrictionSolution& solution() { return solution_; }

 private:
  /// A way within the discs, its image, and the share of it that lowers the energy most.
  struct Descent {
    MatrixXd way, image;
    double share;
  };

  MatrixXd newton_step(double enough) {
    const Index m = limit_.cols();
    MatrixXd onto = solution_.traction, step, right;
    const Rims rims = find_rims(op_, solution_.residual, limit_, onto);
    op_.apply(onto - solution_.traction, image_);
    right = solution_.residual - image_;
    keep_to_rims(rims, limit_, right);
    update_preconditioner(rims);
    const Eigen::ArrayXXd scale = scale_of_points(op_, preconditioner_.stiffness, rims);
    const auto apply = [&](const MatrixXd& field, MatrixXd& result) {
      op_.apply(field, result);
      result.leftCols(m) += rims.stiffness.cwiseProduct(field.leftCols(m));
      result.rightCols(m) += rims.stiffness.cwiseProduct(field.rightCols(m));
      keep_to_rims(rims, limit_, result);
    };
    const auto precondition = [&](const MatrixXd& field, MatrixXd& result) {
      preconditioner_.inverse->apply(scaled(field, scale), result);
      result = scaled(std::move(result), scale);
      keep_to_rims(rims, limit_, result);
    };
    const double share = share_for(solution_.remainder, enough);
    const int n_applications = conjugate_gradients(apply, precondition, right, share, most_applications, step);
    solution_.applications += 1 + n_applications;
    watch_preconditioner(n_applications, -std::log10(share));
    onto += step;
    for (Index j = 0; j < m; ++j)  // back to the rims, however far the step was
      for (Index i = 0; i < limit_.rows(); ++i) {
        const double length = std::hypot(onto(i, j), onto(i, m + j));
        if (!rims.slips(i, j) || !(length > 0)) continue;
        onto(i, j) *= limit_(i, j) / length;
        onto(i, m + j) *= limit_(i, j) / length;
      }
    return onto_discs(onto, limit_) - solution_.traction;
  }

  /// A new inverse that takes more than 10 applications for a tenth of the residual happens to be bad, and would never
  /// be made anew at its own rate.
  void watch_preconditioner(int n_applications, double n_decades) {
    constexpr double bad_rate = 10;
    auto& [inverse, stiffness, per_decade, n_more] = preconditioner_;
    if (per_decade == 0) per_decade = std::min(n_applications / n_decades, bad_rate);
    n_more += std::max(0.0, n_applications - per_decade * n_decades);
  }

  void update_preconditioner(const Rims& rims) {
    auto& [inverse, stiffness, per_decade, n_more] = preconditioner_;
    const Index n = op_.n_rings(), n_before = stiffness.size();
    const bool fits = n <= n_before && static_cast<double>(n_before) <= most_room * static_cast<double>(n);
    if (fits && n_more <= price_of_inverse(n)) return;
    const bool has_grown = inverse && n > n_before;
    const auto with_more = all_.leading(has_grown ? std::min(with_room(n), all_.n_rings()) : n);
    stiffness = Eigen::ArrayXd::Zero(with_more.n_rings());
    stiffness.head(n) = rims.stiffness.rowwise().mean();
    per_decade = n_more = 0;
    inverse.emplace(with_more, stiffness.matrix().cwiseQuotient(with_more.areas()));
  }

  [[nodiscard]] MatrixXd gradient_step() const {
    MatrixXd onto = solution_.traction;
    const Eigen::ArrayXd weight = op_.diagonal().array().inverse();
    onto.array() += solution_.residual.array().colwise() * weight;
    return onto_discs(onto, limit_) - solution_.traction;
  }

  /// Whether a step leaves less than half of the least remainder so far. Such a step may raise the energy, by which
  /// other steps are judged: near the solution roundoff hides its change. There are only so many of them, which half of
  /// the last remainder would not see to: two steps may take turns, one raising the energy and one lowering it.
  [[nodiscard]] bool halves_least_remainder(const Descent& whole) const {
    const double remainder =
        friction_remainder(op_, solution_.residual - whole.image, limit_, solution_.traction + whole.way) / largest_;
    return remainder < least_remainder_ / 2;
  }

  /// Goes along a way as far as that lowers the energy, but not beyond its end, which still lies in the discs.
  Descent as_far_as_it_lowers(MatrixXd way) {
    op_.apply(way, image_);
    ++solution_.applications;
    const double share = std::min(1.0, slope(way) / product(way, image_));
    return {std::move(way), image_, share > 0 ? share : 0};
  }

  [[nodiscard]] double lowering(const Descent& by) const {
    return by.share * (slope(by.way) - by.share / 2 * product(by.way, by.image));
  }

  /// How steeply the energy falls along a way, way . (q - K t). The way of a point from rim to rim is normal to the
  /// mean of its two ends, but for roundoff, which the residual along that mean would make more of than there is to
  /// gain next to the solution: such a point counts with what is normal to it.
  [[nodiscard]] double slope(const MatrixXd& way) const {
    const Index m = limit_.cols();
    double sum = product(way, solution_.residual);
    for (Index j = 0; j < m; ++j)
      for (Index i = 0; i < limit_.rows(); ++i) {
        const Eigen::Vector2d t(solution_.traction(i, j), solution_.traction(i, m + j)), w(way(i, j), way(i, m + j)),
            q(solution_.residual(i, j), solution_.residual(i, m + j)), mean = t + w / 2;
        const bool stays_on_this_side = w.norm() < t.norm();
        if (stays_on_this_side && is_on_rim(t, limit_(i, j)) && is_on_rim(t + w, limit_(i, j)))
          sum -= mean.dot(q) * mean.dot(w) / mean.squaredNorm();
      }
    return sum;
  }

  void go(const Descent& by, double share) {
    solution_.traction += share * by.way;
    solution_.residual -= share * by.image;
  }

  const SurfaceOperator &op_, &all_;
  const MatrixXd& limit_;
  double largest_;
  MatrixXd image_;
  FrictionSolver::Preconditioner& preconditioner_;
  FrictionSolution solution_;
  double least_remainder_ = std::numeric_limits<double>::infinity();
};

void require_fit(const SurfaceOperator& op, const MatrixXd& pull, const MatrixXd& limit, const MatrixXd& guess) {
  const Index n = op.n_rings(), m = op.grid().n_kept();
  if (op.n_columns() != 2 * m || pull.rows() != n || pull.cols() != 2 * m || limit.rows() != n || limit.cols() != m ||
      guess.rows() != n || guess.cols() != 2 * m)
    throw std::invalid_argument("the fields of the friction problem do not fit its operator");
  if (!(limit.minCoeff() >= 0) || !limit.allFinite() || !pull.allFinite())
    throw std::invalid_argument("the friction limits must be numbers that are not negative, and their pull numbers");
}

/// Solves the friction problem on the rings up to the last one that has a friction limit; op and fields have no other
/// rings, all has.
FrictionSolution solve_touching(const SurfaceOperator& op, const SurfaceOperator& all, const MatrixXd& pull,
                                const MatrixXd& limit, const MatrixXd& guess, double enough,
                                FrictionSolver::Preconditioner& preconditioner) {
  Newton newton(op, all, pull, limit, guess, preconditioner);
  while (!newton.is_done(enough)) {
    if (newton.solution().iterations == most_newton_steps) {
      if (newton.solution().remainder <= enough_where_it_stalls) break;
      throw SolverError(
          fmt::format("friction with a traction of any direction does not converge: {:.1e} of the "
                      "largest limit is left after {} iterations, {:.1e} is asked for",
                      newton.solution().remainder, most_newton_steps, enough));
    }
    newton.iterate(enough);
  }
  return std::move(newton.solution());
}

}  // namespace

MatrixXd onto_discs(MatrixXd traction, const MatrixXd& limit) {
  const Index m = limit.cols();
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < limit.rows(); ++i) {
      const double length = std::hypot(traction(i, j), traction(i, m + j));
      if (length <= limit(i, j)) continue;
      traction(i, j) *= limit(i, j) / length;
      traction(i, m + j) *= limit(i, j) / length;
    }
  return traction;
}

double friction_remainder(const SurfaceOperator& op, const MatrixXd& residual, const MatrixXd& limit,
                          const MatrixXd& traction) {
  const Eigen::ArrayXd weight = op.diagonal().array().inverse();
  MatrixXd onto = traction;
  onto.array() += residual.array().colwise() * weight;
  return (onto_discs(onto, limit) - traction).lpNorm<Eigen::Infinity>();
}

FrictionSolution FrictionSolver::solve(const MatrixXd& pull, const MatrixXd& limit, const MatrixXd& guess,
                                       double enough) {
  require_fit(*op_, pull, limit, guess);
  Index n = op_->n_rings();
  while (n > 0 && limit.row(n - 1).maxCoeff() == 0) --n;
  FrictionSolution solution{MatrixXd::Zero(pull.rows(), pull.cols()), pull};
  if (n == 0) return solution;
  if (!touching_ || touching_->n_rings() != n) touching_ = op_->leading(n);
  auto found =
      solve_touching(*touching_, *op_, pull.topRows(n), limit.topRows(n), guess.topRows(n), enough, preconditioner_);
  solution.traction.topRows(n) = found.traction;
  MatrixXd image;
  op_->apply(solution.traction, image);
  solution.residual -= image;
  solution.residual.topRows(n) = found.residual;
  solution.remainder = found.remainder;
  solution.iterations = found.iterations;
  solution.applications = found.applications;
  return solution;
}

}  // namespace fretval::fem
