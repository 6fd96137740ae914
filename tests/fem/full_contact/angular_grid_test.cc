#include "fem/full_contact/angular_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fem/support/constants.h"

namespace fretval::fem::angular_grid_test {
namespace {

/// (u_x, u_y) on the angles of a field with amplitudes U and V, or W, of an order.
struct Field {
  FourierOrder order;
  double u, v;

  [[nodiscard]] Eigen::VectorXd on(const AngularGrid& grid) const {
    const Eigen::Index n = grid.n_kept();
    Eigen::VectorXd values(2 * n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const double theta = grid.angles[j], c = std::cos(order.n * theta), s = std::sin(order.n * theta);
      const double radial = u * (order.parity == Parity::even ? c : s),
                   along = v * (order.parity == Parity::even ? s : -c);
      values[j] = radial * std::cos(theta) - along * std::sin(theta);
      values[n + j] = radial * std::sin(theta) + along * std::cos(theta);
    }
    return values;
  }
};

double expected(const Field& field, const FourierOrder& order, unsigned component) {
  if (!(field.order == order)) return 0;
  if (order.n == 0) return order.is_torsion() ? field.v : field.u;
  return (component == 0 ? field.u - field.v : field.u + field.v) / 2;
}

void expect_amplitudes(const AngularGrid& grid, const Field& field) {
  const auto values = field.on(grid);
  for (const auto& amplitude : amplitudes_of(grid, SurfaceField::tangential))
    EXPECT_NEAR(amplitude.weights.dot(values), expected(field, amplitude.order, amplitude.component), 1e-14)
        << grid.n_around << " angles, order " << amplitude.order.n;
}

TEST(AngularGrid, FindsTheAmplitudesOfTheFieldsOfEveryOrder) {
  for (const unsigned n_around : {9U, 12U}) {
    const auto grid = angular_grid(n_around);
    for (const auto parity : {Parity::even, Parity::odd})
      for (unsigned n = 1; n < n_around / 2 - 1; ++n) expect_amplitudes(grid, {{n, parity}, 0.7, -0.2});
    expect_amplitudes(grid, {{0, Parity::even}, 0.7, 0});
    expect_amplitudes(grid, {{0, Parity::odd}, 0, 0.7});
  }
}

TEST(AngularGrid, FindsThoseOfAPressureWhichPushesIntoTheBody) {
  const auto grid = angular_grid(9);
  const Eigen::VectorXd pressure = 2 + (3 * grid.angles).array().sin();
  for (const auto& amplitude : amplitudes_of(grid, SurfaceField::normal)) {
    const bool is_mean = amplitude.order.n == 0, is_wave = amplitude.order == FourierOrder{3, Parity::odd};
    EXPECT_NEAR(amplitude.weights.dot(pressure), is_mean ? -2 : is_wave ? -1 : 0, 1e-14) << amplitude.order.n;
  }
}

// Values of either sign in turn are the sine of the highest order, and the cosine vanishes at all angles.
TEST(AngularGrid, FindsThatOfThePressureThatTurnsFromAngleToAngle) {
  const auto grid = angular_grid(12);
  const Eigen::VectorXd pressure = (6 * grid.angles).array().sin();
  EXPECT_NEAR(pressure.cwiseAbs().minCoeff(), 1, 1e-14);
  const FourierOrder highest{6, Parity::odd};
  for (const auto& amplitude : amplitudes_of(grid, SurfaceField::normal))
    EXPECT_NEAR(amplitude.weights.dot(pressure), amplitude.order == highest ? -1 : 0, 1e-14) << amplitude.order.n;
}

// What a mirror leaves out changes nothing but the number of angles.
TEST(AngularGrid, LeavesOutWhatMirrorsMakeTheSame) {
  for (const auto mirrors : {Mirrors::x, Mirrors::x_and_y}) {
    const auto grid = angular_grid(12, mirrors);
    EXPECT_EQ(grid.n_kept() * grid.multiplicity(), 12);
    expect_amplitudes(grid, {{1, Parity::even}, 0.5, -0.5});
    expect_amplitudes(grid, {{3, Parity::even}, 0.7, -0.2});
    for (const auto& amplitude : amplitudes_of(grid, SurfaceField::tangential)) {
      EXPECT_EQ(amplitude.order.parity, Parity::even);
      if (mirrors == Mirrors::x_and_y) {
        EXPECT_EQ(amplitude.order.n % 2, 1U);
      }
    }
  }
}

// A mirror keeps t_x and turns t_y around: (cos 2 theta, sin 2 theta) is the same in both of them.
TEST(AngularGrid, HasTheWholeCircleFromTheKeptAngles) {
  for (const auto mirrors : {Mirrors::none, Mirrors::x, Mirrors::x_and_y}) {
    const auto grid = angular_grid(12, mirrors);
    const auto circle = whole_circle(grid);
    ASSERT_EQ(circle.size(), 12U);
    for (std::size_t j = 0; j < circle.size(); ++j) {
      const auto& [angle, kept, sign_of_y] = circle[j];
      EXPECT_NEAR(angle, (static_cast<double>(j) + 0.5) * pi / 6, 1e-14);
      EXPECT_NEAR(std::cos(2 * grid.angles[kept]), std::cos(2 * angle), 1e-14) << j;
      EXPECT_NEAR(sign_of_y * std::sin(2 * grid.angles[kept]), std::sin(2 * angle), 1e-14) << j;
    }
  }
}

TEST(AngularGrid, RefusesAnglesThatAMirrorDoesNotMapOntoEachOther) {
  EXPECT_THROW(angular_grid(0), std::invalid_argument);
  EXPECT_THROW(angular_grid(9, Mirrors::x), std::invalid_argument);
  EXPECT_THROW(angular_grid(10, Mirrors::x_and_y), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::fem::angular_grid_test
