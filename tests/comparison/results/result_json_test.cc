#include <gtest/gtest.h>
#include <sys/resource.h>

#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "comparison/results/case_inputs.h"
#include "comparison/results/case_result.h"
#include "tests/comparison/fake_numerics.h"
#include "tests/comparison/given_mesh.h"
#include "tests/comparison/made_up_result.h"
#include "tests/comparison/some_cycle.h"

namespace fretval {
namespace {

CaseResult result_with(const FakeNumerics& numerics, const ErrorBudget& budget = {}) {
  const auto prepared = prepared_case(elastic_case());
  ProvedAnswer fe;
  fe.resolution = prepared.fem.resolution;
  fe.fe = numerics(prepared.fem, fe.resolution);
  fe.budget = budget;
  return result_of(prepared, {mdr_answer_with_cycle(prepared.mdr, mdr_normal_response(prepared.mdr))}, Proof::bars,
                   std::move(fe));
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
  EXPECT_TRUE(one_sided["verdict"].is_null()) << "nothing is proved";
  EXPECT_EQ(json["verdict"], "not proved");
  EXPECT_EQ(json["pass"], true);
}

TEST(ResultJson, SaysWhetherTheMotionRepeats) {
  auto result = result_with({0, 0});
  EXPECT_EQ(written(result)["scene"]["has_period"], true);
  result.fem_case.motion.locked = false;
  EXPECT_EQ(written(result)["scene"]["has_period"], false);
}

TEST(ResultJson, HasTheLawOfWear) {
  auto result = result_with({0, 0});
  EXPECT_FALSE(written(result)["scene"].contains("wear_law"));
  EXPECT_FALSE(written(result)["fe"].contains("wear"));
  result.input.wear_kinetics = Case::WearKinetics{Case::WearLaw::power, 1e-13, 2, {}, 1e-3};
  const auto law = written(result)["scene"]["wear_law"];
  EXPECT_EQ(law["law"], "power");
  EXPECT_EQ(law["coefficient"], 1e-13);
  EXPECT_EQ(law["exponent"], 2);
  EXPECT_TRUE(law["cycles"].is_null());
  EXPECT_EQ(law["until"], 1e-3);
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
  EXPECT_EQ(json["comparison"]["stick_radius_first_slip"]["verdict"], "not resolved");
  EXPECT_TRUE(json["fe"]["error_estimate"]["normal_force_max"].is_null());
}

// A pass from rest at its first row, whose largest indentation is not that of rest and half of the range.
TEST(ResultJson, OfAPassHasItsLargestIndentationAndNoFrequency) {
  auto result = made_up_result();
  Case::Path path;
  path.time = {0, 1, 2};
  path.normal = {1e-4, 1.2e-4, 1e-4};
  path.tangential = {0, 8e-6, 0};
  path.repeats = false;
  result.input.motion.path = path;
  result.mdr_case.path = mdr::SampledPath{path.time, path.normal, path.tangential, path.repeats};
  result.mdr_case.motion_kind = MotionKind::pass;
  const auto scene = written(result)["scene"];
  EXPECT_EQ(scene["indentation_max"], 1.2e-4);
  EXPECT_EQ(scene["path"]["rows"], 3);
  EXPECT_EQ(scene["path"]["repeats"], "once");
  EXPECT_TRUE(scene["frequency"].is_null());
}

/// Of this process so far. getrusage counts in units of 1024 bytes.
long most_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

// Numbers of the case are those of its file, where d0 = 1e-4 m touches a parabola of R = 1e-2 m up to sqrt(R d0).
TEST(ResultJson, HasEveryNumberUnderItsKey) {
  auto result = made_up_result();
  result.input.file = "made/up.prm";
  result.input.name = "made up";
  result.input.sweep = Case::Sweep{"family", "Motion / Phase", 60};
  auto json = written(result);
  const long before = most_kilobytes();
  const double bytes = written(result)["cost"]["peak_memory_bytes"];
  EXPECT_GE(bytes, 1024.0 * static_cast<double>(before));
  EXPECT_LE(bytes, 1024.0 * static_cast<double>(most_kilobytes()));
  json["cost"].erase("peak_memory_bytes");
  EXPECT_NEAR(json["scene"]["contact_radius_at_rest"], 1e-3, 1e-15);
  json["scene"].erase("contact_radius_at_rest");
  EXPECT_EQ(json["scene"]["inputs"], nlohmann::json::parse(inputs_json(result.input).dump()));
  json["scene"].erase("inputs");
  EXPECT_GT(json["mdr"]["sensitivity"]["stick_radius_shakedown"]["friction_coefficient"], 0);
  json["mdr"].erase("sensitivity");
  EXPECT_EQ(json, nlohmann::json::parse(R"({
    "schema": 2, "name": "made up", "pass": false, "verdict": "disagree", "proof": "bars",
    "scene": {"file": "made/up.prm", "shape": "parabola", "rheology": "standard solid", "friction_coefficient": 0.5,
      "indentation": 1e-4, "normal_amplitude": 2e-5, "tangential_amplitude": 1.5e-5, "frequency": 1,
      "tangential_frequency": 1, "has_period": true, "phase": 60,
      "wear": "unworn", "contact_radius_unworn": 2, "tolerance": 0.01,
      "sweep": {"family": "family", "entry": "Motion / Phase", "value": 60}},
    "mdr": {"modulus_ratio": 1.5, "contact_radius_max": 1.1, "stick_radius_first_slip": 0.45,
      "stick_radius_shakedown": 6e-4, "worn_radius": 1.9, "normal_force_max": 40, "limiting_amplitude": 0.95,
      "axis_pressure_max": 12, "uncertainty": {"axis_pressure_max": 0.1}},
    "fe": {"contact_radius_max": 1.25, "stick_radius_first_slip": 0.5, "stick_radius_shakedown": 0.75,
      "worn_radius": null, "normal_force_max": 42.5, "axis_pressure_max": 12.5, "friction_work": 1.25, "lifts_off": false,
      "slip_inside_stick_zone": 0.01, "force_outside_stick_zone": 0.02, "touch_indentation": 1.03,
      "limiting_amplitude": 1.04, "absent": {"worn_radius": "finite elements did not wear the indenter"},
      "uncertainty": {"contact_radius_max": 0, "stick_radius_first_slip": 0, "stick_radius_shakedown": 0,
        "normal_force_max": 0, "axis_pressure_max": 0},
      "error_estimate": {"stick_radius_shakedown": null,
        "normal_force_max": {"total": 0.03125, "shares": {"rings": {"estimate": 0.03125, "order": 2.5}}}}},
    "comparison": {
      "normal_force_max": {"difference": 0.0625, "tolerance": 0.1, "error_bar": 0.03125, "mdr_error": 0, "asked": true,
        "verdict": "agree", "pass": true},
      "stick_radius_shakedown": {"difference": 0.15, "tolerance": 0.125, "error_bar": null, "mdr_error": 0,
        "asked": true, "verdict": "disagree", "pass": false}},
    "model": {"good_to": null, "mdr_off_by": {}},
    "cost": {"seconds": {"mesh": 1.5, "assembly": 2.5, "factorisation": 3.5, "reading": 6.5, "normal_history": 4.5,
        "friction_history": 5.5},
      "dofs": 103, "contact_nodes": 104, "time_steps": 12, "cycles": 3, "computations": 6, "bodies": 4, "bodies_from_store": 2,
      "all": {"seconds": 7.5, "time_steps": 720, "cycles": 60, "computations": 6, "bodies": 4,
        "bodies_from_store": 2}}})"));
}

// Computations of the wear are a part of all that was computed; what MDR alone says of the end stands beside what
// finite elements found, 0.65 of 2 m.
TEST(ResultJson, AddsUpTheWearAndHasItsEnd) {
  auto result = made_up_result();
  ProvedWear wear{};
  wear.fe.course.curve = {{0, 0, 2, 3, 0, 1, 0.5}};
  wear.fe.course.worn = {Eigen::Vector2d::Zero()};
  wear.distance_shakedown = wear.distance_first_slip = {0.1};
  wear.fe.worn_radius = 0.65;
  wear.cost = {5, 100, 10, 2.5, {1, 1}};
  result.wear = wear;
  auto json = written(result);
  EXPECT_EQ(json["fe"]["worn_radius"], 1.3);
  EXPECT_EQ(json["cost"]["all"]["seconds"], 7.5 + 2.5);
  EXPECT_EQ(json["cost"]["all"]["computations"], 6 + 5);
  EXPECT_EQ(json["cost"]["all"]["time_steps"], 720 + 100);
  EXPECT_EQ(json["cost"]["all"]["cycles"], 60 + 10);
  EXPECT_EQ(json["cost"]["all"]["bodies"], 4 + 1);
  EXPECT_EQ(json["cost"]["all"]["bodies_from_store"], 2 + 1);
  EXPECT_EQ(json["cost"]["computations"], 6) << "of the unworn contact alone";
  result.wear.reset();
  ProvedSurfaceWear across{};
  across.fe.course.curve = wear.fe.course.curve;
  across.cost = {5, 100, 10, 2.5, {1, 1}};
  result.surface_wear = across;
  EXPECT_EQ(written(result)["cost"]["all"]["seconds"], 7.5 + 2.5);
}

// Each number of the scene that only some cases have.
TEST(ResultJson, HasWhatASweepAHarmonicAndWearAddToTheScene) {
  auto result = made_up_result();
  result.input.sweep = Case::Sweep{"family", "Motion / Phase", 60, "Friction / Coefficient", 0.25};
  result.input.motion.tangential_harmonics = {{3e-6, 2, 90}};
  result.input.wear_kinetics = Case::WearKinetics{Case::WearLaw::archard, 1e-13, 1, 50, 0, "", "worn_rings.csv"};
  result.model.off_by[Quantity::stick_radius_shakedown] = {0.02, 0.004};
  result.comparison[Quantity::normal_force_max].mdr_error = 0.007;
  auto json = written(result);
  EXPECT_EQ(json["scene"]["sweep"]["second_entry"], "Friction / Coefficient");
  EXPECT_EQ(json["scene"]["sweep"]["second_value"], 0.25);
  EXPECT_EQ(json["scene"]["tangential_harmonics"][1]["frequency"], 2);
  EXPECT_NEAR(json["scene"]["tangential_harmonics"][1]["phase"].get<double>(), 90, 1e-12);
  EXPECT_EQ(json["scene"]["wear_law"]["profile"], "worn_rings.csv");
  EXPECT_EQ(json["scene"]["wear_law"]["cycles"], 50);
  EXPECT_EQ(json["model"]["good_to"], 0.024);
  EXPECT_EQ(json["model"]["mdr_off_by"]["stick_radius_shakedown"]["uncertainty"], 0.004);
  EXPECT_EQ(json["comparison"]["normal_force_max"]["mdr_error"], 0.007);
  result.input.wear_kinetics->rings = "";
  result.input.wear_kinetics->profile = "heights.csv";
  EXPECT_EQ(written(result)["scene"]["wear_law"]["profile"], "heights.csv");
}

// A contact whose force only just comes to nothing is lost as well; along a path it is not asked.
TEST(ResultJson, SaysWhereTheContactIsLost) {
  auto result = made_up_result();
  result.fe.fe.normal.force = Eigen::Vector4d(1, 0, 3, 4);
  EXPECT_EQ(written(result)["fe"]["lifts_off"], true);
  result.fe.fe.normal.pieces.resize(4);
  EXPECT_EQ(written(result)["fe"]["lifts_off"], false);
}

// Of eight rings in mm, 1.5 mm in all, on a pad of 3 mm.
TEST(ResultJson, HasTheMeshInMetres) {
  const ScratchFolder folder;
  const auto mesh = pad_mesh(8);
  auto result = made_up_result();
  result.input.body = case_with_mesh(folder, mesh).body;
  const auto json = written(result)["scene"]["mesh"];
  EXPECT_EQ(json["cells"], mesh.cells.size());
  EXPECT_EQ(json["contact_edges"], 8);
  EXPECT_NEAR(json["contact_line"].get<double>(), 1.5e-3, 1e-15);
  EXPECT_NEAR(json["thickness"].get<double>(), 3e-3, 1e-15);
}

TEST(ResultJson, HasTheForcesAndEnergiesOfACycle) {
  auto result = made_up_result();
  result.fe.fe.of_kind = DiscAnswer{};
  result.fe.fe.cycle = some_cycle({1, 2, 3, 4, 5});
  result.rings = GivenRings{20, 34};
  const auto json = written(result)["fe"];
  for (const auto& [key, value] : std::map<std::string, double>{{"tangential_force_max", 1},
                                                                {"tangential_force_mean", 2},
                                                                {"friction_work", 3},
                                                                {"bulk_work", 4},
                                                                {"cycle_work", 3 + 4},
                                                                {"tangential_work", 5},
                                                                {"sliding_force", 1},
                                                                {"sliding_work", 1e-4}})
    EXPECT_EQ(json[key], value) << key;
  EXPECT_EQ(json["rings"]["in_contact"], 20);
  EXPECT_EQ(json["rings"]["needed"], 34);
}

TEST(ResultJson, SaysWhenGrossSlipBegins) {
  auto result = made_up_result();
  result.fe.fe.of_kind = GrossSlipStart{12, 0.875};
  const auto json = written(result)["fe"]["gross_slip"];
  EXPECT_EQ(json["time"], 12);
  EXPECT_EQ(json["amplitude"], 0.875);
}

}  // namespace
}  // namespace fretval
