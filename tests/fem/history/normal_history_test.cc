
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <utility>
#include <vector>

#include "fem/ring_contact/contact_events.h"
#include "fem/ring_contact/stick_zone/contact_radius.h"
#include "fem/support/constants.h"
#include "tests/fem/convergence.h"
#include "tests/fem/expect_solver_error.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"
#include "tests/fem/recorded_history.h"
#include "tests/worse.h"

namespace fretval::fem::normal_history_test {
namespace {

using Eigen::Index;

double largest_over_last_cycle(const NormalRecord& history, const std::function<double(Index)>& value) {
  double largest = 0;
  for (Index k = history.time.size() - history.steps_per_cycle; k < history.time.size(); ++k)
    largest = std::max(largest, value(k));
  return largest;
}

// All rings inside r = 0.75 touch all the time, so nothing is left of the contact problem but the complex modulus:
// F(t) = F_1 [d0 + Re(G Dd e^{it})], F_1 the elastic force of a unit indentation. Measured: 3e-9, the interpolated rate
// and what is left of the transient.
TEST(NormalHistory, OfAFlatPunchFollowsTheComplexModulus) {
  const auto& problem = normal_half_space(32);
  const Eigen::VectorXd profile = ring_means(problem.compliance, [](double r) { return r < 0.75 ? 0.0 : 10.0; });
  const double elastic_force = static_contact(problem, profile, 1).pressure.dot(problem.compliance.areas);
  for (const auto& model : {elastic_body(), standard_solid(), kelvin_voigt(), three_branches()}) {
    const auto history = normal_history(problem, model, profile, fretting_motion(), {});
    const double error = largest_over_last_cycle(history, [&](Index k) {
      const auto modulus_now = complex_modulus(model) * std::exp(std::complex<double>(0, history.time[k]));
      return std::abs(history.force[k] / elastic_force - 0.8 - 0.2 * modulus_now.real());
    });
    EXPECT_LT(error, 1e-7);
    EXPECT_EQ(history.smallest_gap.head(24).cwiseAbs().maxCoeff(), 0);
  }
}

TEST(NormalHistory, OfAnElasticBodyIsTheStaticContactAtEveryInstant) {
  const auto& problem = normal_half_space(64);
  const Eigen::VectorXd profile = parabola_means(problem);
  const auto history = normal_history(problem, elastic_body(), profile, fretting_motion(), {});
  double worst = 0;
  for (Index k = 0; k < history.time.size(); k += 37) {
    const auto contact = static_contact(problem, profile, history.indentation[k]);
    worst = worse(worst, (history.pressure.col(k) - contact.pressure).cwiseAbs().maxCoeff());
    EXPECT_DOUBLE_EQ(history.indentation[k], normal_motion(fretting_motion(), history.time[k]).value);
  }
  EXPECT_LT(worst, 1e-11);
}

/// Second method: MDR's independent springs below a parabola, `F = 8 int w dx` with `w = int G(t-t') du/dt' dt' >= 0`,
/// of first order in time.
class Springs {
 public:
  Springs(const RelaxationModel& model, double dt, double indentation)
      : n_branches_(model.times.size()),
        stiffness_(model.relaxed + model.viscosity / dt),
        drag_(model.viscosity / dt),
        memory_(n_springs * n_branches_) {
    for (std::size_t i = 0; i < n_branches_; ++i) {
      const double z = dt / model.times[i];
      decay_.push_back(std::exp(-z));
      gain_.push_back(-model.moduli[i] * std::expm1(-z) / z);
      stiffness_ += gain_[i];
    }
    for (std::size_t j = 0; j < n_springs; ++j) displacement_.push_back(std::max(0.0, indentation - depth(j)));
  }

  /// Force after a step to this indentation.
  double step(double indentation) {
    double force = 0;
    for (std::size_t j = 0; j < n_springs; ++j) {
      double& u = displacement_[j];
      double* memory = memory_.data() + j * n_branches_;
      double rest = -drag_ * u;  // w = stiffness * u_new + rest, and a free spring has w = 0
      for (std::size_t i = 0; i < n_branches_; ++i) rest += decay_[i] * memory[i] - gain_[i] * u;
      const double u_new = std::max(-rest / stiffness_, indentation - depth(j));
      for (std::size_t i = 0; i < n_branches_; ++i) memory[i] = decay_[i] * memory[i] + gain_[i] * (u_new - u);
      u = u_new;
      force += 8 * (stiffness_ * u_new + rest) * width;
    }
    return force;
  }

 private:
  static constexpr std::size_t n_springs = 400;
  static constexpr double width = 1.02 / n_springs;

  /// g(x) = x^2 at spring j.
  static double depth(std::size_t j) { return std::pow(width * (static_cast<double>(j) + 0.5), 2); }

  std::size_t n_branches_;
  double stiffness_, drag_;
  std::vector<double> displacement_, memory_, decay_, gain_;
};

/// Largest difference of the force to that of the springs over the last cycle, relative to its largest value. The
/// springs make 16 steps to one of the history; between them their force is interpolated.
double difference_to_springs(const NormalRecord& history, const RelaxationModel& model, const Motion& motion) {
  const double dt = 2 * pi / history.steps_per_cycle / 16;
  Springs springs(model, dt, motion.indentation);
  double worst = 0, force = 0, force_before = 0;
  const Index n = history.time.size();
  long step = 0;
  for (Index k = 1; k < n; ++k) {
    while (static_cast<double>(step) * dt < history.time[k]) {
      ++step;
      force_before = std::exchange(force, springs.step(normal_motion(motion, static_cast<double>(step) * dt).value));
    }
    if (k < n - history.steps_per_cycle) continue;
    const double weight = static_cast<double>(step) - history.time[k] / dt;
    worst = worse(worst, std::abs(history.force[k] - (1 - weight) * force - weight * force_before));
  }
  return worst / history.force.maxCoeff();
}

// Half-space and springs are the same by MDR: 5e-5 elastic, 9e-5 standard solid, h^2 and dt^2.
TEST(NormalHistory, ForceIsThatOfIndependentSprings) {
  const auto& problem = normal_half_space(64);
  for (const auto& model : {elastic_body(), standard_solid(), kelvin_voigt()}) {
    const auto history = normal_history(problem, model, parabola_means(problem), fretting_motion(), {});
    const double difference = difference_to_springs(history, model, fretting_motion());
    // With a dashpot the force jumps with every ring: half a jump is 4 viscosity h times the speed (1.9e-3 measured).
    EXPECT_LT(difference, model.viscosity > 0 ? 4 * model.viscosity / 64 * 0.2 / history.force.maxCoeff() : 2e-4);
  }
}

// Where the contact is largest the surface was never deeper before in the cycle, so a = sqrt(R d_max) for any
// rheology: 1.4e-5 measured.
TEST(NormalHistory, LargestContactRadiusIsTheElasticOne) {
  const auto& problem = normal_half_space(64);
  const auto events = contact_events(problem.compliance, parabola_means(problem));
  for (const auto& model : {elastic_body(), standard_solid(), kelvin_voigt()}) {
    const auto history = normal_history(problem, model, parabola_means(problem), fretting_motion(), {});
    const double radius = largest_contact_radius(history.smallest_gap, events).radius;
    EXPECT_NEAR(radius, 1, 5e-5);
  }
}

// Rings that touch lie on the indenter: at the deepest point, and at every balance time, which a dashpot puts between
// two steps.
TEST(NormalHistory, RingsThatTouchLieOnTheIndenter) {
  const auto& problem = normal_half_space(32);
  const Eigen::VectorXd profile = parabola_means(problem);
  const auto history = normal_history(problem, standard_solid(), profile, fretting_motion(), {});
  EXPECT_NEAR(history.deepest_displacement[3], 1 - profile[3], 1e-12);
  for (const auto& model : {standard_solid(), kelvin_voigt()}) {
    const auto course = normal_history(problem, model, profile, fretting_motion(), {}).cycle;
    for (Eigen::Index k = 0; k < course.indentation.size(); ++k)
      EXPECT_NEAR(course.displacement(3, k), course.indentation[k] - profile[3], 1e-12) << k;
  }
}

// Also where it is free: of an elastic body displacements are those of its pressures. Roundoff of the active set.
TEST(NormalHistory, DisplacementsOfAnElasticBodyFollowFromItsPressures) {
  const auto& problem = normal_half_space(32);
  const auto history = normal_history(problem, elastic_body(), parabola_means(problem), fretting_motion(), {}).cycle;
  const Eigen::MatrixXd expected =
      problem.compliance.areas.cwiseInverse().asDiagonal() * (*problem.compliance.matrix * history.pressure);
  EXPECT_LT((history.displacement - expected).cwiseAbs().maxCoeff(), 1e-10);
}

// Below a flat punch nothing but the indentation changes, so a ring that never touches moves in proportion to it,
// whatever the rheology, at every balance time. A ring moves linearly in a step, off by dt^2/8 of its curvature.
TEST(NormalHistory, FreeRingsFollowAFlatPunchInProportion) {
  const auto& problem = normal_half_space(16);
  const Eigen::VectorXd profile = ring_means(problem.compliance, [](double r) { return r < 0.75 ? 0.0 : 10.0; });
  const double share = static_contact(problem, profile, 1).gap[13] + 1 - profile[13];
  const double off = 0.2 * std::pow(2 * pi / 180, 2) / 8;
  for (const auto& model : {standard_solid(), kelvin_voigt()}) {
    const auto course = normal_history(problem, model, profile, fretting_motion(), {}).cycle;
    for (Index k = 0; k < course.indentation.size(); ++k)
      EXPECT_NEAR(course.displacement(13, k), share * course.indentation[k], off) << k;
  }
}

/// Plain sum over the rings: what steps are taken, without how the edge is read.
double mean_force(const RelaxationModel& model, double amplitude, int n_steps) {
  HistoryControl control;
  control.steps_per_cycle = n_steps;
  const auto& problem = normal_half_space(32);
  Motion motion = fretting_motion();
  motion.normal[0].amplitude = amplitude;
  const auto history = normal_history(problem, model, parabola_means(problem), motion, control);
  return (history.pressure.rightCols(n_steps).transpose() * problem.compliance.areas).mean();
}

// Every ring that comes or goes adds an error of dt^2 that depends on where in the step it does, so the errors scatter:
// the mean over ten amplitudes does less. Orders 2.3 and 1.7, 2e-6 at 80 steps.
TEST(NormalHistory, IsOfSecondOrderInTime) {
  for (const auto& model : {standard_solid(), kelvin_voigt()}) {
    std::vector<double> errors(4, 0);
    for (int k = 0; k < 10; ++k) {
      const double amplitude = 0.1 + 0.01 * k;
      const double reference = mean_force(model, amplitude, 640);
      for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i] += std::abs(mean_force(model, amplitude, 20 << i) / reference - 1) / 10;
    }
    EXPECT_GT(observed_order(errors), 1.5);
  }
}

double largest_force(const NormalRecord& history) {
  return largest_over_last_cycle(history, [&](Index k) { return history.force[k]; });
}

// Rings of a stiff branch lift and touch again in every step: 6e-3 off at 32 steps, and 1.5e-3 at 64, if they are taken
// to move at a constant rate in the step in which they do.
TEST(NormalHistory, ForceOfAStiffBranchKnowsWhenRingsLiftAndTouch) {
  const auto& problem = normal_half_space(32);
  const RelaxationModel stiff{1, {19}, {1.6}, 0};
  const auto force = [&](int n_steps) {
    HistoryControl control;
    control.steps_per_cycle = n_steps;
    return largest_force(
        normal_history(problem, stiff, parabola_means(problem), one_frequency(0.67, 0.33, 0, 0.0), control));
  };
  const double reference = force(512);
  EXPECT_NEAR(force(32) / reference, 1, 5e-4);
  EXPECT_NEAR(force(64) / reference, 1, 3e-4);
}

// A body that creeps for 320 cycles: one of them changes its forces by less than 1e-4 long before it has settled. Taken
// for periodic by that change alone, its force is 3e-3 off.
TEST(NormalHistory, FollowsASlowCreepToItsEnd) {
  const auto& problem = normal_half_space(16);
  const RelaxationModel slow{1, {1}, {1000}, 0};
  const auto profile = parabola_means(problem);
  HistoryControl loose{24, 400, 1e-4}, tight{24, 400, 1e-7};
  const auto history = normal_history(problem, slow, profile, fretting_motion(), loose);
  EXPECT_LT(history.n_cycles, 200);
  EXPECT_NEAR(largest_force(history) / largest_force(normal_history(problem, slow, profile, fretting_motion(), tight)),
              1, 2e-4);
}

TEST(NormalHistory, RepeatsItsLastCycle) {
  NormalHistory history;
  history.steps_per_cycle = 4;
  history.n_cycles = 3;
  for (long step = 9; step <= 12; ++step)
    for (const long cycles : {0, 1, 2, 50}) EXPECT_EQ(history.column(step + 4 * cycles), step - 9);
}

TEST(NormalHistory, KeepsTheLastCycle) {
  const auto& problem = normal_half_space(16);
  for (const auto& model : {elastic_body(), standard_solid()}) {
    const auto record = normal_history(problem, model, parabola_means(problem), fretting_motion(), {});
    EXPECT_EQ(record.cycle.pressure, Eigen::MatrixXd(record.pressure.rightCols(180)));
  }
}

TEST(NormalHistory, SaysWhenItIsNotPeriodic) {
  const auto& problem = normal_half_space(16);
  HistoryControl control;
  control.max_cycles = 1;
  const auto compute = [&] {
    normal_history(problem, standard_solid(), parabola_means(problem), fretting_motion(), control);
  };
  expect_solver_error(compute, {"normal response is not periodic", "1 cycles", "1.0e-07"});
  control.max_cycles = 11;
  control.periodicity = 1e-14;
  expect_solver_error(compute, {"normal response is not periodic", "11 cycles", "1.0e-14"});
  const RelaxationModel endless{1, {1e6}, {1e6}, 0};
  expect_solver_error(
      [&] {
        normal_history(problem, endless, parabola_means(problem), fretting_motion(), {24, 30, 1e-4});
      },
      {"the body creeps for 1.59e+11 cycles", "set the Duration of the test"});
}

// The indenter stays above the surface: no force, and no division by it.
TEST(NormalHistory, WithoutContactHasNoForce) {
  const auto& problem = normal_half_space(16);
  Motion motion = fretting_motion();
  motion.indentation = -2 * motion.normal[0].amplitude;
  for (const auto& body : {elastic_body(), standard_solid()}) {
    const auto history = normal_history(problem, body, parabola_means(problem), motion, {});
    EXPECT_EQ(history.force.cwiseAbs().maxCoeff(), 0);
    EXPECT_EQ(history.pressure.cwiseAbs().maxCoeff(), 0);
    EXPECT_TRUE(history.deepest_displacement.allFinite());
  }
}

TEST(NormalHistory, NeedsNoRamp) {
  const auto& problem = normal_half_space(16);
  Motion motion = fretting_motion();
  motion.n_ramp_cycles = 0;
  const auto history = normal_history(problem, elastic_body(), parabola_means(problem), motion, {});
  EXPECT_EQ(history.n_cycles, 2);
  EXPECT_LT(history.periodicity, 1e-12);
}

TEST(NormalHistory, DependsOnAmplitudeAndRheology) {
  const auto& problem = normal_half_space(16);
  const auto peak = [&](const RelaxationModel& model, double amplitude) {
    Motion motion = fretting_motion();
    motion.normal[0].amplitude = amplitude;
    return normal_history(problem, model, parabola_means(problem), motion, {}).force.maxCoeff();
  };
  EXPECT_GT(peak(standard_solid(), 0.2) / peak(standard_solid(), 0), 1.2);
  EXPECT_GT(peak(standard_solid(), 0.2) / peak(elastic_body(), 0.2), 1.05);
  EXPECT_GT(std::abs(peak(standard_solid(), 0.2) / peak(kelvin_voigt(), 0.2) - 1), 0.005);
}

TEST(RingMeans, AreExactForPolynomials) {
  const auto& compliance = normal_half_space(16).compliance;
  const Eigen::VectorXd means = ring_means(compliance, [](double r) { return r * r + std::pow(r, 8); });
  for (Index i = 0; i < means.size(); ++i) {
    const double a = compliance.radii[i], b = compliance.radii[i + 1];
    const double integral = (std::pow(b, 4) - std::pow(a, 4)) / 4 + (std::pow(b, 10) - std::pow(a, 10)) / 10;
    EXPECT_NEAR(means[i], 2 * integral / (b * b - a * a), 1e-14);
  }
}

}  // namespace
}  // namespace fretval::fem::normal_history_test
