#include "fem/ring_contact/friction_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/ring_contact/contact_events.h"
#include "fem/ring_contact/contact_force.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"
#include "tests/worse.h"

namespace fretval::fem::friction_force_test {
namespace {

constexpr double mu = 0.5;

/// Elastic friction at 32 rings, step by step.
class Sliding {
 public:
  /// Both sums over the same tractions: as they are read, and plain.
  struct Force {
    double read, sum;
  };

  Force step(double displacement, const Eigen::VectorXd& pressure, const ContactForce& normal) {
    const auto& areas = problem_.compliance.areas;
    const Eigen::VectorXd limit = mu * pressure;
    touching_.move_to(normal.radius);
    const auto solution = problem_.solver.solve(areas.array() * (displacement - slip_.array()), -limit, limit, states_);
    slip_ += solution.residual.cwiseQuotient(areas);
    zones_.update(limit, states_, problem_.series.depths(solution.x));
    return {friction_force(problem_.series, zones_, touching_, problem_.series.depths(limit), mu * normal.force).value,
            solution.x.dot(areas)};
  }

 private:
  const ContactProblem& problem_ = tangential_half_space(32);
  Eigen::VectorXd slip_ = Eigen::VectorXd::Zero(problem_.n_rings());
  std::vector<BoxState> states_{static_cast<std::size_t>(slip_.size()), BoxState::interior};
  SlipZones zones_{slip_.size()};
  TouchingRings touching_{normal_half_space(32).series.radii()};
};

class FrictionForceTest : public testing::Test {
 protected:
  const ContactProblem& problem_ = normal_half_space(32);
  const StaticContact contact_ = hertz_contact(problem_, 1);
  const ContactForce normal_ = contact_force(problem_.series, contact_.pressure, contact_.gap);
  const double all_slides_ = 1.5 * mu;  // (3 mu/2) d

  /// Cattaneo and Mindlin: u = (3 mu/2)(1 - c^2), F = mu P (1 - c^3).
  [[nodiscard]] double first_loading(double u) const {
    return mu * normal_.force * (1 - std::pow(1 - u / all_slides_, 1.5));
  }
};

// From slip zones much narrower than a ring to stick zones of less than one, relative to mu P: 4.4e-6 measured. A stick
// zone of four rings or less, with 2e-3 of the force, is partly a sum: 7e-5.
TEST_F(FrictionForceTest, IsThatOfCattaneoAndMindlin) {
  Sliding sliding;
  double worst = 0, worst_of_few = 0, worst_sum = 0;
  for (int k = 1; k < 100; ++k) {
    const double c = 1 - k / 100.0, u = all_slides_ * (1 - c * c);
    const auto force = sliding.step(u, contact_.pressure, normal_);
    const auto error = [&](double value) { return std::abs(value - first_loading(u)) / (mu * normal_.force); };
    double& so_far = c > 5.0 / 32 ? worst : worst_of_few;
    so_far = worse(so_far, error(force.read));
    worst_sum = worse(worst_sum, error(force.sum));
  }
  EXPECT_LT(worst, 6e-6);
  EXPECT_LT(worst_of_few, 1e-4);
  EXPECT_GT(worst_sum, 1e-4);
}

// Mindlin & Deresiewicz: F = F(u0) - 2 F((u0 - u)/2) on the way back from u0, F(u) = mu P [1 - (1 - u/u_all)^1.5]. Just
// after the reversal hardly a ring slips back, and just before -u0 hardly one of those that slipped before u0 is left.
TEST_F(FrictionForceTest, OfZonesNarrowerThanARing) {
  const double u0 = 0.5 * all_slides_;
  Sliding sliding;
  double worst = 0, worst_sum = 0;
  for (int k = 0; k <= 100; ++k) {
    const double u = u0 * (1 - k / 50.0);
    const auto force = sliding.step(u, contact_.pressure, normal_);
    const double expected = first_loading(u0) - 2 * first_loading((u0 - u) / 2);
    worst = worse(worst, std::abs(force.read - expected) / first_loading(u0));
    worst_sum = worse(worst_sum, std::abs(force.sum - expected) / first_loading(u0));
  }
  EXPECT_LT(worst, 4e-5);
  EXPECT_GT(worst_sum, 5e-4);
}

// A contact that grows while it sticks, from rest: each spring carries on from where it touched, so the force is that
// of the normal one, 2/3 of the slope as large (Jaeger 1993).
TEST_F(FrictionForceTest, OfAContactThatGrows) {
  const double slope = 0.3, first = 0.5, last = 0.62;
  Sliding sliding;
  double first_force = 0, worst = 0, worst_sum = 0;
  // Steps end where a ring touches: a ring that touches within one would stick since its beginning.
  std::vector<double> indentations;
  for (int k = 0; k <= 40; ++k) indentations.push_back(first + 0.003 * k);
  for (const double d : contact_events(problem_.compliance, parabola_means(problem_)).indentation)
    if (first < d && d < last) indentations.push_back(d);
  std::sort(indentations.begin(), indentations.end());
  for (const double indentation : indentations) {
    const auto contact = hertz_contact(problem_, indentation);
    const auto normal = contact_force(problem_.series, contact.pressure, contact.gap);
    if (indentation == first) first_force = normal.force;
    const auto force = sliding.step(slope * (indentation - first), contact.pressure, normal);
    const double exact = 2.0 / 3 * slope * (normal.force - first_force);
    worst = worse(worst, std::abs(force.read - exact));
    worst_sum = worse(worst_sum, std::abs(force.sum - exact));
  }
  EXPECT_LT(worst, 6e-6 * first_force);
  EXPECT_GT(worst_sum, 1e-4 * first_force);
}

// Nothing slips below a flat punch: F = (16/3) G a u. Everything slips below a parabola moved too far, to either side.
TEST_F(FrictionForceTest, OfFullStickAndOfFullSliding) {
  const Eigen::Index n = 24;
  const double radius = tangential_half_space(32).series.edges()[n], u = 0.1;
  const ContactForce punch{8 * radius, radius};
  // The force per radius, see EffectiveRadii.
  EXPECT_NEAR(Sliding().step(u, punch_traction(problem_, n), punch).read / (16.0 / 3 * radius * u), 1, 1e-5);
  for (const double side : {-1.0, 1.0})
    EXPECT_EQ(Sliding().step(1.01 * side * all_slides_, contact_.pressure, normal_).read, side * mu * normal_.force);
}

// A pressure that jumps at the edge, as with a dashpot, holds all of the disc: F = (16/3) G a u. The reserve against
// slip, continued, vanishes beyond the edge, where nothing is left to slip.
TEST_F(FrictionForceTest, NothingSlipsBeyondTheEdge) {
  const auto& series = tangential_half_space(32).series;
  const Eigen::Index n = 24;
  const double edge = series.edges()[n], u = 0.1, vanishes = edge + 0.3 / 32;
  const auto reserve_end = [vanishes](double r) { return vanishes * vanishes - r * r; };
  Eigen::VectorXd limit_depths = Eigen::VectorXd::Zero(problem_.n_rings()), depths = limit_depths;
  for (Eigen::Index i = 0; i < n; ++i) limit_depths[i] = u + 1.5 * mu * reserve_end(series.radii()[i]);
  depths.head(n).setConstant(u);
  const double limit_force =
      series.force_per_radius() * (u * edge + 1.5 * mu * (vanishes * vanishes * edge - edge * edge * edge / 3));
  for (const double side : {-1.0, 1.0}) {
    SlipZones zones(problem_.n_rings());
    zones.update(punch_traction(problem_, n), {static_cast<std::size_t>(problem_.n_rings()), BoxState::interior},
                 side * depths);
    TouchingRings touching{normal_half_space(32).series.radii(), false};
    touching.move_to(edge);
    EXPECT_NEAR(friction_force(series, zones, touching, limit_depths, limit_force).value, side * 16.0 / 3 * edge * u,
                1e-5 * edge);
  }
}

// Depths that fall in proportion to the radius at which each ring was touched again, which is not its own: their force
// is that of the same line at the radii of the rings.
TEST_F(FrictionForceTest, TakesDepthsForThoseOfTheRadiiAtWhichTheirRingsTouched) {
  const auto& series = tangential_half_space(32).series;
  const auto n = series.radii().size();
  constexpr Eigen::Index n_pressed = 20;
  Eigen::VectorXd limit = Eigen::VectorXd::Zero(n);
  limit.head(n_pressed).setOnes();
  const auto read = [&](const Eigen::VectorXd& touched) {
    const std::vector<BoxState> sticking(static_cast<std::size_t>(n), BoxState::interior);
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(n);
    SlipZones zones(n);
    zones.update(nothing, sticking, nothing);
    zones.update(limit, sticking, limit.cwiseProduct(Eigen::VectorXd::Ones(n) - touched));
    TouchingRings touching{touched, false};
    touching.move_to(series.edges()[n_pressed]);
    return friction_force(series, zones, touching, 10 * limit, 100).value;
  };
  const auto& own = series.radii();
  Eigen::VectorXd others = own;
  for (Eigen::Index i = 0; i < n; ++i) others[i] += (0.2 + 0.1 * std::sin(static_cast<double>(i))) / 32;
  EXPECT_GT(read(own), 0);
  EXPECT_NEAR(read(others) / read(own), 1, 1e-12);
}

}  // namespace
}  // namespace fretval::fem::friction_force_test
