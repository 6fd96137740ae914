#include "mdr/layer/coupled_history.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/layer/layer_stick_radius.h"
#include "mdr/springs/spring_history.h"

namespace fretval::mdr::coupled_history_test {
namespace {

const double mu = 0.5;

SpringHistory history_of(const Layer& layer, const PronyBody& body, const HarmonicMotion& motion, double outer,
                         Eigen::Index n, const HistoryControl& control) {
  return coupled_history(coupled_bed(spring_bed(parabola(1), outer, n), layer), body, mu,
                         {ramped_path(motion, control.n_ramp_periods * control.period), {}, {}}, control);
}

// Springs that are stepped from rest know neither M+ nor M-, nor that all beyond c slip at once.
TEST(CoupledHistory, GivesBothRadiiOfAnElasticOscillation) {
  for (const Layer& layer : {Layer{2, 0.5}, Layer{0.5, 0.5}, Layer{0.5, 0.3}}) {
    const double d = layer_contact(parabola(1), layer, 1).indentation;
    for (const double phase : {0.0, 0.7}) {
      const HarmonicMotion motion = harmonic_motion({d, 0.15 * d, 0.1 * d, 1, 1, phase});
      const StickRadii exact = layer_stick_radii(parabola(1), layer, 1, mu, {motion});
      const SpringHistory history = history_of(layer, elastic(1), motion, 1.1, 200, {1, 180, 10, 100, 1e-9});
      // Springs: the second order in 1/200, measured 3e-6 and less.
      EXPECT_NEAR(std::sqrt(history.depths.first_slip), *exact.first_slip, 1e-5);
      EXPECT_NEAR(std::sqrt(history.depths.shakedown), *exact.shakedown, 1e-5);
    }
  }
}

TEST(CoupledHistory, GivesBothRadiiUnderForces) {
  const Layer layer{0.5, 0.3};
  const double F = normal_force(layer_contact(parabola(1), layer, 1), 1);
  const Prescribed forces{harmonic_motion({F, 0.15 * F, 0.1 * F, 1, 1, 0.7}), true, true};
  const StickRadii exact = layer_stick_radii(parabola(1), layer, 1, mu, forces);
  const Loading loading{{}, ramped_force(F, 0.15 * F, 1, 0, 10), ramped_force(0, 0.1 * F, 1, 0.7, 10)};
  const auto history = [&](const PronyBody& body, int steps) {
    return coupled_history(coupled_bed(spring_bed(parabola(1), 1.1, 200), layer), body, mu, loading,
                           {1, steps, 10, 200, 1e-8});
  };
  const StickDepths elastic_depths = history(elastic(1), 180).depths;
  EXPECT_NEAR(std::sqrt(elastic_depths.first_slip), *exact.first_slip, 2e-5);
  EXPECT_NEAR(std::sqrt(elastic_depths.shakedown), *exact.shakedown, 2e-5);
}

// What the rim of the contact bears takes its share of friction, so that Coulomb's law holds for the whole contact.
TEST(CoupledHistory, SlidesUnderMuTimesTheNormalForce) {
  const Layer layer{0.5, 0.5};
  const double d = layer_contact(parabola(1), layer, 1).indentation;
  const HarmonicMotion motion = harmonic_motion({d, 0.2 * d, 5 * d, 1, 1, 1.0});
  for (const PronyBody& body : {elastic(1), standard_solid(1, 1.5, 0.3)}) {
    const SpringHistory history = history_of(layer, body, motion, 1.1, 40, {1, 60, 2, 100, 1e-8});
    std::size_t n_sliding = 0;
    for (std::size_t k = 0; k < history.time.size(); ++k) {
      const double share = std::abs(history.tangential_force[k]) / (mu * history.normal_force[k]);
      EXPECT_LT(share, 1 + 1e-12);
      n_sliding += share > 1 - 1e-12;
    }
    EXPECT_GT(n_sliding, 20U);
  }
}

// Orders: of the radius in the springs, of the works in time.
TEST(CoupledHistory, IsOfSecondOrder) {
  const Layer layer{0.5, 0.5};
  const double d = layer_contact(parabola(1), layer, 1).indentation;
  const HarmonicMotion motion = harmonic_motion({d, 0.2 * d, 0.15 * d, 1, 1, 1.0});
  for (const PronyBody& body : {elastic(1), standard_solid(1, 1.5, 0.3)}) {
    const auto work = [&](int steps) {
      return history_of(layer, body, motion, 1.1, 40, {1, steps, 8, 100, 1e-8}).friction_work;
    };
    const double exact = (4 * work(960) - work(480)) / 3;
    for (const int n : {60, 120, 240})
      EXPECT_LT(std::abs(work(n) / exact - 1), 20.0 / n / n) << n;  // measured up to 15
  }
}

TEST(CoupledHistory, WorkOfAPeriodIsHeat) {
  for (const Layer& layer : {Layer{0.5, 0.5}, Layer{1, 0.3}}) {
    const double d = layer_contact(parabola(1), layer, 1).indentation;
    const HarmonicMotion motion = harmonic_motion({d, 0.15 * d, 0.2 * d, 1, 1, 0.7});
    const SpringHistory history =
        history_of(layer, standard_solid(1, 1.5, 0.3), motion, 1.1, 150, {1, 360, 8, 100, 1e-8});
    EXPECT_GT(history.friction_work, 0);
    EXPECT_GT(history.bulk_work, history.friction_work / 100);
    EXPECT_NEAR((history.friction_work + history.bulk_work) / history.indenter_work, 1, 1e-4);  // (2 pi/360)^2/3
  }
}

// All that a dashpot does for independent springs it does here: damps, and is paid for.
TEST(CoupledHistory, KnowsDashpots) {
  const Layer layer{0.7, 0.45};
  const double d = layer_contact(parabola(1), layer, 1).indentation;
  const HarmonicMotion motion = harmonic_motion({d, 0.1 * d, 0.1 * d, 1, 1, 0.7});
  const auto history = [&](int steps) {
    return history_of(layer, kelvin_voigt(1, 0.1), motion, 1.1, 100, {1, steps, 10, 400, 1e-6});
  };
  const SpringHistory coarse = history(180), fine = history(720);
  EXPECT_NEAR((fine.friction_work + fine.bulk_work) / fine.indenter_work, 1, 2e-3);
  EXPECT_NEAR(coarse.depths.shakedown / fine.depths.shakedown, 1, 1e-3);
  EXPECT_NEAR(coarse.friction_work / fine.friction_work, 1, 1e-2);
}

// margins of a stick zone whose edge is known.
TEST(CoupledHistory, ReadsTheEdgeOffTheMargins) {
  const SpringBed bed = spring_bed(parabola(1), 1, 40);
  const double edge = 0.43;
  const Eigen::ArrayXd rest = edge - bed.depth;
  EXPECT_NEAR(coupled_stick_depth(bed, 0.9, 0.9 * rest, 0), edge, 1e-14);         // a half-space's
  EXPECT_NEAR(coupled_stick_depth(bed, 0.9, rest + rest * rest, 0), edge, 3e-4);  // of a layer, third order
  EXPECT_NEAR(coupled_stick_depth(bed, 0.9, 0 * rest, 0.45), bed.depth[0] - 0.5, 1e-15) << "none sticks";
}

// Under a flat face the margins of a layer are nearly the same: they end with the face, or inside it where they fall.
TEST(CoupledHistory, TellsAFlatFaceThatSticksFromAPartOfIt) {
  SpringBed bed = spring_bed(truncated_sphere(2, 1), 1.5, 15);  // the edge of its face is an edge of a spring
  const Eigen::ArrayXd& depth = bed.zone_depth;
  const auto in_face = depth < 0;
  const auto with_margins = [&](const Eigen::ArrayXd& in, double at_edge) {
    return coupled_stick_depth(bed, 0.9, in_face.select(in, at_edge - depth), 0);
  };
  const Eigen::ArrayXd alike = Eigen::ArrayXd::Constant(15, 0.1), falling = alike - 1e-9 * depth.square(),
                       ending = -0.3 - depth;
  EXPECT_EQ(with_margins(alike, -1e-3), 0);
  EXPECT_EQ(with_margins(falling, -1e-3), 0);
  EXPECT_NEAR(with_margins(ending, -1), -0.3, 1e-12);
  EXPECT_NEAR(with_margins(alike, 0.5), 0.5, 0.05) << "it goes on beyond the face";
}

// Where nothing sticks in a cycle the depth tells how far that is from sticking, by the slip one way of the innermost
// spring: over a layer a hundred times as thick as the contact is wide it is that of a half-space.
TEST(CoupledHistory, TellsHowFarAllSpringsSlipAsOverAHalfSpace) {
  const Motion motion{1, 0.2, 2, 1, 1, 0.7};
  const HistoryControl control{1, 90, 5, 100, 1e-9};
  const Loading loading{ramped_path(harmonic_motion(motion), 5), {}, {}};
  const SpringBed bed = spring_bed(parabola(1), 1.15, 60);
  const double half_space = spring_history(bed, elastic(1), mu, loading, control).depths.shakedown,
               layer = coupled_history(coupled_bed(bed, {100, 0.5}), elastic(1), mu, loading, control).depths.shakedown;
  EXPECT_LT(half_space, -1);
  EXPECT_NEAR(layer, half_space, 0.02 * std::abs(half_space));
}

}  // namespace
}  // namespace fretval::mdr::coupled_history_test
