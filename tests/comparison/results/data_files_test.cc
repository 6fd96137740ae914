#include "comparison/results/data_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/case/test_duration.h"
#include "comparison/data/path_table.h"
#include "comparison/results/results_folder.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

TEST(DataFiles, HaveTheTraceAndWhatIsLeftOfIt) {
  const ScratchFolder folder;
  auto input = read_case();
  // Apex at 1 mm, tilt 0.01, f = r²/(2 R) with R = 10 mm.
  Case::AlignedTrace trace{{0, 0.5e-3, 1e-3, 1.6e-3, 2e-3}, {}, 1e-3, 1e-6, 0.01, 1e-4, 1e-8, false, {}, {}, 1e-8};
  for (const double x : trace.x) trace.z.push_back((x - 1e-3) * (x - 1e-3) / 0.02 + 0.01 * (x - 1e-3));
  for (int i = 0; i <= 1000; ++i) {
    trace.r.push_back(1e-6 * i);
    trace.f.push_back(1e-12 * i * i / 0.02);
  }
  input.indenter.trace = trace;
  write_data(input, folder.path());
  const auto [x, z] = read_columns(folder.path() / "trace.csv", "x [m]", "z [m]");
  EXPECT_EQ(x, trace.x);
  const auto residual = read_columns(folder.path() / "trace.csv", "x [m]", "residual [m]").second;
  EXPECT_TRUE(std::isnan(residual.front()));  // as far out as the profile goes, and no further
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(residual[i], 0, 1e-13);
  EXPECT_EQ(read_columns(folder.path() / "aligned_profile.csv", "r [m]", "f [m]").first.size(), 1001U);
  const auto json = data_json(input);
  EXPECT_EQ(json["trace"]["apex"], 1e-3);
  EXPECT_NEAR(json["trace"]["tilt"].get<double>(), 0.57294, 1e-4);
  EXPECT_EQ(json["trace"]["heights"], "downwards");
}

TEST(DataFiles, HaveTheLoopsThatWereMeasured) {
  const ScratchFolder folder;
  auto input = read_case();
  input.measured = Case::Measured{};
  input.measured->loop = "loops.csv";
  input.measured->tangential_displacement = {0, 1e-6};
  input.measured->tangential_force = {2, 3};
  write_data(input, folder.path());
  const auto [u, force] = read_columns(folder.path() / "measured_loops.csv", "u_x [m]", "F_x [N]");
  EXPECT_EQ(u, (std::vector<double>{0, 1e-6}));
  EXPECT_EQ(force, (std::vector<double>{2, 3}));
}

TEST(DataFiles, SayWhatWasMadeOfTheData) {
  auto input = read_case();
  EXPECT_TRUE(data_json(input).empty());
  limit_to_test(0.01, input);
  input.elastomer.shore_a = 40;
  Case::Path path{"rig.csv", {0, 1, 2}, {1e-4, 1.2e-4, 1.2e-4}, {0, 0, 1e-5}, false};
  path.reduction = Case::PathReduction{300'000, 7, 1e-8, 2e-8};
  input.motion = motion_along(path);
  const auto json = data_json(input);
  EXPECT_EQ(json["test_duration"]["slow_branches"], 1);
  EXPECT_EQ(json["hardness"]["shore_a"], 40);
  EXPECT_EQ(json["record"]["rows"], 300'000);
  EXPECT_EQ(json["record"]["rows_before_contact"], 7);
  EXPECT_EQ(json["record"]["tangential_error"], 2e-8);
}

}  // namespace
}  // namespace fretval
