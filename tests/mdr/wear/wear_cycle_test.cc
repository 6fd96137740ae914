#include "mdr/wear/wear_cycle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/stick/stick_radius.h"
#include "mdr/wear/wear_jump.h"

namespace fretval::mdr::wear_cycle_test {
namespace {

const double mu = 0.6;
const Profile sphere = parabola(1);

struct Measured {
  AbelMatrices matrices;
  WearCycle cycle;
  SpringBed bed;
};

Measured measure(const PronyBody& body, const Motion& motion, Eigen::Index n, int steps) {
  const SpringBed bed = spring_bed(sphere, 1.6, n);
  const AbelMatrices matrices = abel_matrices(bed);
  return {matrices, WearingSprings(bed, body, mu, motion, steps).settled_cycle(matrices), bed};
}

// int p |ds| of the rings in a cycle over the relaxed modulus, m^2.
Eigen::ArrayXd pressure_path(const Measured& m) {
  const Eigen::MatrixXd load = m.cycle.load.cwiseMax(0);
  return 4 * m.matrices.stress.cwiseProduct(m.cycle.path * load.transpose()).rowwise().sum().array();
}

// mu int p |ds| dA over the friction work of the springs, less 1.
double reye_error(const PronyBody& body, const Motion& motion, Eigen::Index n, int steps) {
  const Measured m = measure(body, motion, n, steps);
  return mu * body.relaxed_modulus * (m.matrices.area * pressure_path(m)).sum() / m.cycle.friction_work - 1;
}

// Surface and springs do the same work. What remains is the trapezoidal rule over steps in which slip sets in while the
// load changes: none at constant indentation, else of second order in the step.
TEST(WearCycle, WornVolumeIsFrictionWork) {
  const Motion tangential{1, 0, 0.3, 1, 1, M_PI / 2}, both{1, 0.15, 0.3, 1, 1, 0.7};
  for (const PronyBody& body : {elastic(2), standard_solid(2, 2, 0.1)}) {
    EXPECT_NEAR(reye_error(body, tangential, 100, 45), 0, 1e-12);  // roundoff
    const double coarse = reye_error(body, both, 100, 45), fine = reye_error(body, both, 100, 360);
    EXPECT_LT(std::abs(coarse), 0.002);
    EXPECT_LT(std::abs(fine), std::abs(coarse) / 30);  // 64 but for the few steps in which slip turns round
  }
}

TEST(WearCycle, RadiiAreThoseOfTheory) {
  const Motion motion{1, 0.15, 0.15, 1, 1, 0.7};
  const PronyBody body = standard_solid(1, 1, 0.1);
  const Measured m = measure(body, motion, 200, 90);
  EXPECT_NEAR(m.cycle.contact_radius, std::sqrt(1.15), 1.6 / 200);  // half a spring, and its mean depth
  EXPECT_NEAR(m.cycle.stick_radius, *stick_radii(sphere, body, mu, motion).shakedown, 1.6 / 200);
  EXPECT_GT(m.cycle.friction_work, 0);
}

// However many cycles: the pressure of every slipping ring goes to zero and not beyond.
TEST(WearJump, StopsWhereThePressureIsGone) {
  const Measured m = measure(elastic(1), {1, 0, 0.3, 1, 1, 0}, 80, 30);
  const Eigen::ArrayXd room = 1 - m.bed.depth;
  const double accuracy = 1e-13;
  const Eigen::ArrayXd worn = *wear_jump(m.matrices, m.cycle, room, 1e15, accuracy);
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
  const Measured m = measure(standard_solid(1, 1, 0.1), {1, 0.15, 0.15, 1, 1, 0.7}, 80, 30);
  const Eigen::ArrayXd rate = pressure_path(m) / 4, room = 1.15 - m.bed.depth;
  const double work = 1e-6;
  const Eigen::ArrayXd worn = *wear_jump(m.matrices, m.cycle, room, work, 1e-16);
  EXPECT_LT((worn - work * rate).abs().maxCoeff(), 1e-4 * worn.maxCoeff());  // of the order of work times stress
}

}  // namespace
}  // namespace fretval::mdr::wear_cycle_test
