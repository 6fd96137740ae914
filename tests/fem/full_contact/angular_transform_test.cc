#include "fem/full_contact/angular_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace fretval::fem::angular_transform_test {
namespace {

using Eigen::MatrixXd;

/// T^T as one matrix, a column for each amplitude.
MatrixXd weights_of(const std::vector<Amplitude>& amplitudes) {
  MatrixXd weights(amplitudes.front().weights.size(), static_cast<Eigen::Index>(amplitudes.size()));
  for (Eigen::Index i = 0; i < weights.cols(); ++i) weights.col(i) = amplitudes[static_cast<std::size_t>(i)].weights;
  return weights;
}

// Numbers of angles that both mirrors halve, that one does, and that none does.
TEST(AngularTransform, IsTheOneByTheWeightsOfTheAmplitudes) {
  const std::vector<AngularGrid> grids{angular_grid(1),
                                       angular_grid(2),
                                       angular_grid(6),
                                       angular_grid(7),
                                       angular_grid(16),
                                       angular_grid(6, Mirrors::x),
                                       angular_grid(8, Mirrors::x),
                                       angular_grid(12, Mirrors::x_and_y)};
  for (const auto& grid : grids)
    for (const auto kind : {SurfaceField::tangential, SurfaceField::normal}) {
      SCOPED_TRACE(std::to_string(grid.n_around) + " angles");
      const auto amplitudes = amplitudes_of(grid, kind);
      const MatrixXd weights = weights_of(amplitudes);
      const AngularTransform<double> transform(grid, kind, amplitudes);
      ASSERT_EQ(transform.n_amplitudes(), weights.cols());
      ASSERT_EQ(transform.n_columns(), weights.rows());

      const MatrixXd field = MatrixXd::Random(3, weights.rows()), values = MatrixXd::Random(3, weights.cols());
      MatrixXd found(3, weights.cols()), back;
      transform.amplitudes_of(field, found);
      transform.field_of(values, back);
      EXPECT_LT((found - field * weights).norm(), 1e-14 * field.norm());
      EXPECT_LT((back - values * weights.transpose()).norm(), 1e-14 * values.norm());
      EXPECT_LT((transform.squares() - weights.colwise().squaredNorm().transpose()).norm(), 1e-14);

      Eigen::VectorXd factors = Eigen::VectorXd::LinSpaced(weights.cols(), 1, 2);
      Eigen::MatrixXf single;
      transform.scaled(factors).field_of(values.cast<float>(), single);
      EXPECT_LT((single.cast<double>() - values * factors.asDiagonal() * weights.transpose()).norm(),
                1e-6 * values.norm());
    }
}

TEST(AngularTransform, WantsAmplitudesInTheOrderOfTheirSymmetries) {
  const auto grid = angular_grid(8);
  auto amplitudes = amplitudes_of(grid, SurfaceField::tangential);
  std::reverse(amplitudes.begin(), amplitudes.end());
  EXPECT_THROW(AngularTransform<double>(grid, SurfaceField::tangential, amplitudes), std::logic_error);
}

}  // namespace
}  // namespace fretval::fem::angular_transform_test
