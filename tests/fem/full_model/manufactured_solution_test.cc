#include "fem/full_model/manufactured_solution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/operators/grid_refinement.h"
#include "fem/support/constants.h"
#include "tests/fem/convergence.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::manufactured_solution_test {
namespace {

const std::vector<GridData>& grids() {
  static const std::vector<GridData> grids = [] {
    std::vector<GridData> list{quarter_disc_grid(1, 4, 6, 0.6)};
    for (int k = 0; k < 2; ++k) list.push_back(refined(list.back()));
    return list;
  }();
  return grids;
}

struct Errors {
  std::vector<double> displacement, pressure;
};

Errors errors(const FourierOrder& order, unsigned degree, const StokesField& load, const StokesField& exact) {
  Errors errors;
  for (const auto& grid : grids()) {
    const auto error = bulk_error(HarmonicSpace(grid, order, degree), load, exact);
    errors.displacement.push_back(error.displacement);
    errors.pressure.push_back(error.pressure);
  }
  return errors;
}

/// A field with something about it changed.
template <typename Change>
StokesField changed(const StokesField& field, Change change) {
  return [=](double r, double z) {
    auto state = field(r, z);
    change(state);
    return state;
  };
}

class PointForce : public testing::TestWithParam<FourierOrder> {
 protected:
  StokesField field_ = point_force(GetParam(), 1);
};

INSTANTIATE_TEST_SUITE_P(Harmonics, PointForce, testing::Values(axisymmetric, lateral));

// Strains of the harmonics by central differences: truncation h^2, roundoff 1e-16/h.
TEST_P(PointForce, HasTheStressOfItsStrains) {
  const int n = GetParam() == axisymmetric ? 0 : 1;
  const double h = 1e-5;
  for (const auto& [r, z] : {std::pair{0.7, -0.3}, {2.0, -1.5}, {0.2, -4.0}}) {
    const auto at = field_(r, z), east = field_(r + h, z), west = field_(r - h, z);
    const auto north = field_(r, z + h), south = field_(r, z - h);
    const auto along_r = [&](double StokesState::*f) { return (east.*f - west.*f) / (2 * h); };
    const auto along_z = [&](double StokesState::*f) { return (north.*f - south.*f) / (2 * h); };
    const double rr = along_r(&StokesState::u), hoop = (at.u + n * at.v) / r, zz = along_z(&StokesState::w);
    EXPECT_NEAR(rr + hoop + zz, 0, 1e-9);
    EXPECT_NEAR(at.stress[0][0], 2 * rr - at.pressure, 1e-9);
    EXPECT_NEAR(at.stress[2][1], 2 * zz - at.pressure, 1e-9);
    const double shear_rz = along_z(&StokesState::u) + along_r(&StokesState::w);
    EXPECT_NEAR(at.stress[0][1], shear_rz, 1e-9);
    EXPECT_NEAR(at.stress[2][0], shear_rz, 1e-9);
    EXPECT_NEAR(at.stress[1][0], -n * at.u / r + along_r(&StokesState::v) - at.v / r, 1e-9);
    EXPECT_NEAR(at.stress[1][1], along_z(&StokesState::v) - n * at.w / r, 1e-9);
    // The hoop stress is what radial equilibrium leaves for it: none, the stress of a point force is radial.
    EXPECT_NEAR(2 * hoop, at.pressure, 1e-9);
  }
}

// Optimal orders: k + 1 for the displacement, k for the pressure of degree k - 1.
TEST_P(PointForce, IsApproachedAtTheOrdersOfTheElements) {
  for (const unsigned degree : {2U, 3U}) {
    const auto [displacement, pressure] = errors(GetParam(), degree, field_, field_);
    EXPECT_GT(observed_order(displacement), degree + 0.8) << displacement.back();
    EXPECT_GT(observed_order(pressure), degree - 0.3) << pressure.back();
    EXPECT_LT(displacement.back(), 1e-4);
    EXPECT_LT(pressure.back(), 1e-3);
  }
}

void expect_no_convergence(const Errors& errors) {
  EXPECT_LT(observed_order(errors.displacement), 0.2);
  EXPECT_GT(errors.displacement.back(), 1e-2);
}

TEST_P(PointForce, WithoutItsShareOfTheFarFieldConditionIsAnother) {
  const auto load = changed(field_, [](StokesState& state) { state.u = state.w = 0; });
  expect_no_convergence(errors(GetParam(), 3, load, field_));
}

TEST_P(PointForce, WithTheShearReversedIsAnother) {
  const auto load = changed(field_, [](StokesState& state) {
    state.stress[0][1] *= -1;
    state.stress[2][0] *= -1;
  });
  expect_no_convergence(errors(GetParam(), 3, load, field_));
}

TEST_P(PointForce, WithThePressureReversedIsAnother) {
  const auto exact = changed(field_, [](StokesState& state) { state.pressure *= -1; });
  const auto error = bulk_error(HarmonicSpace(grids().front(), GetParam(), 3), field_, exact);
  EXPECT_NEAR(error.pressure, 2, 1e-2);
}

// The norms are those of the body, whose volume grows with the distance from the axis: a pressure that is held to 1 + r
// times itself, against sums over the quarter disc in polar coordinates.
TEST_P(PointForce, HasErrorsOverTheVolume) {
  const auto exact = [&](double r, double z) {
    auto state = field_(r, z);
    state.pressure *= 1 + r;
    return state;
  };
  const auto& grid = grids().back();
  double far = 0;
  for (const auto& point : grid.points) far = std::max(far, std::hypot(point[0], point[1]));
  constexpr int n = 400;
  double off = 0, all = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double distance = (i + 0.5) * far / n, angle = (j + 0.5) * pi / 2 / n, r = distance * std::sin(angle),
                   p = field_(r, -distance * std::cos(angle)).pressure, volume = r * distance;
      off += volume * std::pow(r * p, 2);
      all += volume * std::pow((1 + r) * p, 2);
    }
  const auto error = bulk_error(HarmonicSpace(grid, GetParam(), 3), field_, exact);
  EXPECT_NEAR(error.pressure, std::sqrt(off / all), 2e-3);
}

}  // namespace
}  // namespace fretval::fem::manufactured_solution_test
