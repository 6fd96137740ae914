#include "comparison/run/batch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <future>
#include <nlohmann/json.hpp>
#include <set>

#include "comparison/support/parallel.h"
#include "fem/support/solver_error.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

TEST(Batch, ASecondAlgorithmConfirmsFrictionAsAVectorOnRequest) {
  const ScratchFolder folder;
  const std::string contact = "subsection Contact\n  set Friction = vector\n  set Coupling = off\n";
  const auto with = folder.write("with.prm", elastic_case() + contact + "  set Second algorithm = on\nend\n"),
             without = folder.write("without.prm", elastic_case() + contact + "end\n");
  auto cases = read_case_file(with);
  cases.push_back(read_case_file(without).at(0));
  BatchOptions options;
  options.proof = Proof::none;
  BodyStore bodies;
  for (const auto& line : run_batch(prepare(cases), options, bodies)) {
    ASSERT_EQ(line.failure, "");
    const auto zones = nlohmann::json::parse(line.json).at("fe").at("zones");
    ASSERT_EQ(zones.contains("second_algorithm"), line.name == "with") << line.name;
    if (!zones.contains("second_algorithm")) continue;
    EXPECT_LT(zones.at("second_algorithm").get<double>(), 1e-7);
  }
}

// A case that needs little is done when it has that, not when the others have theirs.
TEST(Batch, ACaseIsDoneWhileOthersGoOn) {
  if (n_cores() < 2) GTEST_SKIP() << "one thread takes one case after the other";
  const ScratchFolder folder;
  const auto quick = folder.write("quick.prm", elastic_case());
  const auto slow = folder.write("slow.prm", replace(elastic_case(), "Tolerance = 0.05", "Tolerance = 1e-4"));
  auto cases = read_case_file(quick);
  cases.push_back(read_case_file(slow).at(0));
  constexpr double farthest_of_quick = 12;
  std::promise<void> quick_is_done;
  const auto done = quick_is_done.get_future().share();
  BatchOptions options;
  BodyStore bodies{{"watched mesh", [&](const BodyDescription& specification) {
                      if (specification.far_radius > farthest_of_quick) {
                        EXPECT_EQ(done.wait_for(std::chrono::minutes(1)), std::future_status::ready)
                            << "quick waits for slow";
                      }
                      return mesh_of(specification);
                    }}};
  options.progress = [&](const BatchLine& line) {
    if (line.name == "quick") quick_is_done.set_value();
  };
  const auto lines = run_batch(prepare(cases), options, bodies);
  for (const auto& line : lines) EXPECT_EQ(line.outcome, Outcome::agree) << line.answer;
}

// What an earlier run left is no result of a case whose numerics fail now.
TEST(Batch, AFailedCaseLeavesNoOldResult) {
  const ScratchFolder folder;
  const auto out = folder.path() / "out";
  fs::create_directories(out / "case");
  std::ofstream(out / "case" / "result.json") << "{}";
  BatchOptions options;
  options.output = out;
  BodyStore bodies{
      {"broken mesh", [](const BodyDescription&) -> meshes::Mesh { throw fem::SolverError("the pump is broken"); }}};
  const auto lines = run_batch(prepare(read_case_file(folder.write("case.prm", elastic_case()))), options, bodies);
  EXPECT_EQ(lines.at(0).failure, "the pump is broken");
  EXPECT_TRUE(fs::is_empty(out / "case"));
}

TEST(Batch, WhatIsBesideTheCasesIsWorkedOutOnceEach) {
  const ScratchFolder folder;
  std::vector<std::string> taken(20);
  std::atomic<int> n_computed{0};
  const auto compute = [&](std::size_t number) {
    ++n_computed;
    return std::to_string(number * number);
  };
  BatchOptions options;
  options.proof = Proof::none;
  options.beside = {taken.size(), compute, [&](std::size_t number, std::string text) { taken[number] += text; }};
  BodyStore bodies;
  const auto lines = run_batch(prepare(read_case_file(folder.write("case.prm", elastic_case()))), options, bodies);
  EXPECT_TRUE(lines.at(0).failure.empty());
  EXPECT_EQ(n_computed, 20);
  for (std::size_t number = 0; number < taken.size(); ++number)
    EXPECT_EQ(taken[number], std::to_string(number * number));
}

// A zone that only one of the two finds counts with all of its radius; one that neither finds, under a bar that leaves
// that open, is no difference.
TEST(Batch, NamesTheLargestUseOfATolerance) {
  auto result = nlohmann::ordered_json::parse(R"({"name": "a", "scene": {"contact_radius_unworn": 2}, "fe": {},
    "mdr": {"stick_radius_shakedown": null}, "comparison": {
      "contact_radius_max": {"difference": -5e-4, "tolerance": 1e-3},
      "normal_force_max": {"difference": 2e-4, "tolerance": 1e-3}}})");
  EXPECT_EQ(largest_use(result).share, 0.5);
  EXPECT_NE(largest_use(result).text.find("largest contact radius in a, off by 5.0e-04 of 1.0e-03"), std::string::npos)
      << largest_use(result).text;
  auto& radius = result["comparison"]["stick_radius_shakedown"] = {{"difference", nullptr}, {"tolerance", 1e-3}};
  EXPECT_EQ(largest_use(result).share, 0.5);
  result["fe"]["stick_radius_shakedown"] = 0.6;
  EXPECT_EQ(largest_use(result).text,
            "stick radius, shakedown in a, off by 3.0e-01 of 1.0e-03, only one of the two sticks");
  radius["asked"] = false;
  EXPECT_EQ(largest_use(result).share, 0.5) << "nobody asked for it";
  result["comparison"].clear();
  EXPECT_LT(largest_use(result).share, 0);
}

TEST(Batch, HasItsLinesInTheOrderOfItsCasesAndCountsThemAsTheyAreDone) {
  std::vector<Case> cases;
  for (const char* name : {"a", "b", "c", "d", "e"}) {
    cases.push_back(read_case(elastic_case()));
    cases.back().name = name;
  }
  BatchOptions options;
  BodyStore bodies{{"no mesh", [](const BodyDescription&) -> meshes::Mesh { throw fem::SolverError("no mesh"); }}};
  std::set<std::string> told;
  options.progress = [&](const BatchLine& line) { EXPECT_TRUE(told.insert(line.name).second) << line.name; };
  const auto lines = run_batch(prepare(cases), options, bodies);
  ASSERT_EQ(lines.size(), 5U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].name, cases[i].name);
    EXPECT_TRUE(lines[i].failed());
  }
  EXPECT_EQ(told.size(), 5U);
}

}  // namespace
}  // namespace fretval
