#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/wearing_case.h"

namespace fretval::killed_runs_test {
namespace {

namespace fs = std::filesystem;

/// Runs the program and kills it (SIGKILL) as soon as there is a file that fits a pattern of the shell.
Run killed_run(const std::string& arguments, const std::string& pattern, const ScratchFolder& folder) {
  return shell_run(std::string(FRETVAL_PROGRAM) + " " + arguments + " & while kill -0 $! && ! ls " + pattern +
                       "; do sleep 0.02; done 2>/dev/null >&2; kill -KILL $!; wait $!",
                   folder);
}

constexpr int of_sigkill = 128 + 9;

/// Everything of the results but what the computation cost.
std::map<std::string, nlohmann::json> results_below(const fs::path& folder) {
  std::map<std::string, nlohmann::json> results;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    EXPECT_NE(entry.path().extension(), ".partial") << entry.path();
    if (entry.path().filename() != "result.json") continue;
    auto& result = results[fs::relative(entry.path(), folder).string()];
    result = nlohmann::json::parse(text_of(entry.path()));
    result.erase("cost");
    if (result["fe"].contains("wear")) result["fe"]["wear"].erase("cost");
  }
  return results;
}

// Nineteen cases of one body: they are computed together, each is written when it is done.
TEST(KilledRun, KeepsItsResultsAndCanBeRepeated) {
  const ScratchFolder folder;
  const auto file = folder.write("family.prm", elastic_case() +
                                                   "subsection Sweep\n  set Entry = Motion / Phase\n"
                                                   "  set Values = 0:5:90\nend\n");
  const auto killed = folder.path() / "killed", whole = folder.path() / "whole";
  const auto run =
      killed_run("run " + quoted(file) + " -o " + quoted(killed), quoted(killed) + "/*/*/result.json", folder);
  ASSERT_EQ(run.exit_code, of_sigkill) << run.err;
  std::map<std::string, nlohmann::json> kept;
  for (const auto& entry : fs::recursive_directory_iterator(killed))
    if (entry.path().filename() == "result.json")
      kept[fs::relative(entry.path(), killed).string()] = nlohmann::json::parse(text_of(entry.path())).at("fe");
  EXPECT_GE(kept.size(), 1U);
  EXPECT_LT(kept.size(), 19U) << "the run was over before it was killed";
  ASSERT_EQ(fretval_run("run " + quoted(file) + " -o " + quoted(killed), folder).exit_code, 0);
  ASSERT_EQ(fretval_run("run " + quoted(file) + " -o " + quoted(whole), folder).exit_code, 0);
  const auto uninterrupted = results_below(whole);
  EXPECT_EQ(uninterrupted.size(), 19U);
  EXPECT_EQ(results_below(killed), uninterrupted);
  for (const auto& [name, fe] : kept) EXPECT_EQ(fe, uninterrupted.at(name).at("fe")) << name;
}

// In the middle of its wear, after the first jump that is kept: the same profile bit for bit.
TEST(KilledRunSlow, GoesOnWearingToTheSameProfile) {
  const ScratchFolder folder;
  const auto file = folder.write("wear.prm", wearing_text("  set Coefficient = 1e-12\n  set Cycles = 1e7\n"));
  const auto killed = folder.path() / "killed", whole = folder.path() / "whole";
  const auto arguments = [&](const fs::path& out) {
    return "run " + quoted(file) + " --proof none --no-store -o " + quoted(out);
  };
  ASSERT_EQ(killed_run(arguments(killed), quoted(killed) + "/*/checkpoints/*", folder).exit_code, of_sigkill);
  EXPECT_FALSE(fs::exists(killed / "wear" / "result.json"));
  EXPECT_TRUE(fs::exists(killed / "wear" / "checkpoints"));
  const int resumed = fretval_run(arguments(killed), folder).exit_code,
            uninterrupted = fretval_run(arguments(whole), folder).exit_code;
  EXPECT_LE(uninterrupted, 1) << "0 or 1: on its way, the volume may be further from that of the springs";
  EXPECT_EQ(resumed, uninterrupted);
  for (const char* name : {"worn_rings.csv", "worn_profile.csv", "wear.csv"})
    EXPECT_EQ(text_of(killed / "wear" / name), text_of(whole / "wear" / name)) << name;
  EXPECT_EQ(results_below(killed), results_below(whole));
}

}  // namespace
}  // namespace fretval::killed_runs_test
