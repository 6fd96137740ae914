#include "comparison/verification/exact/exact_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/comparison/run_fretval.h"

namespace fretval::exact_rows_test {
namespace {

// All rows: a heading, a line a row and the verdict.
TEST(ExactRowsSlow, AllPassAndAreTabulatedByTheProgram) {
  const ScratchFolder folder;
  const auto junit = folder.path() / "junit.xml", json = folder.path() / "exact.json";
  const auto run = fretval_run("check --suite exact --junit " + junit.string() + " --json " + json.string(), folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1 + 128 + 1) << run.out;
  EXPECT_NE(text_of(junit).find("tests=\"128\" failures=\"0\""), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text_of(json)).size(), 128U);
}

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
}  // namespace fretval::exact_rows_test
