#include "comparison/verification/exact/convergence_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace fretval::convergence_json_test {
namespace {

const std::vector<int> rungs{16, 32, 64, 128};

/// Errors factor n^-order.
ConvergenceRow power(double factor, double order) {
  ConvergenceRow row{"solution", "quantity", "a book", "rings", rungs, {}, {1e-3, 2, 0, 1e-4, ""}};
  for (const int n : rungs) row.errors.push_back(factor * std::pow(n, -order));
  return row;
}

TEST(ConvergenceJson, HasAnObjectARowAndNullForWhatIsAbsent) {
  auto at_floor = power(1e-2, 2);
  at_floor.demand.floor = 1;
  at_floor.demand.goal.reset();
  at_floor.demand.note = "a note";
  auto broken = power(1, 2);
  broken.errors[0] = std::nan("");
  // Through text, as a reader gets it.
  const auto json = nlohmann::json::parse(convergence_json({power(1, 2), at_floor, power(1, 1), broken}).dump());
  ASSERT_EQ(json.size(), 4U);
  EXPECT_EQ(json[0]["solution"], "solution");
  EXPECT_EQ(json[0]["quantity"], "quantity");
  EXPECT_EQ(json[0]["source"], "a book");
  EXPECT_EQ(json[0]["refined"], "rings");
  EXPECT_EQ(json[0]["resolutions"], nlohmann::json(rungs));
  EXPECT_EQ(json[0]["errors"][1], std::pow(32, -2.0));
  EXPECT_NEAR(json[0]["observed_order"], 2, 1e-12);
  EXPECT_EQ(json[0]["expected_order"], 2);
  EXPECT_EQ(json[0]["tolerance"], 1e-3);
  EXPECT_EQ(json[0]["goal"], 1e-4);
  EXPECT_EQ(json[0]["goal_met"], false);
  EXPECT_EQ(json[0]["verdict"], "pass");
  EXPECT_TRUE(json[1]["observed_order"].is_null());
  EXPECT_TRUE(json[1]["goal"].is_null());
  EXPECT_TRUE(json[1]["goal_met"].is_null());
  EXPECT_EQ(json[1]["note"], "a note");
  EXPECT_EQ(json[2]["verdict"], "error 1.6e-02 at 64 rings, tolerance 1.0e-03");
  EXPECT_TRUE(json[3]["errors"][0].is_null());
  EXPECT_EQ(json[3]["verdict"], "error at 16 rings not finite");
}

}  // namespace
}  // namespace fretval::convergence_json_test
