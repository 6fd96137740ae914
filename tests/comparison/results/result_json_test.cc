#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "comparison/results/case_result.h"
#include "tests/comparison/fake_numerics.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

CaseResult result_with(const FakeNumerics& numerics, const ErrorBudget& budget = {}) {
  const auto prepared = prepared_case(elastic_case());
  ProvedAnswer fe;
  fe.resolution = prepared.fem.resolution;
  fe.fe = numerics(prepared.fem, fe.resolution);
  fe.budget = budget;
  return result_of(prepared, mdr_normal_response(prepared.mdr), Proof::bars, std::move(fe));
}

/// As a reader finds it.
nlohmann::json written(const CaseResult& result) {
  return nlohmann::json::parse(result_json(result).dump());
}

TEST(ResultJson, IsNullForWhatIsAbsent) {
  auto result = result_with({0, 0, 0, 0.5});
  result.fe.fe.contact_radius_max.reset();
  const auto json = written(result);
  EXPECT_TRUE(json["fe"]["stick_radius_first_slip"].is_null());
  EXPECT_TRUE(json["fe"]["contact_radius_max"].is_null());
  EXPECT_TRUE(json["fe"]["worn_radius"].is_null());
  EXPECT_TRUE(json["fe"]["stick_radius_shakedown"].is_number());
  const auto& one_sided = json["comparison"]["stick_radius_first_slip"];
  EXPECT_TRUE(one_sided["difference"].is_null()) << "MDR has one";
  EXPECT_TRUE(one_sided["error_bar"].is_null()) << "none was measured";
  EXPECT_EQ(one_sided["verdict"], "fail");
  EXPECT_EQ(json["pass"], false);
}

TEST(ResultJson, NamesWhatFiniteElementsLeaveOut) {
  auto result = result_with({0, 0});
  EXPECT_FALSE(written(result)["scene"].contains("left_out"));
  result.input.wear_kinetics = Case::WearKinetics{1e-13, 1e6};
  EXPECT_EQ(written(result)["scene"]["left_out"], (nlohmann::json{"Wear / Coefficient", "Wear / Cycles"}));
}

TEST(ResultJson, HasBarsBySourceAndNullForAnUnboundedOne) {
  const ErrorBar bounded{{{ErrorSource::rings, 0.25, 2.5}, {ErrorSource::time_step, 0.5, std::nullopt}}},
      unbounded{{{ErrorSource::rings, std::numeric_limits<double>::infinity(), std::nullopt}}};
  const auto json = written(result_with(
      {0, 0}, {{Quantity::stick_radius_shakedown, bounded}, {Quantity::stick_radius_first_slip, unbounded}}));
  const auto& bar = json["fe"]["error_estimate"]["stick_radius_shakedown"];
  EXPECT_EQ(bar["total"], 0.75);
  EXPECT_EQ(bar["shares"]["rings"]["order"], 2.5);
  EXPECT_TRUE(bar["shares"]["time step"]["order"].is_null());
  EXPECT_EQ(json["comparison"]["stick_radius_shakedown"]["error_bar"], 0.75);
  EXPECT_TRUE(json["comparison"]["stick_radius_first_slip"]["error_bar"].is_null());
  EXPECT_EQ(json["comparison"]["stick_radius_first_slip"]["verdict"], "inconclusive");
  EXPECT_TRUE(json["fe"]["error_estimate"]["normal_force_max"].is_null());
}

}  // namespace
}  // namespace fretval
