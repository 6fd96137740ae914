#include "fem/ring_contact/free_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fem/history/normal_contact.h"
#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"
#include "tests/worse.h"

namespace fretval::fem::free_surface_test {
namespace {

using Eigen::Index;

const Eigen::VectorXd nodes = Eigen::VectorXd::LinSpaced(12, 0.5, 11.5);

/// Of a gap that is `inside` up to a kink between rings 5 and 6, from where on it is `outside`.
Opening kinked(double kink, const std::function<double(double)>& inside, const std::function<double(double)>& outside) {
  Opening opening{nodes, Eigen::VectorXi::Constant(nodes.size(), FreeSurface::never_touched),
                  Eigen::VectorXd::Zero(nodes.size())};
  for (Index i = 0; i < nodes.size(); ++i) {
    const bool is_inside = nodes[i] < kink;
    opening.value[i] = is_inside ? inside(nodes[i]) : outside(nodes[i]);
    if (!is_inside) continue;
    opening.retreat[i] = 1;
    opening.lifted_below[i] = kink;
  }
  return opening;
}

double cubic(double r) {
  return 1e-3 * std::pow(r - 5, 3) + 0.2 * (r - 5) + 0.01;
}

// All that cubics can show, they show to roundoff: between rings that lifted together, up to a kink, beyond one.
TEST(Opening, VanishesWhereACubicDoes) {
  const auto shifted = [](double zero) { return [zero](double r) { return cubic(r) - cubic(zero); }; };
  const auto steeper = [&](double zero, double kink) {
    return [=](double r) { return shifted(zero)(kink) + 0.7 * (r - kink); };
  };
  for (const double zero : {2.6, 3.0, 3.4})
    EXPECT_NEAR(*edge_of(kinked(6, shifted(zero), steeper(zero, 6)), nodes, 3), zero, 1e-12);
  for (const double zero : {5.51, 5.7, 5.89})
    EXPECT_NEAR(*edge_of(kinked(5.9, shifted(zero), steeper(zero, 5.9)), nodes, 6), zero, 1e-12);
  for (const double zero : {5.91, 6.2, 6.49}) {
    const auto outside = [&](double r) { return 0.7 * (r - zero); };
    const auto inside = [&](double r) { return outside(5.9) + 0.2 * (r - 5.9); };
    EXPECT_NEAR(*edge_of(kinked(5.9, inside, outside), nodes, 6), zero, 1e-12);
  }
}

TEST(Opening, TellsNothingOfTheInsideWhereNothingHasLifted) {
  auto opening = kinked(
      6, [](double) { return -1; }, [](double r) { return r - 5.7; });
  opening.retreat.head(6).setConstant(FreeSurface::never_lifted);
  EXPECT_NEAR(*edge_of(opening, nodes, 6), 5.7, 1e-12);
  opening.value.tail(6).setConstant(1);
  EXPECT_FALSE(edge_of(opening, nodes, 6)) << "a flat punch";
}

/// A Kelvin-Voigt body under the parabola of fretting_motion(): its springs in the periodic state. With a dashpot eta a
/// spring of the gap f = x^2 lifts where (d - f) + eta d' = 0, and goes back like exp(-t/eta) until d - f is there
/// again.
bool is_in_contact(double f, double t, double eta) {
  constexpr double mean = 0.8, amplitude = 0.2;
  const double largest = amplitude * std::hypot(1, eta);
  if (f >= mean + amplitude) return false;
  if (mean - f >= largest) return true;
  const double lifts = std::acos(-(mean - f) / largest) - std::atan(eta);
  if (t <= lifts) return true;
  const auto depth = [&](double time) { return mean + amplitude * std::cos(time) - f; };
  return depth(t) >= depth(lifts) * std::exp(-(t - lifts) / eta);
}

double exact_radius(double t, double eta) {
  double low = 0, high = 1.1;
  while (high - low > 1e-13) {
    const double middle = (low + high) / 2;
    (is_in_contact(middle * middle, t, eta) ? low : high) = middle;
  }
  return low;
}

/// A half-space has no length: one whose rings are wider.
ContactProblem widened(const ContactProblem& problem, double factor) {
  auto [radii, areas, matrix, half_space] = problem.compliance;
  for (double& radius : radii) radius *= factor;
  return ContactProblem({radii, std::pow(factor, 2) * areas, Eigen::MatrixXd(std::pow(factor, 3) * *matrix)});
}

/// Largest errors of the edge while the contact grows and while it goes back, on so many rings per contact radius,
/// which ends before a node.
struct EdgeErrors {
  double growing = 0, retreating = 0;
};
EdgeErrors largest_errors(int n_rings, double rings_before_node, double eta, int steps_per_cycle) {
  const auto problem =
      widened(long_half_space(axisymmetric, static_cast<unsigned>(n_rings)), n_rings / (n_rings - rings_before_node));
  const RelaxationModel body{1, {}, {}, eta};
  const Motion motion = fretting_motion();
  NormalContact contact(problem, body, parabola_means(problem), motion, steps_per_cycle);
  EdgeErrors worst;
  for (int k = 0; k < 12 * steps_per_cycle; ++k) {
    contact.step();
    if (k < 11 * steps_per_cycle) continue;
    const double t = std::fmod(contact.time, 2 * pi), error = std::abs(contact.reading.radius - exact_radius(t, eta));
    if (t > 1.5 * pi) worst.growing = worse(worst.growing, error);
    if (t < pi / 2) worst.retreating = worse(worst.retreating, error);
  }
  return worst;
}

// Measured: 6e-5 to 1.1e-4 and 1.4e-5 to 2.7e-5. The edge of a contact that grows again runs along what has lifted
// before: also where a ring, or none, lies between it and the kink at the largest contact, wherever that is in its
// ring.
TEST(FreeSurface, TellsTheEdgeOfAContactThatGrowsAgain) {
  for (const double eta : {0.3, 1.1, 10.0})
    for (const double rings_before_node : {0.0, 0.25, 0.5, 0.75}) {
      const auto coarse = largest_errors(16, rings_before_node, eta, 96),
                 fine = largest_errors(32, rings_before_node, eta, 192);
      EXPECT_LT(coarse.growing, 2e-4) << eta << ' ' << rings_before_node;
      EXPECT_LT(fine.growing, 5e-5) << eta << ' ' << rings_before_node;
      const bool jumps_back = eta > 2;  // by several rings in a step, whose pressures are averages
      EXPECT_LT(coarse.retreating, jumps_back ? 1e-2 : 2e-5) << eta << ' ' << rings_before_node;
      EXPECT_LT(fine.retreating, jumps_back ? 5e-3 : 1e-5) << eta << ' ' << rings_before_node;
    }
}

}  // namespace
}  // namespace fretval::fem::free_surface_test
