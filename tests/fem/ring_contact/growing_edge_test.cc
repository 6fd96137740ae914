#include "fem/ring_contact/growing_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>

#include "tests/fem/half_space.h"
#include "tests/worse.h"

namespace fretval::fem::growing_edge_test {
namespace {

using Eigen::Index;

constexpr double speed = 0.5;  // of the indentation

/// A parabola, f = r², that is pressed into an untouched half-space at a constant speed, or at one that falls linearly:
/// what lies at r bears `int_0^t G(y) d'(y) dy`, y the time before now and t(r) since it was touched.
struct Growing {
  RelaxationModel relaxation;
  double edge;
  double slowing = 0;  ///< of the indentation, over the speed, per time

  [[nodiscard]] double time_in_contact(double r) const {
    const double depth = (edge * edge - r * r) / speed;
    return slowing == 0 ? depth : (std::sqrt(1 + 2 * slowing * depth) - 1) / slowing;
  }
  /// By Gauss's rule on pieces that resolve the fastest branch next to now.
  [[nodiscard]] double depth(double r) const {
    const double t = time_in_contact(r);
    const auto rate = [this](double y) {
      double modulus = relaxation.relaxed;
      for (std::size_t i = 0; i < relaxation.moduli.size(); ++i)
        modulus += relaxation.moduli[i] * std::exp(-y / relaxation.times[i]);
      return modulus * speed * (1 + slowing * y);
    };
    return relaxation.viscosity * speed + on_pieces(rate, t, 1e-3);
  }
  /// Over the force of a unit punch per radius.
  [[nodiscard]] double force() const {
    return on_pieces([this](double way) { return depth(edge - way); }, edge, 1e-4);
  }

 private:
  /// From 0 on, by pieces of which each is twice as long as the one before.
  static double on_pieces(const std::function<double(double)>& f, double end, double first) {
    double sum = 0;
    for (double from = 0, to = first; from < end; from = to, to *= 2)
      sum += boost::math::quadrature::gauss<double, 10>::integrate(f, from, std::min(to, end));
    return sum;
  }
};

struct Read {
  double plain, with_edge, uncertainty;  ///< over the exact force
};

Read read(const Growing& growing, unsigned rings) {
  const auto& series = normal_half_space(rings).series;
  const auto& radii = series.radii();
  const Index n_pressed = std::lower_bound(radii.begin(), radii.end(), growing.edge) - radii.begin();
  Eigen::VectorXd depths = Eigen::VectorXd::Zero(radii.size()), times = depths;
  for (Index i = 0; i < n_pressed; ++i) {
    depths[i] = growing.depth(radii[i]);
    times[i] = growing.time_in_contact(radii[i]);
  }
  const double exact = series.force_per_radius() * growing.force(),
               plain = series.integral(depths, n_pressed, n_pressed, growing.edge).value;
  const auto missed = force_missed_at_edge(series, depths, n_pressed, growing.edge, {growing.relaxation, times});
  return {plain / exact, (plain + missed.force) / exact, missed.uncertainty / exact};
}

/// The worst of eleven positions of the edge within its ring.
Read worst_of_positions(Growing growing, unsigned rings) {
  Read worst{0, 0, 0};
  for (int k = 0; k <= 10; ++k) {
    growing.edge = 0.8 + k / (10.0 * rings);
    const auto one = read(growing, rings);
    worst = {worse(worst.plain, std::abs(one.plain - 1)), worse(worst.with_edge, std::abs(one.with_edge - 1)),
             worse(worst.uncertainty, one.uncertainty)};
  }
  return worst;
}

/// In which the edge crosses a ring of 32 along the radius.
constexpr double time_of_a_ring = 2 * 0.8 / 32 / speed;

// Branches that relax while the edge crosses a hundredth of a ring to ten rings. Where that is a ring or more, the
// cubics further inside, which are left as they are, follow by themselves.
TEST(GrowingEdge, BearsWhatItsBranchesHaveNotRelaxed) {
  for (const double share : {0.01, 0.1, 0.3, 1.0, 3.0, 10.0})
    for (const double slowing : {0.0, 5.0}) {
      const Growing growing{{1, {2}, {share * time_of_a_ring}}, 0, slowing};
      const auto worst = worst_of_positions(growing, 32);
      EXPECT_LT(worst.with_edge, 2e-5) << share << ' ' << slowing;
      EXPECT_LT(worst.with_edge, (share < 1 ? 0.03 : 0.7) * worst.plain) << share << ' ' << slowing;
      if (share < 1) {
        EXPECT_LT(worst.with_edge, 1.2 * worst.uncertainty) << share << ' ' << slowing;
      }
      EXPECT_LT(worst_of_positions(growing, 64).with_edge, 5e-6) << share << ' ' << slowing;
    }
}

TEST(GrowingEdge, JumpsByWhatADashpotBears) {
  const auto alone = worst_of_positions({{1, {}, {}, 0.1}, 0}, 32);
  EXPECT_EQ(alone.with_edge, alone.plain);
  EXPECT_LT(alone.plain, 1e-6);
  const auto beside = worst_of_positions({{1, {2, 1}, {0.3 * time_of_a_ring, time_of_a_ring}, 0.1}, 0}, 32);
  EXPECT_GT(beside.plain, 1e-4);
  EXPECT_LT(beside.with_edge, 1e-5);
}

// A branch that hardly relaxes while the edge crosses the last rings is a spring, whose depths the cubics follow.
TEST(GrowingEdge, AddsNothingForBranchesThatHardlyRelax) {
  for (const double share : {1e3, 1e4, 1e6})
    for (const double slowing : {0.0, 5.0}) {
      const auto one = read({{1, {2}, {share * time_of_a_ring}}, 0.81, slowing}, 32);
      EXPECT_NEAR(one.with_edge, one.plain, 2e-5 / share) << share << ' ' << slowing;
      EXPECT_LT(one.uncertainty, 2e-5 / share) << share << ' ' << slowing;
    }
}

// At a constant speed v the law is `C (way + g v tau (1 - exp(-t/tau)))`. Where C rises by a part of itself per way
// inwards, the one of the last ring is off by what it has risen there, and so is the force.
TEST(GrowingEdge, IsUncertainByWhatTheLawChangesInTheLastRing) {
  constexpr double v = 0.5, rise = 2, g = 2, tau = 0.3 / 32;
  const auto& series = normal_half_space(32).series;
  const double edge = series.radii()[11] + 0.4 / 32;
  Eigen::VectorXd depths = Eigen::VectorXd::Zero(series.radii().size()), times = depths;
  for (Index i = 0; i < 12; ++i) {
    const double way = edge - series.radii()[i];
    times[i] = way / v;
    depths[i] = (1 + rise * way) * (way - g * v * tau * std::expm1(-times[i] / tau));
  }
  const auto missed = force_missed_at_edge(series, depths, 12, edge, {{1, {g}, {tau}}, times});
  EXPECT_NE(missed.force, 0);
  EXPECT_NEAR(missed.uncertainty / std::abs(missed.force), rise * 0.4 / 32, 1e-9);
}

// The inner two of the four rings touched at the same instant, but for roundoff after many periods.
TEST(GrowingEdge, IsStableWhereInnerRingsTouchedAtOnce) {
  const auto& series = normal_half_space(32).series;
  const RelaxationModel relaxation{1, {2}, {0.1}};
  Eigen::VectorXd depths = Eigen::VectorXd::Zero(series.radii().size()), times = depths;
  for (Index i = 0; i < 12; ++i) {
    depths[i] = 0.5 - series.radii()[i];
    times[i] = i < 10 ? 0.3 : 0.1 * static_cast<double>(12 - i);
  }
  const double edge = series.radii()[11] + 0.5 / 32;
  const auto read = [&] { return force_missed_at_edge(series, depths, 12, edge, {relaxation, times}).force; };
  const double at_once = read();
  times[8] += 1e-15;
  EXPECT_NEAR(read(), at_once, 1e-12);
  EXPECT_NE(at_once, 0);
}

TEST(GrowingEdge, IsNotKnownWhereRingsWereTouchedAtOnce) {
  constexpr unsigned rings = 32;
  const auto& series = normal_half_space(rings).series;
  const RelaxationModel relaxation{1, {2}, {0.1}};
  const Eigen::VectorXd depths = Eigen::VectorXd::Constant(series.radii().size(), 0.5),
                        times = Eigen::VectorXd::Constant(depths.size(), 1.0);
  const double last = series.radii()[9], edge = last + 0.25 / rings;
  const auto missed = force_missed_at_edge(series, depths, 10, edge, {relaxation, times});
  EXPECT_EQ(missed.force, 0);
  EXPECT_NEAR(missed.uncertainty, series.force_per_radius() * 0.5 * (edge - last) / 4, 1e-12);
}

// A spring and a dashpot remember nothing of when a ring was touched: depths jump at the edge by what the dashpot
// bears.
TEST(GrowingEdge, IsKnownOfABodyWithoutBranchesHoweverRingsWereTouched) {
  const auto& series = normal_half_space(32).series;
  const Eigen::VectorXd depths = Eigen::VectorXd::Constant(series.radii().size(), 0.5),
                        times = Eigen::VectorXd::Constant(depths.size(), 1.0);
  const auto missed =
      force_missed_at_edge(series, depths, 10, series.radii()[9] + 0.25 / 32, {{1, {}, {}, 0.1}, times});
  EXPECT_EQ(missed.force, 0);
  EXPECT_EQ(missed.uncertainty, 0);
}

// The last ring was touched after a pause of the edge: the cubic through the ways goes back and forth.
TEST(GrowingEdge, IsNotKnownWhereItHasPaused) {
  constexpr unsigned rings = 32;
  const auto& series = normal_half_space(rings).series;
  const RelaxationModel relaxation{1, {2}, {0.1}};
  const Eigen::VectorXd depths = Eigen::VectorXd::Constant(series.radii().size(), 0.5);
  Eigen::VectorXd times = Eigen::VectorXd::Constant(depths.size(), 1.1);
  times[9] = 0.047;
  times[8] = 0.95;
  times[7] = 1;
  const double last = series.radii()[9], edge = last + 0.5 / rings;
  const auto missed = force_missed_at_edge(series, depths, 10, edge, {relaxation, times});
  EXPECT_EQ(missed.force, 0);
  EXPECT_NEAR(missed.uncertainty, series.force_per_radius() * 0.5 * (edge - last) / 4, 1e-12);
}

}  // namespace
}  // namespace fretval::fem::growing_edge_test
