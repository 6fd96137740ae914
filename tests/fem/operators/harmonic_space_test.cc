#include "fem/operators/harmonic_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fem/operators/harmonic_space_parts.h"
#include "fem/support/constants.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::harmonic_space_test {
namespace {

const GridData& grid() {
  static const GridData grid = quarter_disc_grid(1, 8, 6, 0.35);
  return grid;
}

/// One cell below the unit disc.
GridData one_cell() {
  return {{{0, -1}, {1, -1}, {1, 0}, {0, 0}},
          {{0, 1, 2, 3}},
          {{{0, 1}, BoundaryPart::far},
           {{1, 2}, BoundaryPart::far},
           {{2, 3}, BoundaryPart::contact},
           {{3, 0}, BoundaryPart::axis}}};
}

TEST(ContactLine, RingsCarryTheirArea) {
  for (const FourierOrder order : {axisymmetric, lateral}) {
    const HarmonicSpace space(grid(), order, 3);
    const auto& line = space.contact_line();
    ASSERT_EQ(line.n_elements(), 8);
    ASSERT_EQ(line.dofs.size(), 25U);
    for (Eigen::Index i = 0; i < 8; ++i) {
      EXPECT_DOUBLE_EQ(line.radii[i], i / 8.0);
      EXPECT_NEAR(line.areas[i], pi * (2 * i + 1) / 64, 1e-15);
      EXPECT_NEAR(line.loads.col(i).sum(), line.areas[i], 1e-15);
    }
  }
}

// int r dA = (2 pi/3)(r_1^3 - r_0^3) of the field r at the evenly spaced dofs: they are in order. Roundoff.
TEST(ContactLine, DofsGoOutwards) {
  for (const FourierOrder order : {axisymmetric, lateral}) {
    const HarmonicSpace space(grid(), order, 2);
    const auto& line = space.contact_line();
    const Eigen::VectorXd moments = line.loads.transpose() * Eigen::VectorXd::LinSpaced(17, 0, 1);
    for (Eigen::Index i = 0; i < 8; ++i)
      EXPECT_NEAR(moments[i], 2 * pi / 3 * (std::pow(line.radii[i + 1], 3) - std::pow(line.radii[i], 3)), 1e-14);
  }
}

// On the axis of one cell k + 1 dofs of each displacement, k of the pressure. n = 0: U = 0. n = 1: m = W = P = 0 and
// the rotation.
TEST(HarmonicSpace, HoldsTheAxisAndTheRotationAlone) {
  for (const unsigned k : {2U, 3U}) {
    const HarmonicSpace normal(one_cell(), axisymmetric, k), tangential(one_cell(), lateral, k);
    EXPECT_EQ(normal.n_dofs(), 2 * (k + 1) * (k + 1) + k * k);
    EXPECT_EQ(tangential.n_dofs(), 3 * (k + 1) * (k + 1) + k * k);
    EXPECT_EQ(normal.parts().constraints.n_constraints(), k + 1);
    EXPECT_EQ(tangential.parts().constraints.n_constraints(), 2 * (k + 1) + k + 1);
    for (const HarmonicSpace* space : {&normal, &tangential})
      EXPECT_EQ(space->parts().constraints.is_constrained(space->contact_line().dofs[0]), false);
  }
}

// Axis of one cell: V = 0 in torsion, all of n >= 2. A bonded base and side hold all but the contact line.
TEST(HarmonicSpace, HoldsHigherOrdersAndTorsionOnTheAxis) {
  const unsigned k = 3;
  const HarmonicSpace torsion(one_cell(), {0, Parity::odd}, k), second(one_cell(), {2, Parity::even}, k);
  EXPECT_EQ(torsion.n_dofs(), (k + 1) * (k + 1));
  EXPECT_EQ(torsion.parts().constraints.n_constraints(), k + 1);
  EXPECT_EQ(second.parts().constraints.n_constraints(), 3 * (k + 1) + k);
  auto bonded = one_cell();
  for (auto& edge : bonded.boundary)
    if (edge.part == BoundaryPart::far) edge.part = BoundaryPart::bonded;
  EXPECT_EQ(HarmonicSpace(bonded, {0, Parity::odd}, k).parts().constraints.n_constraints(),
            (k + 1) * (k + 1) - k * (k - 1));
}

// s, then W, whose pressure counts half, without the dofs that the axis holds.
TEST(ContactLine, OfSeveralComponentsHasOneAfterTheOther) {
  const HarmonicSpace space(grid(), lateral, 2);
  const auto s = space.contact_line({0}), w = space.contact_line({2}), both = space.contact_line({0, 2});
  EXPECT_EQ(s.dofs.size(), 17U);
  EXPECT_EQ(w.dofs.size(), 16U);
  ASSERT_EQ(both.dofs.size(), 33U);
  EXPECT_EQ(both.loads.topLeftCorner(17, 8), s.loads);
  EXPECT_EQ(both.loads.bottomRightCorner(16, 8), w.loads);
  EXPECT_EQ(both.loads.topRightCorner(17, 8).norm() + both.loads.bottomLeftCorner(16, 8).norm(), 0);
  for (Eigen::Index i = 1; i < 8; ++i) EXPECT_NEAR(w.loads.col(i).sum(), w.areas[i] / 2, 1e-15);
}

TEST(HarmonicSpace, RefusesBodiesThatNothingHolds) {
  auto sliding = grid();
  for (auto& edge : sliding.boundary)
    if (edge.part == BoundaryPart::far) edge.part = BoundaryPart::sliding;
  EXPECT_NO_THROW(HarmonicSpace(sliding, axisymmetric, 2));
  EXPECT_THROW(HarmonicSpace(sliding, lateral, 2), std::invalid_argument);
  EXPECT_THROW(HarmonicSpace(sliding, {0, Parity::odd}, 2), std::invalid_argument);
}

TEST(HarmonicSpace, RefusesImpossibleMaterials) {
  for (const double nu : {-0.1, 0.51, std::nan("")}) {
    auto body = grid();
    body.elasticity.poisson_ratio = nu;
    EXPECT_THROW(HarmonicSpace(body, axisymmetric, 2), std::invalid_argument);
  }
  auto body = grid();
  body.elasticity.moduli.assign(body.cells.size() - 1, 1);
  EXPECT_THROW(HarmonicSpace(body, axisymmetric, 2), std::invalid_argument);
  body.elasticity.moduli.assign(body.cells.size(), 0);
  EXPECT_THROW(HarmonicSpace(body, axisymmetric, 2), std::invalid_argument);
}

TEST(HarmonicSpace, RefusesWhatItCannotUse) {
  EXPECT_THROW(HarmonicSpace(grid(), axisymmetric, 1), std::invalid_argument);
  for (const BoundaryPart part : {BoundaryPart::contact, BoundaryPart::far}) {
    GridData without = grid();
    for (auto& edge : without.boundary)
      if (edge.part == part) edge.part = BoundaryPart::free;
    EXPECT_THROW(HarmonicSpace(without, axisymmetric, 2), std::invalid_argument);
  }
}

}  // namespace
}  // namespace fretval::fem::harmonic_space_test
