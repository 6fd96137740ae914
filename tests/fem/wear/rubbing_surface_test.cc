#include "fem/wear/rubbing_surface.h"

#include <gtest/gtest.h>

#include <cereal/archives/binary.hpp>
#include <memory>
#include <sstream>

#include "fem/wear/rubbing_rings.h"
#include "fem/wear/wear_course.h"
#include "tests/fem/full_contact/bodies.h"
#include "tests/fem/wear/wearing_half_space.h"

namespace fretval::fem::rubbing_surface_test {
namespace {

using Eigen::VectorXd;

constexpr int n_steps = 24;

/// The scene of WearingHalfSpace on rings and angles: its body, its indenter and its motion.
struct WearingSurface {
  explicit WearingSurface(unsigned n_angles, Mirrors mirrors, double poisson_ratio = 0.5, bool coupling = false)
      : surface([&] {
          auto grid = quarter_disc_grid(1.375, 22, 25, 0.25);
          grid.elasticity.poisson_ratio = poisson_ratio;
          return surface_compliance(grid, n_angles / 2 + 1);
        }()),
        operators(coupled_operators(surface, angular_grid(n_angles, mirrors), coupling)),
        normal(ring_compliance(surface, axisymmetric)),
        tangential(ring_compliance(surface, lateral)),
        of_indenter(indenter_motion(scene.motion)),
        profile(ring_means(normal.compliance, [](double r) { return r * r / 2; })) {}

  [[nodiscard]] std::unique_ptr<RubbingContact> on_angles() const {
    const VectorXd all = profile.replicate(operators.normal.grid().n_kept(), 1);
    return std::make_unique<RubbingSurface>(operators, scene.body, scene.motion, of_indenter, n_steps,
                                            WornProfile{all, VectorXd::Zero(all.size())}, scene.mu);
  }
  [[nodiscard]] std::unique_ptr<RubbingContact> on_rings() const {
    return std::make_unique<RubbingRings>(normal, tangential, scene.body, scene.motion, n_steps,
                                          WornProfile{profile, VectorXd::Zero(profile.size())}, scene.mu);
  }

  WearingHalfSpace scene{8};
  SurfaceCompliance surface;
  CoupledOperators operators;
  ContactProblem normal, tangential;
  IndenterMotion of_indenter;
  VectorXd profile;
};

// Another solver, another representation: the ring contact takes a Cholesky factor and its active set, this one
// conjugate gradients.
TEST(RubbingSurface, WithOneAngleWearsAsTheRingsDo) {
  const WearingSurface scene(1, Mirrors::none);
  for (const double exponent : {1.0, 2.0, 0.5}) {
    const auto surface = scene.on_angles(), rings = scene.on_rings();
    const PressureWear wear{VectorXd::Constant(scene.profile.size(), 2e-4), exponent};
    const double close = exponent == 1 ? 1e-8 : 1e-5;  // rings iterate to 1e-7 of the pressures, at each step
    for (int k = 0; k < 2 * n_steps; ++k) {
      const VectorXd before = rings->pressure();
      const VectorXd on_angle = surface->step(wear), on_rings = rings->step(wear).cwiseAbs(),
                     pressure = rings->pressure();
      ASSERT_LT((on_angle - on_rings).cwiseProduct(pressure).cwiseAbs().maxCoeff(), close) << exponent << ", " << k;
      // A ring that lifts in this step, to what rings iterate to, slips in one of them and sticks in the other.
      const VectorXd lifts = (pressure.array() <= 1e-7).cast<double>() * (on_angle - on_rings).array().abs();
      const double either = scene.scene.mu * lifts.cwiseProduct(before).dot(scene.normal.compliance.areas);
      ASSERT_NEAR(surface->friction_work(), rings->friction_work(), close + either) << exponent << ", " << k;
      ASSERT_LT((surface->pressure() - pressure).cwiseAbs().maxCoeff(), close) << exponent << ", " << k;
    }
    EXPECT_GT(surface->worn().maxCoeff(), 1e-2);
    EXPECT_LT((surface->worn() - rings->worn()).cwiseAbs().maxCoeff(), close);
  }
}

TEST(RubbingSurface, GoesOnFromItsArchiveBitForBit) {
  const WearingSurface scene(4, Mirrors::x, 0.3, true);
  const auto whole = scene.on_angles(), rest = scene.on_angles();
  const PressureWear wear{VectorXd::Constant(whole->areas().size(), 1e-4)};
  for (int k = 0; k < 3; ++k) whole->step(wear);
  std::stringstream bytes;
  {
    cereal::BinaryOutputArchive archive(bytes);
    whole->save(archive);
  }
  cereal::BinaryInputArchive archive(bytes);
  rest->load(archive);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(whole->step(wear), rest->step(wear));
  EXPECT_EQ(whole->worn(), rest->worn());
}

// The limiting state is two flat punches of one disc, of which the tangential one displaces without turning the
// traction: so the limit that MDR has is one of friction as a vector too, and wear along x leads there.
TEST(RubbingSurface, WearAlongXEndsRoundAtTheRadiusOfMdr) {
  const WearingSurface scene(8, Mirrors::x);
  WearState state{WearingContact(scene.on_angles(), {0.01})};
  wear_on(state, {infinity, 0, 0.05, 1e-6});
  EXPECT_EQ(state.course.end, WearEnd::nothing_left);
  EXPECT_DOUBLE_EQ(state.course.curve.back().stick_radius, WearingHalfSpace::stick_radius);
  const auto n = scene.profile.size();
  const VectorXd& worn = state.course.worn.back();
  for (Eigen::Index ray = 1; ray < worn.size() / n; ++ray)
    EXPECT_LT((worn.segment(ray * n, n) - worn.head(n)).cwiseAbs().maxCoeff(), 1e-4) << ray;
}

}  // namespace
}  // namespace fretval::fem::rubbing_surface_test
