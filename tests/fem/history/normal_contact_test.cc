#include "fem/history/normal_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fem/expect_solver_error.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::normal_contact_test {
namespace {

Motion without_ramp() {
  Motion motion = fretting_motion();
  motion.n_ramp_cycles = 0;
  return motion;
}

class NormalContactTest : public testing::Test {
 protected:
  const ContactProblem& problem_ = normal_half_space(32);
  const Eigen::VectorXd profile_ = parabola_means(problem_);
};

// a = sqrt(d), F = (16/3) d^1.5 on the way in and out. Of the rings, third order: 7e-7 of the force, 1e-5 of the
// radius.
TEST_F(NormalContactTest, OfAnElasticBodyIsHertzAtEveryStep) {
  const auto body = elastic_body();
  const Motion motion = without_ramp();
  NormalContact contact(problem_, body, profile_, motion, 36);
  for (int k = 0; k <= 36; ++k) {
    const double d = contact.indentation;
    EXPECT_NEAR(contact.reading.force / (16.0 / 3 * std::pow(d, 1.5)), 1, 3e-6) << k;
    EXPECT_NEAR(contact.reading.radius, std::sqrt(d), 1e-5) << k;
    contact.step();
  }
}

// Begins relaxed: nothing is left to creep. Of Hertz as above, of rest roundoff.
TEST_F(NormalContactTest, AtRestStaysAtRest) {
  Motion motion = fretting_motion();
  motion.normal[0].amplitude = 0;
  for (RelaxationModel model : {elastic_body(), standard_solid(), kelvin_voigt(), three_branches()}) {
    model.relaxed = 2;
    NormalContact contact(problem_, model, profile_, motion, 36);
    const Eigen::VectorXd begin = contact.pressure;
    EXPECT_NEAR(contact.reading.force / (2 * 16.0 / 3 * std::pow(0.8, 1.5)), 1, 3e-6);
    for (int k = 0; k < 20; ++k) contact.step();
    EXPECT_LT((contact.pressure - begin).cwiseAbs().maxCoeff(), 1e-12 * begin.maxCoeff());
    EXPECT_NEAR(contact.reading.force / (2 * 16.0 / 3 * std::pow(0.8, 1.5)), 1, 3e-6);
  }
}

// Signorini: nothing pulls, nothing overlaps, only what touches presses. Roundoff.
TEST_F(NormalContactTest, PressesWhereItTouchesAndNowhereElse) {
  const Motion motion = without_ramp();
  for (const auto& model : {elastic_body(), standard_solid(), kelvin_voigt(), three_branches()}) {
    NormalContact contact(problem_, model, profile_, motion, 36);
    for (int k = 0; k < 36; ++k) {
      contact.step();
      EXPECT_GE(contact.pressure.minCoeff(), 0);
      EXPECT_GE(contact.gap.minCoeff(), -1e-14);
      EXPECT_EQ(contact.gap.cwiseProduct(contact.pressure).cwiseAbs().maxCoeff(), 0) << k;
      const Eigen::VectorXd overlap = contact.state.displacement + profile_ - contact.gap;
      EXPECT_LT((overlap.array() - contact.indentation).abs().maxCoeff(), 1e-14) << k;
    }
  }
}

// A ring loses k p^m of its height in a step, and the surface closes what that leaves: gaps are those of the worn
// profile over the displaced surface. Roundoff.
TEST_F(NormalContactTest, WearsByThePressureOfTheStep) {
  const Motion motion = without_ramp();
  for (const auto& model : {elastic_body(), standard_solid(), kelvin_voigt()})
    for (const double exponent : {1.0, 2.0}) {
      NormalContact contact(problem_, model, profile_, motion, 36);
      const Eigen::VectorXd coefficient = Eigen::VectorXd::LinSpaced(profile_.size(), 0, 1e-3);
      for (int k = 0; k < 6; ++k) {
        const Eigen::VectorXd before = contact.profile;
        contact.step({coefficient, exponent});
        const Eigen::VectorXd worn = coefficient.cwiseProduct(contact.pressure.array().max(0).pow(exponent).matrix());
        EXPECT_LT((contact.profile - before - worn).cwiseAbs().maxCoeff(), 1e-14);
        const Eigen::ArrayXd gap = (contact.state.displacement + contact.profile).array() - contact.indentation;
        EXPECT_LT((gap - contact.gap.array()).abs().maxCoeff(), 1e-9) << exponent;
        EXPECT_LT(contact.pressure.cwiseProduct(contact.gap).cwiseAbs().maxCoeff(), 1e-12);
      }
      EXPECT_GT((contact.profile - profile_).maxCoeff(), 1e-4);
    }
}

TEST_F(NormalContactTest, SaysWhenTheContactLineIsTooShort) {
  const auto body = elastic_body();
  Motion motion = without_ramp();
  motion.indentation = 1.2;  // a = sqrt(1.4) at its deepest, the line is 1.125 long
  NormalContact contact(problem_, body, profile_, motion, 36);
  expect_solver_error([&] { contact.step(); }, {"end of the contact line", "longer"});
}

}  // namespace
}  // namespace fretval::fem::normal_contact_test
