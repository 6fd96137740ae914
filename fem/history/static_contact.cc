#include "fem/history/static_contact.h"

#include <array>
#include <limits>

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

StaticContact solve_contact(const ContactProblem& problem, const Eigen::VectorXd& target,
                            std::vector<BoxState>& states) {
  const Eigen::Index n = problem.n_rings();
  const auto& areas = problem.compliance.areas;
  const auto solution =
      problem.solver.solve(areas.cwiseProduct(target), Eigen::VectorXd::Zero(n),
                           Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity()), states);
  return {solution.x, (-solution.residual.array() / areas.array()).matrix()};
}

StaticContact static_contact(const ContactProblem& problem, const Eigen::VectorXd& profile, double indentation) {
  std::vector<BoxState> contact(static_cast<std::size_t>(problem.n_rings()), BoxState::lower);
  for (Eigen::Index i = 0; i < profile.size(); ++i)
    if (profile[i] < indentation) contact[i] = BoxState::interior;
  return solve_contact(problem, (indentation - profile.array()).matrix(), contact);
}

}  // namespace fretval::fem
