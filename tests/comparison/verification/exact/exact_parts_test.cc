#include "comparison/verification/exact/exact_parts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fretval {
namespace {

TEST(ExactParts, PositionsReachBothEnds) {
  EXPECT_EQ(position(0, 0.3, 0.9), 0.3);
  EXPECT_DOUBLE_EQ(position(n_positions - 1, 0.3, 0.9), 0.9);
  EXPECT_DOUBLE_EQ(position((n_positions - 1) / 2, 1, -1), 0);
}

TEST(ExactParts, TheWorstErrorIsTheLargestOrNone) {
  double worst = 0;
  for (const double error : {1e-3, -2e-3, 5e-4}) take_worst(worst, error);
  EXPECT_EQ(worst, 2e-3);
  for (const double error : {std::nan(""), 1.0}) take_worst(worst, error);
  EXPECT_TRUE(std::isnan(worst));
}

TEST(ExactParts, RowsHaveAnErrorAMeshOrANumberOfSteps) {
  const ConvergenceRow row{"solution", "quantity", "", {1, 1, 0, ""}};
  const auto in_time = time_row(row, {10, 20}, [](int n) { return 1.0 / n; });
  EXPECT_EQ(in_time.refined, "steps");
  EXPECT_EQ(in_time.errors, (std::vector<double>{0.1, 0.05}));
  struct Mesh {
    int n_rings;
  };
  const auto both = mesh_rows(Rows{row, row}, std::vector<Mesh>{{8}, {16}}, [](const Mesh& mesh) {
    return std::vector<double>{1.0 * mesh.n_rings, 0};
  });
  EXPECT_EQ(both[0].resolutions, (std::vector<int>{8, 16}));
  EXPECT_EQ(both[0].errors, (std::vector<double>{8, 16}));
  EXPECT_EQ(both[1].errors, (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace fretval
