#include "comparison/results/case_result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/results/results_folder.h"
#include "tests/comparison/made_up_result.h"
#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

// What is written comes back with the motion, and with the force that both methods say.
TEST(CaseResult, IsReadBackAsItIsWritten) {
  auto prepared = prepared_case(elastic_case());
  prepared.input.fields = Case::Fields::none;
  const auto reference = mdr_normal_response(prepared.mdr);
  BodyStore bodies;
  const auto result = result_of(prepared, {mdr_answer_with_cycle(prepared.mdr, reference)}, Proof::none,
                                prove(prepared, Proof::none, bodies));
  const ScratchFolder folder;
  const auto place = folder.path() / "new" / "case";
  write_result(result, result_json(result), reference, place);
  const auto stored = read_results(folder.path()).at(0);
  EXPECT_EQ(stored.number("fe", "stick_radius_shakedown"), result.fe.fe.stick_radius_shakedown.value());
  EXPECT_EQ(stored.number("mdr", "stick_radius_shakedown"), result.mdr.stick_radius_shakedown.value());
  EXPECT_EQ(outcome_of(result), Outcome::not_proved);

  const auto largest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  const auto [d, u] = read_columns(place / "history.csv", "d [m]", "u_x [m]");
  EXPECT_NEAR(largest(d), 1.2e-4, 1e-7);  // half a step of 32 off the peak
  EXPECT_NEAR(largest(u), 1.5e-5, 1e-7);
  const auto [fe, mdr] = read_columns(place / "history.csv", "F_N [N]", "F_N MDR [N]");
  ASSERT_GE(fe.size(), 16U);
  for (std::size_t k = 0; k < fe.size(); ++k) EXPECT_NEAR(fe[k], mdr[k], 5e-3 * largest(mdr)) << k;
  const auto [inner, pressure] = read_columns(place / "contact.csv", "r inner [m]", "p largest [Pa]");
  EXPECT_EQ(inner.front(), 0);
  EXPECT_EQ(largest(pressure), pressure.front());
  const auto [r, worn] = read_columns(place / "profile.csv", "r [m]", "f limiting [m]");
  EXPECT_GT(r.back(), result.mdr.worn_radius.value());
  EXPECT_FALSE(fs::exists(place / "fields.pvd"));
}

/// What of a result is written to one of its files.
std::string written(const CaseResult& result, const char* file) {
  const ScratchFolder folder;
  write_result(result, result_json(result), made_up_reference(), folder.path());
  return text_of(folder.path() / file);
}

// The period ends with step 12, at the deepest position: 12 s after the start, d = (0.75 + 0.25 cos) 0.5 m and
// u_x = 0.125 cos(t + 60 deg) 0.5 m, forces with what presses beyond the first free ring.
TEST(CaseResult, HasItsHistoryInSiUnitsStepByStep) {
  EXPECT_EQ(written(made_up_result(), "history.csv"),
            "t [s],d [m],u_x [m],F_N [N],F_N MDR [N],F_x [N]\n"
            "9,0.375,-0.05412658774,15,200,-10\n"
            "10,0.25,-0.03125,20,300,-20\n"
            "11,0.375,0.05412658774,30,400,10\n"
            "12,0.5,0.03125,42.5,100,20\n");
}

// A path whose mean is 3 mm off the origin of its displacements: u_x counts from there, as in the file.
TEST(CaseResult, AlongAPathHasItsDisplacementsAsInTheFile) {
  auto result = made_up_result();
  result.input.motion.path = Case::Path{{{0, 1, 2}, {1e-4, 1.2e-4, 1e-4}, {2e-3, 4e-3, 2e-3}, true}, "a.csv"};
  const ScratchFolder folder;
  write_result(result, result_json(result), made_up_reference(), folder.path());
  const auto u = read_columns(folder.path() / "history.csv", "t [s]", "u_x [m]").second;
  const std::vector<double> from_rest{-0.05412658774, -0.03125, 0.05412658774, 0.03125};
  ASSERT_EQ(u.size(), from_rest.size());
  for (std::size_t k = 0; k < u.size(); ++k) EXPECT_NEAR(u[k], 3e-3 + from_rest[k], 1e-10) << k;
}

// Steps end at whole seconds, a quarter of a second after an instant of MDR's answer, or one before its next.
TEST(CaseResult, HasMdrsForceBetweenItsInstants) {
  auto result = made_up_result();
  mdr::NormalResponse reference{};
  reference.time = {0, 0.75, 1.75, 2.75, 4};
  reference.normal_force = {100, 200, 300, 500, 100};
  const ScratchFolder folder;
  write_result(result, result_json(result), reference, folder.path());
  const auto force = read_columns(folder.path() / "history.csv", "t [s]", "F_N MDR [N]").second;
  const std::vector<double> expected{225, 350, 500 - 400 * 0.2, 100};
  ASSERT_EQ(force.size(), expected.size());
  for (std::size_t k = 0; k < force.size(); ++k) EXPECT_NEAR(force[k], expected[k], 1e-6) << k;
}

TEST(CaseResult, HasItsRingsInSiUnits) {
  EXPECT_EQ(written(made_up_result(), "contact.csv"),
            "r inner [m],r outer [m],p smallest [Pa],p largest [Pa],tau smallest [Pa],tau largest [Pa],"
            "surface height at d max [m],slip per period [m],first slip margin [Pa],shakedown margin [Pa]\n"
            "0,1,5,12.5,-5,7.5,0.1,0,-0.25,0.5\n"
            "1,3,0,5,-1.25,1.25,0.35,0.1,1,-1\n");
}

// What is not touched in the period moves against the indenter, and does not slip.
TEST(CaseResult, HasNoSlipOutsideContact) {
  auto result = made_up_result();
  result.fe.fe.normal.pressure.row(1).setZero();
  EXPECT_NE(written(result, "contact.csv").find(",0.35,nan,"), std::string::npos) << written(result, "contact.csv");
}

TEST(CaseResult, OfGrossSlipComparesNothingElse) {
  auto result = made_up_result();
  EXPECT_EQ(outcome_of(result), Outcome::disagree) << "in the shakedown radius";
  result.fe.fe.of_kind = GrossSlipStart{12, 0.933};
  result.mdr.of_kind = GrossSlipShare{0.859};
  EXPECT_EQ(outcome_of(result), Outcome::agree);
}

/// What wear takes off a parabola beyond c, (13) of the paper in closed form.
double worn_off(double radius, double c, double deepest, double r) {
  const double angle = std::acos(c / r);
  return 2 / std::acos(-1.0) * (deepest * angle - (r * r / 2 * angle + c / 2 * std::sqrt(r * r - c * c)) / radius);
}

// R = 1e-2 m, 1.2e-4 m deep, c = 6e-4 m.
TEST(CaseResult, HasItsProfilesInMetres) {
  const ScratchFolder folder;
  const auto result = made_up_result();
  write_result(result, result_json(result), made_up_reference(), folder.path());
  const auto [r, unworn] = read_columns(folder.path() / "profile.csv", "r [m]", "f unworn [m]");
  const auto limiting = read_columns(folder.path() / "profile.csv", "r [m]", "f limiting [m]").second;
  ASSERT_EQ(r.size(), 400U);
  EXPECT_EQ(r.front(), 0);
  for (std::size_t k = 0; k < r.size(); ++k) {
    const double f = 50 * r[k] * r[k], worn = r[k] > 6e-4 ? worn_off(1e-2, 6e-4, 1.2e-4, r[k]) : 0;
    EXPECT_NEAR(unworn[k], f, 1e-9 * f) << r[k];
    EXPECT_NEAR(limiting[k], f + std::max(worn, 0.0), 1e-9 * f) << r[k];
  }
  EXPECT_LT(worn_off(1e-2, 6e-4, 1.2e-4, r.back()), 0) << "beyond the end of the wear";
}

TEST(CaseResult, SaysHowItWasComputed) {
  auto result = made_up_result();
  result.fem_case.resolution = {24, 3, 0.5, 12, 4, 8, 1e-5};
  result.fe.focus[Quantity::stick_radius_shakedown] = {0.25, 0.75, 0.0625};
  auto json = nlohmann::json::parse(written(result, "run.json"));
  EXPECT_EQ(json["versions"].size(), 6U);
  json.erase("versions");
  EXPECT_EQ(json, nlohmann::json::parse(R"({
    "resolution": {"elements_per_radius": 24, "degree": 3, "growth": 0.5, "far_radius": 12, "steps_per_cycle": 4,
      "ramp_cycles": 8, "periodicity": 1e-5, "refinements": 5, "computations": 6,
      "focus": {"stick_radius_shakedown": {"inner": 0.25, "outer": 0.75, "ring": 0.0625}}},
    "reached": {"periodicity_normal": 1e-6, "periodicity_tangential": 2e-6, "cycles_normal": 2},
    "mesh": {"cells": 101, "nodes": 102, "min_scaled_jacobian": 0.625, "max_aspect_ratio": 4.5},
    "units": {"length": 2, "depth": 0.5, "modulus": 10, "angular_frequency": 1.5707963267948966}})"));
}

TEST(CaseResult, IsWithdrawnWithoutWhatLiesBesideIt) {
  const ScratchFolder folder;
  folder.write("result.json", "{}");
  folder.write("history.csv", "");
  withdraw_result(folder.path());
  withdraw_result(folder.path());
  EXPECT_FALSE(fs::exists(folder.path() / "result.json"));
  EXPECT_TRUE(fs::exists(folder.path() / "history.csv"));
}

}  // namespace
}  // namespace fretval
