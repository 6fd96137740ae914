#include "comparison/verification/exact/convergence_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace fretval::convergence_rows_test {
namespace {

const std::vector<int> rungs{16, 32, 64, 128};

/// Errors factor n^-order.
ConvergenceRow power(double factor, double order) {
  ConvergenceRow row{"solution", "quantity", "a book", {1e-3, 2, 0, ""}, "rings", rungs};
  for (const int n : rungs) row.errors.push_back(factor * std::pow(n, -order));
  return row;
}

TEST(ConvergenceRow, ObservesTheOrderOfExactPowers) {
  for (const double order : {0.5, 1.0, 2.0, 3.7}) EXPECT_NEAR(observed_order(power(2, order)).value(), order, 1e-12);
  EXPECT_NEAR(observed_order(power(-2, 2)).value(), 2, 1e-12);
}

TEST(ConvergenceRow, LeavesTheFloorOutOfTheOrder) {
  auto row = power(1, 2);
  row.errors[3] = row.errors[2] * 0.9;
  EXPECT_LT(observed_order(row).value(), 1.8);
  row.demand.floor = row.errors[2] * 0.95;
  EXPECT_NEAR(observed_order(row).value(), 2, 1e-12);
  row.demand.floor = row.errors[1];
  EXPECT_FALSE(observed_order(row));
  EXPECT_EQ(failure_of(row), "");
}

TEST(ConvergenceRow, AFloorDoesNotExcuseAnErrorBeyondTheTolerance) {
  auto row = power(100, 2);
  row.demand.floor = 1;
  EXPECT_FALSE(observed_order(row));
  EXPECT_NE(failure_of(row).find("error 2.4e-02 at 64 rings"), std::string::npos) << failure_of(row);
}

TEST(ConvergenceRow, PassesWithinToleranceAtTheExpectedOrder) {
  EXPECT_EQ(failure_of(power(1, 2)), "");
  EXPECT_EQ(failure_of(power(1, 2 - 0.9 * order_slack)), "");
  EXPECT_EQ(failure_of(power(1, 3)), "");
}

TEST(ConvergenceRow, FailsBelowTheExpectedOrder) {
  EXPECT_NE(failure_of(power(1e-2, 2 - 1.1 * order_slack)).find("order 1.67, expected 2"), std::string::npos);
  EXPECT_NE(failure_of(power(1e-5, -1)), "");
}

TEST(ConvergenceRow, FailsWhereRefinementLeavesTheTolerance) {
  auto row = power(1, 2);
  row.demand.expected_order = 0;
  EXPECT_EQ(failure_of(row), "");
  row.errors[3] = -2e-3;
  EXPECT_NE(failure_of(row).find("-2.0e-03 at 128 rings"), std::string::npos) << failure_of(row);
}

TEST(ConvergenceRow, FailsWithoutAnError) {
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    auto row = power(1e-3, 2);
    row.errors[i] = std::nan("");
    EXPECT_FALSE(observed_order(row));
    EXPECT_NE(failure_of(row), "") << i;
    row.errors[i] = INFINITY;
    EXPECT_NE(failure_of(row), "") << i;
  }
  auto row = power(1e-3, 2);
  row.demand.goal_resolution = 48;
  EXPECT_NE(failure_of(row).find("no error at 48"), std::string::npos);
}

TEST(ConvergenceRow, WritesJUnitXml) {
  const auto xml = convergence_junit({power(1, 2), power(1, 1)});
  EXPECT_NE(xml.find("tests=\"2\" failures=\"1\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"solution: quantity\"/>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("<failure message=\"error 1.6e-02"), std::string::npos) << xml;
}

TEST(ConvergenceRow, WritesJsonWithNullForWhatIsAbsent) {
  auto at_floor = power(1e-2, 2);
  at_floor.demand.floor = 1;
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
  EXPECT_EQ(json[0]["verdict"], "pass");
  EXPECT_TRUE(json[1]["observed_order"].is_null());
  EXPECT_EQ(json[1]["note"], "a note");
  EXPECT_EQ(json[2]["verdict"], "error 1.6e-02 at 64 rings, tolerance 1.0e-03");
  EXPECT_TRUE(json[3]["errors"][0].is_null());
  EXPECT_EQ(json[3]["verdict"], "error at 16 rings not finite");
}

}  // namespace
}  // namespace fretval::convergence_rows_test
