#include "fem/full_model/full_history.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "fem/condensation/condensation.h"
#include "fem/history/friction_history.h"
#include "fem/operators/stiffness.h"
#include "fem/support/constants.h"
#include "tests/fem/expect_solver_error.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"
#include "tests/fem/recorded_history.h"

namespace fretval::fem::full_history_test {
namespace {

using Eigen::Index;

constexpr double mu = 0.5;
constexpr int n_steps = 12;
constexpr unsigned n_rings = 8;

/// One body, to be stepped whole and condensed.
struct Body {
  HarmonicSpace space;
  ContactProblem condensed;

  explicit Body(const FourierOrder& order)
      : space(quarter_disc_grid(1.125, n_rings, 4, 0.5), order, 2),
        condensed(contact_compliance(
            space.contact_line(),
            Condensation(assemble_stiffness(space), space.contact_line().dofs, "body").schur_complement())) {}
};

const Body& body(const FourierOrder& order) {
  static const Body normal(axisymmetric), tangential(lateral);
  return order == axisymmetric ? normal : tangential;
}

/// Two branches, one of them fast, and a dashpot.
RelaxationModel damped_branches() {
  return {0.7, {0.5, 0.8}, {2, 0.1}, 0.3};
}

/// Rings open and close, and slip comes and goes.
Motion wide_motion() {
  Motion motion = one_frequency(0.5, 0.35, 0.35, pi / 3);
  motion.n_ramp_cycles = 1;
  return motion;
}

/// Stops at the first chance: one cycle after the ramp, two for friction.
HistoryControl few_cycles() {
  return {n_steps, 5, 1e9};
}

Eigen::VectorXd profile() {
  return parabola_means(body(axisymmetric).condensed);
}

NormalRecord condensed_normal(const RelaxationModel& model) {
  return normal_history(body(axisymmetric).condensed, model, profile(), wide_motion(), few_cycles());
}

/// Pressures of the condensed history at the instants of n_cycles cycles.
Eigen::MatrixXd pressures_over(const NormalRecord& normal, int n_cycles) {
  Eigen::MatrixXd pressure(n_rings, 1 + n_cycles * n_steps);
  for (Index k = 0; k < pressure.cols(); ++k) pressure.col(k) = normal.pressure.col(normal.column(k));
  return pressure;
}

struct CondensedFriction {
  int n_cycles;
  Eigen::MatrixXd pressure, traction;  ///< from the start; of the last cycle
  Eigen::VectorXd first_slip_margin;
};

/// Of pressures alone: then a ring is held from the start of the step in which it touches, as in the full model.
CondensedFriction condensed_friction(const RelaxationModel& model, const NormalRecord& normal) {
  const int n_cycles = normal.n_cycles + 2;
  const Motion motion = wide_motion();
  const Eigen::MatrixXd pressure = pressures_over(normal, n_cycles);
  WatchedFriction friction(body(lateral).condensed, model, mu, motion, n_steps);
  for (Index k = 1; k < pressure.cols(); ++k) friction.step(pressure.col(k));
  FrictionHistory history;
  friction.first_slip.report(history);
  return {n_cycles, pressure, friction.period.traction(), history.first_slip_margin};
}

double largest_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

// Condensation is exact, so the difference is roundoff of the sparse solves: 2e-14 measured.
constexpr double roundoff = 1e-11;

FullNormalHistory full_normal(const RelaxationModel& model, int n_cycles) {
  return full_normal_history(body(axisymmetric).space, body(axisymmetric).condensed.series, model, profile(),
                             wide_motion(), n_steps, n_cycles);
}

FullFrictionHistory full_friction(const RelaxationModel& model, const Eigen::MatrixXd& pressure, int n_cycles) {
  return full_friction_history(body(lateral).space, model, mu, wide_motion(), pressure, n_steps, n_cycles);
}

// The same answer for a factorisation in every iteration.
TEST(FullHistory, FactorsAnewAsOftenAsItSolves) {
  const auto kept = full_normal(damped_branches(), 1);
  const auto anew =
      full_normal_history(body(axisymmetric).space, body(axisymmetric).condensed.series, damped_branches(), profile(),
                          wide_motion(), n_steps, 1, SparseFactors::made_anew);
  EXPECT_EQ(anew.count.n_factorisations, anew.count.n_solves);
  EXPECT_LT(kept.count.n_factorisations, kept.count.n_solves);
  EXPECT_LT(largest_difference(anew.pressure, kept.pressure), roundoff);
}

void expect_plausible(const SolveCount& count, const FourierOrder& order, Index n_instants) {
  EXPECT_EQ(count.n_dofs, body(order).space.n_dofs());
  EXPECT_GE(count.n_solves, n_instants);
  EXPECT_GT(count.n_factorisations, 10);  // the interior moves from step to step
  EXPECT_LE(count.n_factorisations, count.n_solves);
}

class FullHistoryOf : public testing::TestWithParam<RelaxationModel> {};

INSTANTIATE_TEST_SUITE_P(Bodies, FullHistoryOf,
                         testing::Values(elastic_body(), standard_solid(), kelvin_voigt(), damped_branches()));

TEST_P(FullHistoryOf, PressureIsThatOfTheCondensedBody) {
  const auto condensed = condensed_normal(GetParam());
  const auto full = full_normal(GetParam(), condensed.n_cycles);
  ASSERT_EQ(full.pressure.cols(), condensed.pressure.cols());
  EXPECT_LT(largest_difference(full.pressure, condensed.pressure), roundoff);
  const Eigen::Matrix<Index, 1, Eigen::Dynamic> n_touching = (condensed.pressure.array() > 0).colwise().count();
  EXPECT_LE(n_touching.minCoeff(), 3);  // rings open
  EXPECT_EQ(n_touching.maxCoeff(), 7);  // and close
  expect_plausible(full.count, axisymmetric, full.pressure.cols());
}

TEST_P(FullHistoryOf, TractionIsThatOfTheCondensedBody) {
  const auto normal = condensed_normal(GetParam());
  const auto condensed = condensed_friction(GetParam(), normal);
  const auto& pressure = condensed.pressure;
  const auto full = full_friction(GetParam(), pressure, condensed.n_cycles);
  EXPECT_LT(largest_difference(full.traction.rightCols(n_steps), condensed.traction), roundoff);
  const Eigen::ArrayXXd limit = mu * pressure.array(), margin = limit - full.traction.array().abs();
  EXPECT_LT((margin.rowwise().minCoeff().max(0).matrix() - condensed.first_slip_margin).cwiseAbs().maxCoeff(),
            roundoff);
  const Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> touching = limit > 0;
  EXPECT_GT((touching && margin > 1e-6).count(), 50);                    // instants and rings that stick,
  EXPECT_GT((touching && full.traction.array() >= limit).count(), 20);   // slip forwards
  EXPECT_GT((touching && full.traction.array() <= -limit).count(), 20);  // and backwards
  expect_plausible(full.count, lateral, full.traction.cols() - 1);
}

// A groove that stays open: a disc and a ring touch, and the full model supposes nothing of their order.
TEST_P(FullHistoryOf, OfAGroovedIndenterIsThatOfTheCondensedBody) {
  Eigen::VectorXd grooved = profile();
  grooved.segment(2, 2).array() += 0.4;
  const Motion motion = wide_motion();
  const auto& problem = body(axisymmetric).condensed;
  NormalContact contact(problem, GetParam(), grooved, motion, n_steps, ForceReading::sum_of_rings);
  std::vector<Eigen::VectorXd> pressures{contact.pressure};
  const auto normal = normal_history(std::move(contact), few_cycles(),
                                     [&](const NormalContact& now) { pressures.push_back(now.pressure); });
  Eigen::MatrixXd pressure(n_rings, static_cast<Index>(pressures.size()));
  for (Index k = 0; k < pressure.cols(); ++k) pressure.col(k) = pressures[static_cast<std::size_t>(k)];
  const auto full = full_normal_history(body(axisymmetric).space, body(axisymmetric).condensed.series, GetParam(),
                                        grooved, motion, n_steps, normal.n_cycles);
  EXPECT_LT(largest_difference(full.pressure, pressure), roundoff);
  const auto touching = (pressure.array() > 0).colwise().count();
  EXPECT_TRUE((pressure.middleRows(2, 2).array() == 0).all());
  EXPECT_GT((pressure.bottomRows(4).array() > 0).count(), 3);  // the outer ring comes,
  EXPECT_GT((pressure.row(4).array() == 0).count(), 0);        // and goes
  EXPECT_GT(touching.maxCoeff(), 3);

  WatchedFriction friction(body(lateral).condensed, GetParam(), mu, motion, n_steps);
  for (Index k = 1; k < pressure.cols(); ++k) friction.step(pressure.col(k));
  const auto history = friction_history(std::move(friction), normal, few_cycles());
  const auto n_cycles = static_cast<int>(history.n_steps / n_steps);
  Eigen::MatrixXd all(n_rings, 1 + n_cycles * n_steps);
  for (Index k = 0; k < all.cols(); ++k)
    all.col(k) =
        k < pressure.cols() ? Eigen::VectorXd(pressure.col(k)) : Eigen::VectorXd(normal.pressure.col(normal.column(k)));
  const auto slipping = full_friction(GetParam(), all, n_cycles);
  EXPECT_LT(largest_difference(slipping.traction.rightCols(n_steps), history.traction), roundoff);
  EXPECT_NEAR(history.force[0], history.traction.col(0).dot(problem.compliance.areas), 1e-14);
}

// The comparison above must notice a history that is a little wrong.
TEST(FullHistory, DependsOnEveryRelaxationTime) {
  const auto model = damped_branches();
  const auto normal = condensed_normal(model);
  const auto condensed = condensed_friction(model, normal);
  for (const std::size_t branch : {0, 1}) {
    auto other = model;
    other.times[branch] *= 1.001;
    EXPECT_GT(largest_difference(full_normal(other, normal.n_cycles).pressure, normal.pressure), 1e-5);
    const auto friction = full_friction(other, condensed.pressure, condensed.n_cycles);
    EXPECT_GT(largest_difference(friction.traction.rightCols(n_steps), condensed.traction), 1e-5);
  }
}

TEST(FullHistory, RefusesWhatDoesNotFit) {
  const auto& normal = body(axisymmetric).space;
  const auto& tangential = body(lateral).space;
  const auto model = elastic_body();
  const auto motion = wide_motion();
  const Eigen::VectorXd short_profile = profile().head(n_rings - 1);
  EXPECT_THROW(
      full_normal_history(tangential, body(axisymmetric).condensed.series, model, profile(), motion, n_steps, 1),
      std::invalid_argument);
  EXPECT_THROW(
      full_normal_history(normal, body(axisymmetric).condensed.series, model, short_profile, motion, n_steps, 1),
      std::invalid_argument);
  const Eigen::MatrixXd pressure = Eigen::MatrixXd::Ones(n_rings, 1 + n_steps);
  EXPECT_THROW(full_friction_history(normal, model, mu, motion, pressure, n_steps, 1), std::invalid_argument);
  EXPECT_THROW(full_friction_history(tangential, model, mu, motion, pressure, n_steps, 2), std::invalid_argument);
}

TEST(FullHistory, SaysWhenTheContactReachesTheEndOfTheLine) {
  Motion deep = wide_motion();
  deep.indentation = 1;
  expect_solver_error(
      [&] {
        full_normal_history(body(axisymmetric).space, body(axisymmetric).condensed.series, elastic_body(), profile(),
                            deep, n_steps, 2);
      },
      {"end of the contact line", "longer"});
}

}  // namespace
}  // namespace fretval::fem::full_history_test
