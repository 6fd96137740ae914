#include "mdr/layer/coupled_bed.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/support/gauss_legendre.h"
#include "tests/mdr/error_of.h"

namespace fretval::mdr::coupled_bed_test {
namespace {

const Layer layer{0.6, 0.5};

// Loads uniform over each spring, the mean of their coupling over each spring: by quadrature of the kernel itself.
TEST(CoupledBed, ModesAreTheMeansOfTheKernelOverTheSprings) {
  const SpringBed bed = spring_bed(parabola(1), 1.2, 12);
  const LayerKernel kernel = layer_kernel(layer, Direction::normal, 3);
  const LayerModes modes = layer_modes(kernel, bed);
  const Eigen::ArrayXd load = (1.3 - bed.position).square();
  const Eigen::ArrayXd coupled = coupling(modes, load);
  for (const Eigen::Index i : {0, 5, 11}) {
    const double half = bed.width[i] / 2;
    const QuadratureRule here = gauss_legendre({bed.position[i] - half, bed.position[i] + half}, 6);
    double expected = 0;
    for (Eigen::Index j = 0; j < 12; ++j) {
      const QuadratureRule there = gauss_legendre({bed.position[j] - half, bed.position[j] + half}, 6);
      const Eigen::ArrayXd parts = amplitudes(kernel, there.point, there.weight * load[j]);
      expected += (here.weight * coupling(kernel, parts, here.point)).sum() / bed.width[i];
    }
    EXPECT_NEAR(coupled[i], expected, 1e-14);
  }
}

// Wave by wave, for layers whose modes come from few polynomials, and for one so thin that they do not.
TEST(CoupledBed, ModesOfManySpringsAreTheSumOfTheWaves) {
  for (const double thickness : {3.0, 0.6, 0.05}) {
    const SpringBed bed = spring_bed(parabola(1), 1.2, 200);
    const LayerKernel kernel = layer_kernel({thickness, 0.45}, Direction::tangential, 3);
    const Eigen::ArrayXd load = (1.3 - bed.position).square() + (40 * bed.position).cos();
    const Eigen::ArrayXd half_turn = kernel.wave_number * bed.width[0] / 2, mean = half_turn.sin() / half_turn;
    const Eigen::ArrayXd expected =
        coupling(kernel, amplitudes(kernel, bed.position, bed.width * load) * mean.square(), bed.position);
    EXPECT_LT((coupling(layer_modes(kernel, bed), load) - expected).abs().maxCoeff(), 1e-12);
  }
}

// Springs that all give alike, do not give, or give each in its own way; some number that no block divides.
TEST(CoupledBed, ModesRespondToSpringsThatGive) {
  const Eigen::Index n = 77;
  const LayerModes modes = coupled_bed(spring_bed(parabola(1), 1.2, n), layer).normal;
  Eigen::ArrayXd give = Eigen::ArrayXd::Constant(n, 0.7);
  give.segment(20, 7) = Eigen::ArrayXd::LinSpaced(7, -1, 1);
  give.segment(30, 40) = 0;
  give[76] = 3;
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(modes.strength.size(), modes.strength.size());
  for (Eigen::Index j = 0; j < n; ++j)
    expected += give[j] * modes.shape.row(j).transpose() * modes.shape.row(j) * modes.strength.matrix().asDiagonal();
  EXPECT_LT((modes.response(give) - expected).norm(), 1e-14);
}

TEST(CoupledBed, FewModesHoldItAndAllLetDepthsGiveLoads) {
  for (const Eigen::Index n : {50, 200}) {
    const CoupledBed bed = coupled_bed(spring_bed(parabola(1), 1.2, n), layer);
    EXPECT_LT(bed.normal.strength.size(), 20);
    EXPECT_GT(bed.normal.strength.size(), 5);
    EXPECT_GT(bed.normal.strength.minCoeff(), -1);
    EXPECT_LT((bed.normal.shape.transpose() * bed.normal.shape -
               Eigen::MatrixXd::Identity(bed.normal.strength.size(), bed.normal.strength.size()))
                  .norm(),
              1e-13);
  }
}

TEST(CoupledBed, AThickLayerHasNoCouplingAndAFrictionlessBaseNoTangentialOne) {
  const SpringBed springs = spring_bed(parabola(1), 1.2, 20);
  EXPECT_LT(coupling(coupled_bed(springs, {1e9, 0.5}).normal, springs.width).abs().maxCoeff(), 1e-9);
  const CoupledBed sliding = coupled_bed(springs, {1, 0.5, LayerBase::frictionless});
  EXPECT_GT(sliding.normal.strength.size(), 0);
  EXPECT_EQ(sliding.tangential.strength.size(), 0);
}

TEST(CoupledBed, AsksForEqualWidths) {
  SpringBed springs = spring_bed(parabola(1), 1.2, 20);
  springs.width[3] *= 2;
  EXPECT_NE(error_of([&] { coupled_bed(springs, layer); }).find("widths"), std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::coupled_bed_test
