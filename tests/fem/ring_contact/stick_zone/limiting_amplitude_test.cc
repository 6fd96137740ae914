#include "fem/ring_contact/stick_zone/limiting_amplitude.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "fem/history/friction_history.h"
#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::limiting_amplitude_test {
namespace {

using Eigen::Index;

constexpr int n_rings = 64;
constexpr Index n_inside = 32;
constexpr double mu = 0.5, edge = 0.5;

/// A parabola that ends at half of the radius, where pressure and traction are singular.
class LimitingAmplitudeTest : public testing::Test {
 protected:
  const ContactProblem &normal_ = normal_half_space(n_rings), &tangential_ = tangential_half_space(n_rings);
  const Eigen::VectorXd profile_ = ring_means(normal_.compliance, [](double r) { return r < edge ? r * r / 2 : 10.0; });

  [[nodiscard]] NormalHistory normal(const RelaxationModel& body, const Motion& motion,
                                     const HistoryControl& control) const {
    return normal_history(NormalContact(normal_, body, profile_, motion, control.steps_per_cycle), control);
  }
};

Motion with_ramp(Motion motion) {
  motion.n_ramp_cycles = 4;
  return motion;
}

/// g(r) = r^2 = d0 - (rho/2) (|A e^(i phi) - Delta d| + |A e^(i phi) + Delta d|), solved for u_x0 = 3 mu A/2; unlocked:
/// r^2 = d0 - rho (A + Delta d).
double exact_amplitude(const RelaxationModel& body, const Motion& motion, double r) {
  const double available = (motion.indentation - r * r) / std::abs(complex_modulus(body));
  if (!motion.locked) return 1.5 * mu * (available - motion.normal[0].amplitude);
  const double other_axis = std::sqrt(available * available - motion.normal[0].amplitude * motion.normal[0].amplitude);
  return 1.5 * mu /
         std::hypot(std::cos(motion.tangential[0].phase) / available,
                    std::sin(motion.tangential[0].phase) / other_axis);
}

// The depth of the last ring belongs to its middle. What is left are the minima between 72 samples of a cycle and the
// effective radii, h^2 = 2e-4; single rings are off by 3e-2.
TEST_F(LimitingAmplitudeTest, IsThatOfTwoTangentsToTheLoop) {
  const HistoryControl control{72, 400, 1e-7};
  const double middle = normal_.series.radii()[n_inside - 1];
  const auto error_of = [&](const RelaxationModel& body, const Motion& motion) {
    const double factor =
        limiting_amplitude(normal_, tangential_, body, mu, motion, normal(body, motion, control), n_inside);
    return factor * motion.tangential[0].amplitude / exact_amplitude(body, motion, middle) - 1;
  };
  for (const auto& body : {elastic_body(), standard_solid(), kelvin_voigt(), three_branches()})
    for (const double phase : {0.0, pi / 4, pi / 2, 2.5})
      EXPECT_NEAR(error_of(body, with_ramp(one_frequency(0.8, 0.2, 0.1, phase))), 0, 2e-4) << phase;
  EXPECT_NEAR(error_of(elastic_body(), with_ramp(one_frequency(0.8, 0.2, 0.1, std::nullopt))), 0, 2e-4);
}

// A percent below nothing slips but what dies out, a percent above every cycle does. Rings of 1/64 show no less: slip
// begins with one of them.
TEST_F(LimitingAmplitudeTest, IsWhereHistoriesBeginToSlip) {
  const HistoryControl control{72, 400, 1e-7};
  for (const auto& body : {elastic_body(), standard_solid(), kelvin_voigt()}) {
    const Motion motion = with_ramp(one_frequency(0.8, 0.2, 0.1, pi / 4));
    const double factor =
        limiting_amplitude(normal_, tangential_, body, mu, motion, normal(body, motion, control), n_inside);
    const auto slip_at = [&](double times) {
      Motion other = motion;
      other.tangential[0].amplitude *= times * factor;
      const auto both =
          contact_history(NormalContact(normal_, body, profile_, other, control.steps_per_cycle),
                          WatchedFriction(tangential_, body, mu, other, control.steps_per_cycle), control);
      return both.friction.period_slip.head(n_inside).maxCoeff() / other.tangential[0].amplitude;
    };
    EXPECT_LT(slip_at(0.99), 1e-6);
    EXPECT_GT(slip_at(1.01), 1e-4);
  }
}

TEST_F(LimitingAmplitudeTest, IsNoneWhereARingLosesContact) {
  const HistoryControl control{36, 400, 1e-7};
  const Motion motion = with_ramp(one_frequency(0.5, 0.3, 0.1, 0.0));  // at the edge d0 - Delta d is less than g
  EXPECT_EQ(limiting_amplitude(normal_, tangential_, elastic_body(), mu, motion,
                               normal(elastic_body(), motion, control), n_inside),
            0);
}

}  // namespace
}  // namespace fretval::fem::limiting_amplitude_test
