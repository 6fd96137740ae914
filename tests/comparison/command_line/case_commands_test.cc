#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "comparison/command_line/verbs.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/stored_result.h"

namespace fretval::case_commands_test {
namespace {

namespace fs = std::filesystem;

TEST(CaseCommands, ANewCaseIsConfirmed) {
  const ScratchFolder folder;
  const auto file = quoted(folder.path() / "mine.prm");
  const auto made = fretval_run("new " + file + " --shape table --rheology table", folder);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_parts(made.out, {"mine.prm\n", "mine-profile.csv\n", "mine-moduli.csv\n"});
  const auto run = fretval_run("run " + file + " -o " + quoted(folder.path() / "out"), folder);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  expect_parts(run.out, {"mine: the inner ", "\nfinite elements confirm the method"});
}

TEST(CaseCommands, ANewCaseOverwritesNothing) {
  const ScratchFolder folder;
  const auto table = folder.write("mine-profile.csv", "old");
  const auto run = fretval_run("new " + quoted(folder.path() / "mine.prm") + " --shape table", folder);
  EXPECT_EQ(run.exit_code, 2);
  expect_parts(run.err, {"mine-profile.csv: is there already"});
  EXPECT_EQ(text_of(table), "old");
  EXPECT_FALSE(fs::exists(folder.path() / "mine.prm"));
  EXPECT_EQ(fretval_run("new mine.txt", folder).exit_code, 2);
}

TEST(CaseCommands, ASweepIsExplainedByItsFirstCase) {
  const ScratchFolder folder;
  const auto file = folder.write(
      "s.prm", valid_case + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 30, 60, 90\nend\n");
  const auto run = fretval_run("explain " + quoted(file), folder);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  expect_parts(run.out, {"s/phase-30\n", "phase 30 deg", "3 cases over Motion / Phase"});
}

// All that `run` warns of, before anything is computed.
TEST(CaseCommands, ExplainWarnsOfWhatIsImplausible) {
  const ScratchFolder folder;
  const auto deep = folder.write("deep.prm", replace(valid_case, "Indentation = 1e-4", "Indentation = 5 mm"));
  expect_parts(fretval_run("explain " + quoted(deep), folder).err, {"are all lengths in m?"});
}

TEST(CaseCommands, TheListOfEntriesIsThePageOfTheDocs) {
  const ScratchFolder folder;
  const auto page = text_of(fs::path(FRETVAL_SOURCE_DIR) / "docs/case_file.md");
  EXPECT_EQ(fretval_run("explain --entries", folder).out, page)
      << "build/release/fretval explain --entries > docs/case_file.md";
}

TEST(CaseCommands, ChangedResultsExitWithOne) {
  const ScratchFolder folder;
  const auto write = [&](const std::string& name, const nlohmann::ordered_json& json) {
    fs::create_directories(folder.path() / name);
    folder.write(name + "/result.json", json.dump());
    return quoted(folder.path() / name);
  };
  auto json = stored_result("phase");
  const auto before = write("before", json);
  EXPECT_EQ(fretval_run("compare " + before + " " + before, folder).exit_code, 0);
  json["fe"]["contact_radius_max"] = 1.01 * json["fe"]["contact_radius_max"].get<double>();
  const auto run = fretval_run("compare " + before + " " + write("after", json), folder);
  EXPECT_EQ(run.exit_code, 1) << run.out;
  expect_parts(run.out, {"largest contact radius", "by 1.0e-02"});
  EXPECT_EQ(fretval_run("compare " + before + " nowhere", folder).exit_code, 2);
}

// Each kind that a run would warn of: what an entry says, what is beyond what is usual, and what lifts off.
TEST(CaseCommands, ExplainWarnsOfAllThatARunWarnsOf) {
  const ScratchFolder folder;
  const auto warnings = [&](const std::string& text) {
    return fretval_run("explain " + quoted(folder.write("case.prm", text)), folder).err;
  };
  folder.write("dma.csv", "f,G',G''\nHz,MPa,MPa\n0.4,1.06,0.24\n1,1.28,0.45\n4,1.86,0.34\n10,1.98,0.16\n40,2,0.04\n");
  const auto measured =
      replace(replace(valid_case, "standard solid", "table\n  set Table = dma.csv\n  set Table modulus = shear"),
              "  set Relaxed shear modulus = 1e6\n  set Branch moduli = 1e6\n  set Branch times = 0.1\n", "");
  expect_parts(warnings(measured), {"G'(0) is extrapolated"});
  expect_parts(warnings(replace(valid_case, "Normal amplitude = 2e-5", "Normal amplitude = 1.01e-4")),
               {"lifts off in every cycle"});
  expect_parts(warnings(replace(valid_case, "parabola\n  set Radius = 1e-2", "cone\n  set Slope angle = 89.9")),
               {"Slope angle = 89.9 deg"});
}

TEST(TradeCommand, RefusesBadInputAndWritesNothing) {
  const ScratchFolder folder;
  const auto sweep = folder.write(
      "sweep.prm", valid_case + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:90:180\nend\n");
  const auto bad = folder.write("bad.prm", replace(valid_case, "modulus = 1e6", "modulus = -1"));
  const auto forces = folder.write(
      "forces.prm", replace(valid_case, "Tangential amplitude = 1.5e-5", "Tangential force amplitude = 0.1"));
  const auto out = folder.path() / "out";
  for (const auto& file : {sweep, bad, forces, folder.path() / "nowhere.prm"})
    EXPECT_EQ(fretval_run("trade " + file.string() + " -o " + out.string(), folder).exit_code, 2) << file;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(ScoreCommand, ExitsWithWhatTheNumbersComeTo) {
  const ScratchFolder folder;
  const auto file = folder.write("mine.csv", "contact_radius_max,normal_force_max\nmm,mN\n1.095,703\n");
  const auto score = [&](const std::string& options) {
    return fretval_run("score " + quoted(file) + " " + options, folder);
  };
  const auto good = score("--benchmark 01-hertz");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  expect_parts(good.out,
               {"01-hertz: 2 of 2 quantities agree within 0.01 with finite elements", "largest contact radius"});
  const auto strict = score("--benchmark 01-hertz --tolerance '0.1 %' --json");
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_EQ(nlohmann::json::parse(strict.out).at("quantities").at("normal_force_max").at("agrees"), false);
  EXPECT_EQ(score("--benchmark hertz").exit_code, 2);
  const auto wrong = score("--benchmark 01-hertz --tolerance much");
  EXPECT_EQ(wrong.exit_code, 2);
  expect_parts(wrong.err, {"--tolerance much"});
  EXPECT_EQ(fretval_run("score nothing.csv --benchmark 01-hertz", folder).exit_code, 2);
}

}  // namespace
}  // namespace fretval::case_commands_test
