#include "mdr/wear/wear_jump.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/mdr/measured_cycle.h"

namespace fretval::mdr::wear_jump_test {
namespace {

const double accuracy = 1e-14;

// One spring of width 1 under one ring: image 1, stress 2/pi.
double worn_of_one_spring(const Eigen::RowVectorXd& path, const Eigen::RowVectorXd& load, double room, double work) {
  const AbelMatrices matrices = abel_matrices(spring_bed([](double) { return 0.0; }, 1, 1));
  return (*wear_jump(matrices, {path, load, 0, 0, 0}, Eigen::ArrayXd::Constant(1, room), work, accuracy))[0];
}

Eigen::RowVectorXd instants(double first, double second) {
  return (Eigen::RowVectorXd(2) << first, second).finished();
}

// dw = c (q - dw) with c = work stress path; where the first instant is relieved, the second wears on alone.
TEST(WearJump, OfOneElasticSpringHasItsClosedForm) {
  const double c = 0.7, work = c / (2 / M_PI);
  EXPECT_NEAR(worn_of_one_spring(instants(1, 0), instants(0.3, 0.3), 0.3, work), c * 0.3 / (1 + c), accuracy);
  EXPECT_NEAR(worn_of_one_spring(instants(1, 1), instants(0.2, 0.3), 0.3, work), c * 0.5 / (1 + 2 * c), accuracy);
  EXPECT_NEAR(worn_of_one_spring(instants(1, 1), instants(0.01, 0.3), 0.3, work), c * 0.3 / (1 + c), accuracy);
  EXPECT_NEAR(worn_of_one_spring(instants(1, 1), instants(-0.2, 0.3), 0.3, work), c * 0.3 / (1 + c), accuracy);
}

// Loaded by q > room: dw = c q (1 - dw/room), which ends at the room instead of at q.
TEST(WearJump, EndsWhereTheSpringIsOutOfReach) {
  const double c = 0.7, work = c / (2 / M_PI), q = 0.9, room = 0.3;
  EXPECT_NEAR(worn_of_one_spring(instants(1, 0), instants(q, q), room, work), c * q / (1 + c * q / room), accuracy);
  EXPECT_NEAR(worn_of_one_spring(instants(1, 0), instants(q, q), room, 1e12), room, 1e-11);
  EXPECT_EQ(worn_of_one_spring(instants(1, 1), instants(q, q), 0, work), 0);
  EXPECT_EQ(worn_of_one_spring(instants(1, 1), instants(q, q), -0.1, work), 0);
}

TEST(WearJump, NothingWearsWithoutSlip) {
  EXPECT_EQ(worn_of_one_spring(instants(0, 0), instants(0.3, 0.3), 0.3, 1e12), 0);
  EXPECT_EQ(worn_of_one_spring(instants(1, 1), instants(0.3, 0.3), 0.3, 0), 0);
}

// The equation of the header, written out, for springs of all kinds: loaded, parted and out of reach.
TEST(WearJump, SolvesItsEquation) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const Eigen::Index n = 12, n_instants = 5;
  const AbelMatrices matrices = abel_matrices(spring_bed(parabola(1), 1, n));
  for (int trial = 0; trial < 20; ++trial) {
    WearCycle cycle{Eigen::MatrixXd::Zero(n, n_instants), Eigen::MatrixXd(n, n_instants), 0, 0, 0};
    Eigen::ArrayXd room(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      room[j] = 1 - j / 10.0;
      for (Eigen::Index t = 0; t < n_instants; ++t) {
        cycle.load(j, t) = room[j] + 0.4 * (unit(random) - 0.5);
        if (room[j] <= 0) cycle.load(j, t) = std::min(cycle.load(j, t), 0.0);
        if (j >= 4) cycle.path(j, t) = 0.1 * unit(random);
      }
    }
    const std::optional<Eigen::ArrayXd> worn = wear_jump(matrices, cycle, room, 0.5, accuracy);
    ASSERT_TRUE(worn);
    const Eigen::VectorXd fall = matrices.image * worn->matrix();
    for (Eigen::Index i = 0; i < n; ++i) {
      double wear = 0;
      for (Eigen::Index j = i; j < n; ++j)
        for (Eigen::Index t = 0; t < n_instants; ++t) {
          const double stiffness = room[j] > 0 ? std::max(1.0, cycle.load(j, t) / room[j]) : 1;
          wear +=
              0.5 * cycle.path(i, t) * matrices.stress(i, j) * std::max(0.0, cycle.load(j, t) - stiffness * fall[j]);
        }
      EXPECT_NEAR((*worn)[i], std::max(0.0, wear), 1e-12) << i;
    }
    EXPECT_EQ(worn->head(4).maxCoeff(), 0);
    EXPECT_GT(worn->maxCoeff(), 0.01);
  }
}

// However many cycles: the pressure of every slipping ring goes to zero and not beyond.
TEST(WearJump, StopsWhereThePressureIsGone) {
  const MeasuredCycle m = measured_cycle(elastic(1), {1, 0, 0.3, 1, 1, 0}, 80, 30);
  const Eigen::ArrayXd room = 1 - m.bed.depth;
  const Eigen::ArrayXd worn = *wear_jump(m.matrices, m.cycle, room, 1e15, 1e-13);
  const Eigen::ArrayXd fall = (m.matrices.image * worn.matrix()).array();
  const Eigen::ArrayXd pressure = (m.matrices.stress * (room - fall).max(0).matrix()).array();
  for (Eigen::Index i = 0; i < 80; ++i) {
    EXPECT_GE(worn[i], 0);
    if (m.cycle.path.row(i).sum() > 0) {
      EXPECT_NEAR(pressure[i], 0, 1e-11) << i;  // roundoff times the stress matrix, largest entry about 10
    } else {
      EXPECT_EQ(worn[i], 0);
    }
    if (worn[i] > 0) {
      EXPECT_GE(room[i] - fall[i], -1e-11) << i;
    }
  }
}

TEST(WearJump, ShortOnesAreExplicit) {
  const MeasuredCycle m = measured_cycle(standard_solid(1, 1, 0.1), {1, 0.15, 0.15, 1, 1, 0.7}, 80, 30);
  const Eigen::ArrayXd rate = pressure_path(m) / 4, room = 1.15 - m.bed.depth;
  const double work = 1e-6;
  const Eigen::ArrayXd worn = *wear_jump(m.matrices, m.cycle, room, work, 1e-16);
  EXPECT_LT((worn - work * rate).abs().maxCoeff(), 1e-4 * worn.maxCoeff());  // of the order of work times stress
}

}  // namespace
}  // namespace fretval::mdr::wear_jump_test
