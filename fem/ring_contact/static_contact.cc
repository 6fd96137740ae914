#include "fem/ring_contact/static_contact.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "fem/support/solver_error.h"

namespace fretval::fem {

namespace {

/// Gauss's sum of r f(r), whose weights add up to 2: exact for polynomials of degree 8 times r.
double gauss_sum(const std::function<double(double)>& f, double inner, double outer) {
  constexpr std::array<double, 5> points{-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                         0.9061798459386640};
  constexpr std::array<double, 5> weights{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                          0.4786286704993665, 0.2369268850561891};
  double sum = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double r = (inner + outer) / 2 + points[k] * (outer - inner) / 2;
    sum += weights[k] * r * f(r);
  }
  return sum;
}

}  // namespace

Eigen::VectorXd ring_means(const Compliance& compliance, const std::function<double(double)>& f,
                           const std::vector<double>& kinks) {
  Eigen::VectorXd means(compliance.areas.size());
  for (Eigen::Index i = 0; i < means.size(); ++i) {
    const double inner = compliance.radii[i], outer = compliance.radii[i + 1];
    double sum = 0, from = inner;
    for (auto kink = std::upper_bound(kinks.begin(), kinks.end(), inner); from < outer; ++kink) {
      const double to = kink == kinks.end() ? outer : std::min(*kink, outer);
      sum += gauss_sum(f, from, to) * ((to - from) / (outer - inner));
      from = to;
      if (kink == kinks.end()) break;
    }
    means[i] = sum / (inner + outer);
  }
  return means;
}

namespace {

void solve_in_room(const BoxSolver& solver, const Eigen::VectorXd& areas, const Eigen::VectorXd& target,
                   std::vector<BoxState>& states, ContactRoom& room, StaticContact& contact) {
  room.lower.setZero(areas.size());
  room.upper.setConstant(areas.size(), std::numeric_limits<double>::infinity());
  room.target.q = areas.cwiseProduct(target);
  solver.hold(room.target);
  solver.solve(room.target, room.lower, room.upper, states, room.solution);
  contact.pressure.swap(room.solution.x);
  contact.gap = -room.solution.residual.cwiseQuotient(areas);
}

StaticContact solve_with(const BoxSolver& solver, const Eigen::VectorXd& areas, const Eigen::VectorXd& target,
                         std::vector<BoxState>& states) {
  ContactRoom room;
  StaticContact contact;
  solve_in_room(solver, areas, target, states, room, contact);
  return contact;
}

/// The solver of a contact whose rings wear by softness times their pressure.
BoxSolver softened(const ContactProblem& problem, const Eigen::VectorXd& softness,
                   const std::vector<BoxState>& likely) {
  const auto outermost = std::find(likely.rbegin(), likely.rend(), BoxState::interior);
  return {problem.solver, problem.compliance.areas.cwiseProduct(softness), likely.rend() - outermost};
}

}  // namespace

StaticContact solve_contact(const ContactProblem& problem, const Eigen::VectorXd& target,
                            std::vector<BoxState>& states) {
  return solve_with(problem.solver, problem.compliance.areas, target, states);
}

Eigen::VectorXd worn_by(const PressureWear& wear, const Eigen::VectorXd& pressure) {
  if (wear.exponent == 1) return wear.coefficient.cwiseProduct(pressure.cwiseMax(0));
  return wear.coefficient.cwiseProduct(pressure.array().max(0).pow(wear.exponent).matrix());
}

WearingSolver::WearingSolver(const ContactProblem& problem, PressureWear wear, const std::vector<BoxState>& likely)
    : problem_(problem), wear_(std::move(wear)) {
  if (wear_.exponent == 1 && !wear_.coefficient.isZero(0)) softened_ = softened(problem, wear_.coefficient, likely);
}

void WearingSolver::solve(const Eigen::VectorXd& target, std::vector<BoxState>& states, ContactRoom& room,
                          StaticContact& contact) const {
  if (!softened_ && !wear_.coefficient.isZero(0)) {
    contact = by_newton(target, states);
    return;
  }
  solve_in_room(softened_ ? *softened_ : problem_.solver, problem_.compliance.areas, target, states, room, contact);
}

StaticContact WearingSolver::by_newton(const Eigen::VectorXd& target, std::vector<BoxState>& states) const {
  constexpr int most_iterations = 200;
  constexpr double converged = 1e-7, least_share = 0.1;  // of the iterate before
  constexpr double no_pressure = 1e-16, roundoff = 1e-14;
  const double m = wear_.exponent;
  const auto& coefficient = wear_.coefficient.array();
  auto contact = solve_contact(problem_, target, states);
  // p^m is linearised by its tangent or, with m < 1, where tangents overshoot, by its secant from 0, which reduces the
  // error by a factor 1 - m in each iteration. At p = 0 it has neither, so that pressures have a floor: a ring of
  // hardly any pressure hardly wears.
  const double slope = std::max(m, 1.0);
  const double floor = no_pressure * contact.pressure.maxCoeff();
  const double nothing = roundoff * target.lpNorm<Eigen::Infinity>();
  Eigen::ArrayXd at = contact.pressure.array().max(floor);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::ArrayXd worn = coefficient * at.pow(m);
    contact = solve_with(softened(problem_, (slope * worn / at).matrix(), states), problem_.compliance.areas,
                         target - (1 - slope) * worn.matrix(), states);
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
