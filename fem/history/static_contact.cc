#include "fem/history/static_contact.h"

#include <algorithm>
#include <array>
#include <limits>

#include "fem/support/solver_error.h"

namespace fretval::fem {

Eigen::VectorXd ring_means(const Compliance& compliance, const std::function<double(double)>& f) {
  // 5-point Gauss: exact for polynomials of degree 8 times r; profiles are smooth inside a ring.
  constexpr std::array<double, 5> points{-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                         0.9061798459386640};
  constexpr std::array<double, 5> weights{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                          0.4786286704993665, 0.2369268850561891};
  Eigen::VectorXd means(compliance.areas.size());
  for (Eigen::Index i = 0; i < means.size(); ++i) {
    const double inner = compliance.radii[i], outer = compliance.radii[i + 1];
    double sum = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double r = (inner + outer) / 2 + points[k] * (outer - inner) / 2;
      sum += weights[k] * r * f(r);
    }
    means[i] = sum / (inner + outer);
  }
  return means;
}

namespace {

StaticContact solve(const BoxSolver& solver, const Eigen::VectorXd& areas, const Eigen::VectorXd& target,
                    std::vector<BoxState>& states) {
  const Eigen::Index n = areas.size();
  const auto solution = solver.solve(areas.cwiseProduct(target), Eigen::VectorXd::Zero(n),
                                     Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity()), states);
  return {solution.x, (-solution.residual.array() / areas.array()).matrix()};
}

/// As solve_contact, of rings that wear by softness times their pressure.
StaticContact solve_softened(const ContactProblem& problem, const Eigen::VectorXd& target,
                             const Eigen::VectorXd& softness, std::vector<BoxState>& states) {
  const auto& areas = problem.compliance.areas;
  Eigen::MatrixXd matrix = *problem.compliance.matrix;
  matrix.diagonal() += areas.cwiseProduct(softness);
  // To a unit diagonal: a very soft ring bears next to nothing, and that has its sign all the same.
  const Eigen::VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
  auto contact = solve(BoxSolver(matrix), areas.cwiseProduct(scale), target, states);
  contact.pressure.array() *= scale.array();
  return contact;
}

}  // namespace

StaticContact solve_contact(const ContactProblem& problem, const Eigen::VectorXd& target,
                            std::vector<BoxState>& states) {
  return solve(problem.solver, problem.compliance.areas, target, states);
}

Eigen::VectorXd worn_by(const PressureWear& wear, const Eigen::VectorXd& pressure) {
  if (wear.coefficient.size() == 0) return Eigen::VectorXd::Zero(pressure.size());
  return wear.coefficient.cwiseProduct(pressure.array().max(0).pow(wear.exponent).matrix());
}

StaticContact solve_wearing_contact(const ContactProblem& problem, const Eigen::VectorXd& target,
                                    const PressureWear& wear, std::vector<BoxState>& states) {
  if (wear.coefficient.isZero(0)) return solve_contact(problem, target, states);
  if (wear.exponent == 1) return solve_softened(problem, target, wear.coefficient, states);
  constexpr int most_iterations = 200;
  constexpr double converged = 1e-7, least_share = 0.1;  // of the iterate before
  constexpr double no_pressure = 1e-16, roundoff = 1e-14;
  const double m = wear.exponent;
  const auto& coefficient = wear.coefficient.array();
  auto contact = solve_contact(problem, target, states);
  // Of p^m its tangent, or with m < 1, where tangents overshoot, its secant from 0, which gains a factor 1 - m a time.
  // At p = 0 it has neither, and a ring of hardly any pressure hardly wears.
  const double slope = std::max(m, 1.0);
  const double floor = no_pressure * contact.pressure.maxCoeff();
  const double nothing = roundoff * target.lpNorm<Eigen::Infinity>();
  Eigen::ArrayXd at = contact.pressure.array().max(floor);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::ArrayXd worn = coefficient * at.pow(m);
    contact = solve_softened(problem, target - (1 - slope) * worn.matrix(), (slope * worn / at).matrix(), states);
    at = contact.pressure.array().max(least_share * at).max(floor);
    if ((coefficient * at.pow(m) - worn).abs().maxCoeff() <= std::max(converged * worn.maxCoeff(), nothing))
      return contact;
  }
  throw SolverError("the pressure under which an indenter wears does not converge");
}

StaticContact static_contact(const ContactProblem& problem, const Eigen::VectorXd& profile, double indentation) {
  std::vector<BoxState> contact(static_cast<std::size_t>(problem.n_rings()), BoxState::lower);
  for (Eigen::Index i = 0; i < profile.size(); ++i)
    if (profile[i] < indentation) contact[i] = BoxState::interior;
  return solve_contact(problem, (indentation - profile.array()).matrix(), contact);
}

}  // namespace fretval::fem
