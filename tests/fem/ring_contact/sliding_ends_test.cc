#include "fem/ring_contact/sliding_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/support/constants.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::sliding_ends_test {
namespace {

constexpr double mu = 0.5, infinity = std::numeric_limits<double>::infinity();

/// The last period of springs of stiffness 1 in the places of the punches, under a parabola that presses all of them
/// and moves to and fro, by the law of the steps: a spring sticks unless that exceeds its limit at the end of the step.
struct Springs {
  const PunchSeries& series = tangential_half_space(16).series;
  Eigen::MatrixXd depths, limits;
  Eigen::VectorXd indenter, force;

  Springs(int n, double amplitude) {
    const auto n_springs = series.radii().size();
    depths.resize(n_springs, n);
    limits.resize(n_springs, n);
    indenter.resize(n);
    force.resize(n);
    const double dt = 2 * pi / n;
    const auto move = [=](double t) { return amplitude * std::sin(t); };
    Eigen::VectorXd depth = Eigen::VectorXd::Zero(n_springs);
    for (int k = -n; k < n; ++k) {
      const double t = k * dt;
      Eigen::VectorXd limit(n_springs);
      for (Eigen::Index i = 0; i < n_springs; ++i) {
        limit[i] = mu * (1.6 + 0.3 * std::cos(t + 0.4) - std::pow(series.radii()[i], 2));
        if (k > -n) depth[i] = std::clamp(depth[i] + move(t) - move(t - dt), -limit[i], limit[i]);
      }
      if (k < 0) continue;
      depths.col(k) = depth;
      limits.col(k) = limit;
      indenter[k] = move(t);
      force[k] = 0;
      for (Eigen::Index i = 0; i < n_springs; ++i)
        force[k] += (series.punch_force(i + 1) - series.punch_force(i)) * depth[i];
    }
  }

  [[nodiscard]] Eigen::VectorXd off(bool repeats = true) const {
    return force_off_by_sliding_ends(series, depths, limits, repeats);
  }
  /// `oint y du` of samples at the ends of the steps.
  [[nodiscard]] double work(const Eigen::VectorXd& y) const {
    const auto n = y.size();
    double sum = 0;
    for (Eigen::Index k = 0; k < n; ++k) sum += y[k] * (indenter[(k + 1) % n] - indenter[(k + n - 1) % n]) / 2;
    return sum;
  }
};

/// How much C varies with the number of steps n, as they lie otherwise each time, in errors C/n^2.
template <class Error>
double spread_of_factor(const Error& error) {
  double least = infinity, most = -infinity;
  for (int n = 32; n <= 96; n += 3) {
    const double factor = error(n) * n * n;
    least = std::min(least, factor);
    most = std::max(most, factor);
  }
  return most - least;
}

// Springs slide for a while, under the larger amplitude all of them. The sums over the steps are of second
// order as well, with a factor that does not jump.
TEST(SlidingEnds, AreWhyStepsHaveErrorsWithoutAnOrder) {
  for (const double amplitude : {0.6, 1.5}) {
    const Springs exact(20000, amplitude);
    const double work = exact.work(exact.force), mean = exact.force.mean();
    const auto spread = [&](auto&& error) {
      return spread_of_factor([&](int n) { return error(Springs(n, amplitude)); });
    };
    const double of_work = spread([&](const Springs&s) { return s.work(s.force) - work; }),
                 of_mean = spread([&](const Springs&s) { return s.force.mean() - mean; });
    EXPECT_LT(spread([&](const Springs& s) { return s.work(s.force - s.off()) - work; }), of_work / 3) << amplitude;
    EXPECT_LT(spread([&](const Springs& s) { return (s.force - s.off()).mean() - mean; }), of_mean / 2) << amplitude;
  }
}

TEST(SlidingEnds, AreNoneWithoutSteps) {
  EXPECT_EQ(force_off_by_sliding_ends(tangential_half_space(16).series, {}, {}, true).size(), 0);
}

// Sliding ends twice in a period, the second time at three quarters of it; what that locks in goes on after its end.
TEST(SlidingEnds, GoOnInTheNextPeriodIfThatIsTheSame) {
  const Springs steps(47, 1.5);
  const auto once = steps.off(false), again = steps.off(true);
  EXPECT_EQ(once.tail(8), again.tail(8));
  EXPECT_EQ(once[0], 0);
  EXPECT_LT(again[0], 0);
}

}  // namespace
}  // namespace fretval::fem::sliding_ends_test
