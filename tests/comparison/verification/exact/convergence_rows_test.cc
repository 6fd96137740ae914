#include "comparison/verification/exact/convergence_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "comparison/verification/exact/exact_rows.h"

namespace fretval {
namespace {

const std::vector<int> rungs{16, 32, 64, 128};

/// Errors factor n^-order.
ConvergenceRow power(double factor, double order) {
  ConvergenceRow row{"solution", "quantity", "a book", {1e-3, 2, 0, 1e-4, ""}, "rings", rungs};
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

TEST(ConvergenceRow, TellsTheGoalFromTheTolerance) {
  EXPECT_EQ(meets_goal(power(0.1, 2)), true);
  EXPECT_EQ(meets_goal(power(1, 2)), false);
  auto row = power(1, 2);
  row.demand.goal.reset();
  EXPECT_FALSE(meets_goal(row).has_value());
  row.demand.goal = 1;
  row.errors[2] = std::nan("");
  EXPECT_EQ(meets_goal(row), false);
}

TEST(ConvergenceRow, WritesJUnitXml) {
  const auto xml = convergence_junit({power(1, 2), power(1, 1)});
  EXPECT_NE(xml.find("tests=\"2\" failures=\"1\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"solution: quantity\"/>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("<failure message=\"error 1.6e-02"), std::string::npos) << xml;
}

/// Meshes of the tests: without the finest one of the suite.
const std::vector<ConvergenceMesh>& three_meshes() {
  static const auto meshes = half_space_meshes({16, 32, 64});
  return meshes;
}

std::vector<ConvergenceRow> hertz_rows(const ExactIndentation& exact) {
  return indentation_rows(three_meshes(), exact, {1e-6, 3, 1e-7, 1e-6, ""}, {1e-6, 3, 1e-6, 1e-5, ""});
}

TEST(ConvergenceRow, WritesJsonWithNullForWhatIsAbsent) {
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

TEST(ConvergenceGuard, AnotherForceOrRadiusThanHertzFails) {
  const auto exact = exact_indentation("Hertz", "", 2);
  for (const auto& row : hertz_rows(exact)) EXPECT_EQ(failure_of(row), "") << row.quantity;
  auto wrong_force = exact, wrong_radius = exact;
  wrong_force.force = [&](double d) { return 1.00001 * exact.force(d); };
  wrong_radius.contact_radius = [&](double d) { return 1.00001 * exact.contact_radius(d); };
  EXPECT_NE(failure_of(hertz_rows(wrong_force)[1]), "");
  EXPECT_NE(failure_of(hertz_rows(wrong_radius)[0]), "");
}

TEST(ConvergenceGuardSlow, AnotherCurveThanCattaneoAndMindlinFails) {
  const auto exact = exact_sliding();
  for (const auto& row : sliding_rows(three_meshes(), exact)) EXPECT_EQ(failure_of(row), "") << row.quantity;
  const ExactSliding wrong{[&](double u) { return exact.stick_radius(u) + 1e-5; },
                           [&](double u) { return 1.01 * exact.force(u); },
                           [&](double f) { return 1.01 * exact.displacement(f); }};
  for (const auto& row : sliding_rows(three_meshes(), wrong)) EXPECT_NE(failure_of(row), "") << row.quantity;
}

TEST(ConvergenceGuardSlow, AnotherCurveThanCattaneoAndMindlinFailsTheUnloading) {
  const auto exact = exact_sliding();
  EXPECT_EQ(failure_of(unloading_row(three_meshes(), exact)), "");
  const ExactSliding wrong{exact.stick_radius, [&](double u) { return exact.force(1.01 * u); }, exact.displacement};
  EXPECT_NE(failure_of(unloading_row(three_meshes(), wrong)), "");
}

TEST(ConvergenceGuardSlow, AnotherSlopeFailsTheObliqueLoading) {
  const auto exact = exact_oblique(oblique_loading);
  for (const auto& row : oblique_rows(three_meshes(), exact)) EXPECT_EQ(failure_of(row), "") << row.quantity;
  auto other = oblique_loading;
  other.sticking_slope *= 1.05;
  EXPECT_NE(failure_of(oblique_rows(three_meshes(), exact_oblique(other))[0]), "");
  // Far off, no stick radius is left to be measured.
  for (const double off : {1e-5, 1.0}) {
    const ExactOblique wrong{[&](double d) { return exact.stick_radius(d) + off; }, exact.force};
    EXPECT_NE(failure_of(oblique_rows(three_meshes(), wrong)[1]), "") << off;
  }
}

TEST(ConvergenceGuardSlow, AnotherStiffnessOfAPunchFails) {
  const auto exact = exact_punch();
  for (const auto& row : punch_rows(three_meshes(), exact))
    EXPECT_EQ(failure_of(row), "") << row.solution << row.quantity;
  for (const auto& row : punch_rows(three_meshes(), {1.01 * exact.normal, 1.01 * exact.tangential}))
    EXPECT_NE(failure_of(row), "") << row.solution << row.quantity;
}

TEST(ConvergenceGuardSlow, AnotherProfileThanTheWornOneFails) {
  EXPECT_EQ(failure_of(worn_edge_row(three_meshes(), mdr::parabola(1))), "");
  EXPECT_NE(failure_of(worn_edge_row(three_meshes(), mdr::parabola(1.001))), "");
}

TEST(ConvergenceGuardSlow, AnotherCurveThanCattaneoAndMindlinFailsTheCycle) {
  const auto exact = exact_sliding();
  EXPECT_EQ(failure_of(cycle_row(three_meshes(), exact)), "");
  const ExactSliding wrong{exact.stick_radius, [&](double u) { return 1.01 * exact.force(u); }, exact.displacement};
  EXPECT_NE(failure_of(cycle_row(three_meshes(), wrong)), "");
}

TEST(ConvergenceGuardSlow, AnotherBranchFailsTheViscoelasticRows) {
  for (const auto row_of : {step_row, growing_contact_time_row, retraction_time_row, hertz_step_row,
                            growing_contact_mesh_row, retraction_mesh_row}) {
    EXPECT_EQ(failure_of(row_of(three_meshes(), viscoelastic_body())), "");
    EXPECT_NE(failure_of(row_of(three_meshes(), mdr::standard_solid(1, 2, 0.404))), "");
  }
}

TEST(ConvergenceGuardSlow, AnotherStickRadiusFailsThePeriodicState) {
  const ConvergenceDemand demand{1e-6, 3, 1e-7, 5e-5, ""};
  const auto solid = mdr::standard_solid(1, std::sqrt(3.5) - 1, 1);
  const PeriodicCase solution{"periodic", "", solid, 0.1, {{0.25, 30}, {0.23, 90}}, demand, demand};
  const auto exact = exact_stick_radii();
  for (const auto& row : periodic_rows(three_meshes(), solution, exact)) EXPECT_EQ(failure_of(row), "") << row.quantity;
  const auto wrong = [&](const mdr::PronyBody& body, const mdr::Motion& motion) {
    const auto radii = exact(body, motion);
    return mdr::StickRadii{*radii.first_slip + 1e-5, *radii.shakedown + 1e-5};
  };
  for (const auto& row : periodic_rows(three_meshes(), solution, wrong)) EXPECT_NE(failure_of(row), "") << row.quantity;
  // The paper's criterion is not that of the steady state.
  const auto confused = [&](const mdr::PronyBody& body, const mdr::Motion& motion) {
    const auto radii = exact(body, motion);
    return mdr::StickRadii{radii.shakedown, radii.first_slip};
  };
  for (const auto& row : periodic_rows(three_meshes(), solution, confused))
    EXPECT_NE(failure_of(row), "") << row.quantity;
}

TEST(ConvergenceGuardSlow, AnotherForceThanKelvinsFailsInTheBulk) {
  const auto meshes = bulk_meshes(3);
  for (const auto harmonic : {fem::Harmonic::normal, fem::Harmonic::tangential}) {
    const BulkCase solution{"Kelvin", harmonic, 4e-7, 3e-5};
    for (const auto& row : bulk_rows(meshes, solution, fem::point_force(harmonic, 1)))
      EXPECT_EQ(failure_of(row), "") << row.quantity;
    for (const auto& row : bulk_rows(meshes, solution, fem::point_force(harmonic, 1.001)))
      EXPECT_NE(failure_of(row), "") << row.quantity;
  }
}

}  // namespace
}  // namespace fretval
