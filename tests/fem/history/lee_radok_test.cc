#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "tests/fem/convergence.h"
#include "tests/fem/half_space.h"
#include "tests/fem/recorded_history.h"
#include "tests/worse.h"

namespace fretval::fem::lee_radok_test {
namespace {

const RelaxationModel elastic{1, {}, {}, 0};
const RelaxationModel standard_solid{1, {2}, {0.4}, 0};
const RelaxationModel kelvin_voigt{1, {}, {}, 0.3};

/// A parabola pressed in by d(t) = t until t = 1, where the contact radius is 1.
ValueAndRate ramp(double t) {
  return {t, 1};
}

struct Loading {
  std::vector<double> time, force;  // at the balance times
};

Loading press(const ContactProblem& problem, const RelaxationModel& model, int n_steps) {
  const Eigen::Index n = problem.n_rings();
  const auto& areas = problem.compliance.areas;
  const Eigen::VectorXd profile = ring_means(problem.compliance, [](double r) { return r * r / 2; });
  const Eigen::VectorXd infinite = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity());
  const double dt = 1.0 / n_steps;
  const RelaxationStep step(model, dt);
  RingState state{Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(model.times.size()))};
  std::vector<BoxState> contact(static_cast<std::size_t>(n), BoxState::lower);
  Loading loading;
  for (int k = 0; k < n_steps; ++k) {
    const double begin = k * dt, balance = begin + step.fraction() * dt;
    const Eigen::VectorXd gap = (state.displacement + profile).array() - ramp(begin).value;
    const Eigen::VectorXd held = step.response_without_slip(state, indenter_move(ramp, begin, balance));
    const Eigen::VectorXd load = areas.cwiseProduct(held - step.instantaneous() * gap);
    const auto solution = problem.solver.solve(load, Eigen::VectorXd::Zero(n), infinite, contact);
    const Eigen::VectorXd new_gap = -solution.residual.cwiseQuotient(areas) / step.instantaneous();
    step.advance(state, indenter_move(ramp, begin, begin + dt), gap - new_gap);
    loading.time.push_back(balance);
    loading.force.push_back(solution.x.dot(areas));
  }
  return loading;
}

/// `int_0^t G(t - t') dF`, F the elastic force of unit modulus as a function of d = t (Lee & Radok 1960, valid while
/// the contact grows), by the midpoint rule in s with t' = t s^2.
double lee_radok(const RelaxationModel& model, const std::function<double(double)>& elastic_force, double t) {
  const int n = 1000;
  double sum = model.relaxed * elastic_force(t), before = 0;
  for (int k = 1; k <= n; ++k) {
    const double middle = t * std::pow((k - 0.5) / n, 2), force = elastic_force(t * std::pow(k * 1.0 / n, 2));
    for (std::size_t i = 0; i < model.times.size(); ++i)
      sum += model.moduli[i] * std::exp(-(t - middle) / model.times[i]) * (force - before);
    before = force;
  }
  const double h = 1e-4 * t;
  return sum + model.viscosity * (elastic_force(t + h) - elastic_force(t - h)) / (2 * h);
}

double hertz_force(double d) {
  return 16.0 / 3 * d * std::sqrt(d);
}

/// Largest error over 0.3 < t < 1 relative to the final force.
double error_of(const RelaxationModel& model, const Loading& loading,
                const std::function<double(double)>& elastic_force) {
  double worst = 0;
  const std::size_t stride = std::max<std::size_t>(1, loading.time.size() / 20);
  for (std::size_t k = loading.time.size() - 1; loading.time[k] > 0.3; k -= stride)
    worst = worse(worst, std::abs(loading.force[k] - lee_radok(model, elastic_force, loading.time[k])));
  return worst / lee_radok(model, elastic_force, 1);
}

// Elements and steps together: 6e-5 elastic, 9e-5 with memory.
TEST(LeeRadok, ForceOfTheHalfSpace) {
  for (const auto& model : {elastic, standard_solid}) {
    const double error = error_of(model, press(normal_half_space(64), model, 200), hertz_force);
    EXPECT_LT(error, 2e-4);
  }
}

// With a dashpot the force holds viscosity dF/dd, which jumps by 8 h with every ring: half a jump is the error at an
// instant, of first order in h.
TEST(LeeRadok, ForceOfAKelvinVoigtBodyRisesInSteps) {
  for (const unsigned n : {32U, 64U}) {
    const double half_a_jump = kelvin_voigt.viscosity * 8 / n / 2 / lee_radok(kelvin_voigt, hertz_force, 1);
    const double error = error_of(kelvin_voigt, press(normal_half_space(n), kelvin_voigt, 1000), hertz_force);
    EXPECT_LT(error, 1.3 * half_a_jump);
  }
}

/// Integral of the force over time.
double impulse(const ContactProblem& problem, const RelaxationModel& model, int n_steps) {
  double sum = 0;
  for (const double force : press(problem, model, n_steps).force) sum += force / n_steps;
  return sum;
}

// The steps leave no trace in the impulse, int F dt = int F_el dt + viscosity F_el(1) = 32/15 + 16/3 viscosity: 1.4e-5
// measured.
TEST(LeeRadok, ImpulseOfAKelvinVoigtBody) {
  const double expected = 32.0 / 15 + 16.0 / 3 * kelvin_voigt.viscosity;
  EXPECT_NEAR(impulse(normal_half_space(64), kelvin_voigt, 400) / expected, 1, 5e-5);
}

/// Elastic force of the parabola on the rings of a body.
std::function<double(double)> force_of_rings(const ContactProblem& problem) {
  return [&problem, profile = ring_means(problem.compliance, [](double r) { return r * r / 2; })](double d) {
    return static_contact(problem, profile, d).pressure.dot(problem.compliance.areas);
  };
}

// Order 2.1. Time alone: against Lee and Radok's integral over the elastic force of the same rings.
TEST(LeeRadok, StandardSolidIsOfSecondOrderInTime) {
  const auto& problem = normal_half_space(16);
  std::vector<double> errors;
  for (const int n : {20, 40, 80, 160})
    errors.push_back(error_of(standard_solid, press(problem, standard_solid, n), force_of_rings(problem)));
  EXPECT_GT(observed_order(errors), 1.8);
}

// Order 2.0.
TEST(LeeRadok, ImpulseOfAKelvinVoigtBodyIsOfSecondOrderInTime) {
  const auto& problem = normal_half_space(16);
  const auto force = force_of_rings(problem);
  double expected = kelvin_voigt.viscosity * force(1);
  for (int k = 0; k < 4000; ++k) expected += force((k + 0.5) / 4000) / 4000;
  std::vector<double> errors;
  for (const int n : {20, 40, 80, 160, 320}) errors.push_back(impulse(problem, kelvin_voigt, n) / expected - 1);
  EXPECT_GT(observed_order(errors), 1.8);
}

TEST(LeeRadok, MemoryMatters) {
  const auto with = press(normal_half_space(16), standard_solid, 50),
             without = press(normal_half_space(16), elastic, 50);
  EXPECT_GT(with.force.back() / without.force.back(), 1.5);
}

}  // namespace
}  // namespace fretval::fem::lee_radok_test
