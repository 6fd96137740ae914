#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "comparison/command_line/verbs.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

// The reference goes further than the finite elements: what they cannot do is refused before anything is written.
TEST(RunCommand, RefusesWhatOnlyTheReferenceAnswers) {
  const ScratchFolder folder;
  const auto file =
      folder.write("case.prm", replace(valid_case, "Tangential frequency = 1", "Tangential frequency = 1500"));
  EXPECT_EQ(fretval_run("mdr " + file.string(), folder).exit_code, 0);
  const auto run = fretval_run("run " + file.string() + " -o " + (folder.path() / "out").string(), folder);
  EXPECT_EQ(run.exit_code, 2);
  for (const char* part : {"case.prm", "frequencies of 1 and 1500 Hz", "fretval mdr"})
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

// Gross slip is an answer, and both have to find it.
TEST(RunCommand, SaysThatAllOfTheContactSlides) {
  const ScratchFolder folder;
  const auto file =
      folder.write("case.prm", replace(valid_case, "Tangential amplitude = 1.5e-5", "Tangential force amplitude = 9"));
  const auto run = fretval_run("run " + file.string() + " -o " + (folder.path() / "out").string(), folder);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  expect_parts(run.out, {"case: the whole contact slides", "the method of dimensionality reduction (MDR) finds it at"});
  const auto json = nlohmann::json::parse(text_of(folder.path() / "out/case/result.json"));
  EXPECT_TRUE(json.at("pass"));
  EXPECT_LT(json.at("fe").at("gross_slip").at("amplitude"), 0.1);
  EXPECT_LT(json.at("mdr").at("gross_slip"), 0.1);
  EXPECT_TRUE(json.at("fe").at("normal_force_max").is_null());
}

TEST(RunCommand, WritesEveryResultAndTheReport) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto run = fretval_run("run " + file.string() + " -o " + (folder.path() / "out").string(), folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const fs::path out = folder.path() / "out";
  for (const char* name : {"result.json", "run.json", "history.csv", "contact.csv", "profile.csv", "fields.pvd",
                           "surface.pvd", "fields/section-01.vtu", "fields/surface-01.vtu"})
    EXPECT_GT(fs::file_size(out / "case" / name), 100U) << name;
  const auto json = nlohmann::json::parse(text_of(out / "case" / "result.json"));
  for (const char* key : {"name", "pass", "mdr", "fe", "comparison", "cost"}) EXPECT_TRUE(json.contains(key)) << key;
  for (const char* key : {"contact_radius_max", "stick_radius_first_slip", "stick_radius_shakedown", "worn_radius",
                          "normal_force_max", "error_estimate"})
    EXPECT_TRUE(json.at("fe").contains(key)) << key;
  for (const char* key : {"seconds", "dofs", "contact_nodes", "time_steps", "cycles", "peak_memory_bytes"})
    EXPECT_TRUE(json.at("cost").contains(key)) << key;
  EXPECT_EQ(json.at("pass"), true);
  EXPECT_NE(shown(text_of(out / "index.html")).find("Which stick radius do finite elements follow?"),
            std::string::npos);
  for (const auto& entry : fs::recursive_directory_iterator(out)) EXPECT_NE(entry.path().extension(), ".partial");
}

const std::string coarse = "  set Rings per radius = 16\n  set Steps per cycle = 16\nend\n";

// Rings and steps that are far too coarse for what is asked, and nothing that refines them: without bars nothing is
// proved, with them nothing is resolved.
TEST(RunCommand, HasAnExitCodeForEachOutcome) {
  const ScratchFolder folder;
  const auto text = replace(elastic_case(), "Tolerance = 0.05\nend\n", "Tolerance = 1e-5\n" + coarse);
  const auto out = folder.path() / "out";
  const auto run =
      fretval_run("run " + quoted(folder.write("case.prm", text)) + " --proof none -o " + quoted(out), folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  expect_parts(run.out, {"case: the inner ", "\nnot proved: "});
  EXPECT_EQ(run.out.find("confirm"), std::string::npos) << run.out;
  EXPECT_EQ(nlohmann::json::parse(text_of(out / "case" / "result.json")).at("verdict"), "not proved");
  const auto junit = folder.path() / "junit.xml";
  const auto open = fretval_run(
      "run " + quoted(folder.path() / "case.prm") + " --proof bars --junit " + quoted(junit) + " -o " + quoted(out),
      folder);
  EXPECT_EQ(open.exit_code, 5) << open.out << open.err;
  expect_parts(open.out, {"\nnot resolved: "});
  expect_parts(text_of(junit), {"failures=\"1\" errors=\"0\"", "<failure message=\"not resolved: "});
  EXPECT_NE(shown(text_of(out / "index.html")).find("not resolved"), std::string::npos);
}

// Once more it is the same; a value of the baseline that is off by ten bars is not.
TEST(RunCommand, ExitsWith1WhereAResultHasMovedFromTheBaseline) {
  const ScratchFolder folder;
  const auto file = quoted(folder.write("case.prm", elastic_case()));
  const auto old = folder.path() / "old", out = folder.path() / "out";
  ASSERT_EQ(fretval_run("run " + file + " --proof bars -o " + quoted(old), folder).exit_code, 0);
  const auto against = "run " + file + " --proof bars -o " + quoted(out) + " --baseline " + quoted(old);
  const auto same = fretval_run(against, folder);
  EXPECT_EQ(same.exit_code, 0) << same.err;
  auto json = nlohmann::json::parse(text_of(old / "case/result.json"));
  const double bar = json["fe"]["error_estimate"]["normal_force_max"]["total"];
  json["fe"]["normal_force_max"] = json["fe"]["normal_force_max"].get<double>() * (1 + 10 * bar);
  folder.write("old/case/result.json", json.dump());
  const auto junit = folder.path() / "made/for/it/junit.xml";
  const auto moved = fretval_run(against + " --quiet --junit " + quoted(junit), folder);
  EXPECT_EQ(moved.exit_code, 1) << moved.err;
  expect_parts(moved.err, {"baseline: ", "largest normal force"});
  expect_parts(text_of(junit),
               {"failures=\"1\"", "other than the baseline, beyond the bars of both", "largest normal force"});
  const auto renamed = quoted(folder.write("renamed.prm", elastic_case()));
  const auto without = "run " + renamed + " --proof none -o " + quoted(out) + " --baseline " + quoted(old);
  const auto none = fretval_run(without, folder);
  EXPECT_EQ(none.exit_code, 2) << "a baseline of other cases holds nothing";
  expect_parts(none.err, {"has none of the cases", "renamed"});
  const auto missing =
      fretval_run("run " + file + " -o " + quoted(out) + " --baseline " + quoted(folder.path() / "none"), folder);
  EXPECT_EQ(missing.exit_code, 2);
}

TEST(RunCommand, PrintsALineOfJsonForEachCase) {
  const ScratchFolder folder;
  const auto file = folder.write(
      "sweep.prm", elastic_case() + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0, 90\nend\n");
  const auto out = folder.path() / "out";
  const auto run = fretval_run("run " + quoted(file) + " --json --proof none -o " + quoted(out), folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::istringstream lines(run.out);
  std::set<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    const auto json = nlohmann::json::parse(line);
    const auto name = json.at("name").get<std::string>();
    names.insert(name);
    EXPECT_EQ(json.at("fe"), nlohmann::json::parse(text_of(out / name / "result.json")).at("fe"));
  }
  EXPECT_EQ(names, (std::set<std::string>{"sweep/phase-0", "sweep/phase-90"}));
  EXPECT_EQ(run.err.find("earlier runs"), std::string::npos) << run.err;
}

// The report takes whatever lies in its folder.
TEST(RunCommand, SaysWhatElseTheReportShows) {
  const ScratchFolder folder;
  const auto out = folder.path() / "out/";
  const auto run = [&](const char* values) {
    const auto file = folder.write("sweep.prm", elastic_case() + "subsection Sweep\n  set Entry = Motion / Phase\n" +
                                                    "  set Values = " + values + "\nend\n");
    return fretval_run("run " + quoted(file) + " --proof none -o " + quoted(out), folder).err;
  };
  run("0, 90");
  EXPECT_EQ(run("0, 90, 180").find("earlier runs"), std::string::npos);
  expect_parts(run("0, 45"), {"has 2 results of earlier runs as well", ": sweep/phase-180, …"});
  expect_parts(shown(text_of(fs::path(out) / "index.html")), {"2 results of earlier runs in this folder"});
}

TEST(RunCommand, WritesTheTimeOfEachCaseAsJUnit) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", elastic_case()), junit = folder.path() / "junit.xml";
  const auto start = std::chrono::steady_clock::now();
  const auto run = fretval_run(
      "run " + quoted(file) + " --proof none --junit " + quoted(junit) + " -o " + quoted(folder.path() / "out"),
      folder);
  const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto text = text_of(junit);
  const std::string before = "name=\"case\" time=\"";
  const auto at = text.find(before);
  ASSERT_NE(at, std::string::npos) << text;
  const double seconds = std::stod(text.substr(at + before.size()));
  EXPECT_GT(seconds, 0);
  EXPECT_LT(seconds, all);
  expect_parts(text, {"failures=\"0\"", "stick radius, shakedown"});
}

// A branch of 1e12 cycles creeps on for ever. The case beside it has its result and the report all the same.
TEST(RunCommand, ExitsWith3WhereTheNumericsOfOneCaseFail) {
  const ScratchFolder folder;
  const auto good = folder.write("good.prm", replace(elastic_case(), "0.05\nend\n", "0.05\n" + coarse));
  const auto creeping = folder.write(
      "creeping.prm", replace(replace(valid_case, "times = 0.1", "times = 1e12"), "0.01\nend\n", "0.05\n" + coarse));
  const auto out = folder.path() / "out", junit = folder.path() / "junit.xml";
  const auto run = fretval_run(
      "run " + quoted(good) + " " + quoted(creeping) + " --proof none --junit " + quoted(junit) + " -o " + quoted(out),
      folder);
  EXPECT_EQ(run.exit_code, 3) << run.out << run.err;
  expect_parts(run.out, {"FAILED       creeping: "});
  expect_parts(text_of(junit), {"failures=\"0\" errors=\"1\"", "<error message=\""});
  EXPECT_EQ(run.out.find("DISAGREE"), std::string::npos) << run.out;
  EXPECT_TRUE(fs::exists(out / "good" / "result.json"));
  EXPECT_FALSE(fs::exists(out / "creeping" / "result.json"));
  EXPECT_TRUE(fs::exists(out / "index.html"));
}

// The indenter that wear ends at: nothing slips inside c, and nothing is carried outside.
TEST(RunCommand, HoldsALimitingProfileToNoWear) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", replace(valid_case, "1.5e-5", "shakedown") +
                                                 "subsection Wear\n  set State = limiting\nend\n"
                                                 "subsection Sweep\n  set Entry = Wear / Stick radius ratio\n"
                                                 "  set Values = 0.5\nend\n");
  const auto out = folder.path() / "out";
  const auto run = fretval_run("run " + file.string() + " --proof none -o " + out.string(), folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  int n_results = 0;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    if (entry.path().filename() != "result.json") continue;
    ++n_results;
    const auto json = nlohmann::json::parse(text_of(entry.path()));
    EXPECT_EQ(json.at("scene").at("wear"), "limiting");
    for (const char* key :
         {"slip_inside_stick_zone", "force_outside_stick_zone", "maximum_indentation", "limiting_amplitude"}) {
      EXPECT_EQ(json.at("comparison").at(key).at("pass"), true) << key;
      EXPECT_LT(std::abs(json.at("comparison").at(key).at("difference").get<double>()), 0.01) << key;
    }
  }
  EXPECT_EQ(n_results, 1);
  EXPECT_NE(shown(text_of(out / "index.html")).find("The state in which nothing wears any more"), std::string::npos);
}

// Every shape in the same scene, with finite elements as coarse as they get.
TEST(RunCommand, ComparesEveryShape) {
  const std::map<std::string, std::string> shapes{{"sphere", "Radius = 3e-3"},
                                                  {"cone", "Slope angle = 4"},
                                                  {"power", "Coefficient = 1e5\n  set Exponent = 3"},
                                                  {"rounded flat", "Flat radius = 3e-4\n  set Edge radius = 5e-3"},
                                                  {"truncated sphere", "Flat radius = 3e-4\n  set Radius = 1e-2"},
                                                  {"table", "Table = parabola.csv"}};
  const ScratchFolder folder;
  folder.write("parabola.csv", "r,f\nmm,nm\n0,0\n0.5,12500\n1,50000\n1.5,112500\n2,200000\n");
  std::string files;
  for (const auto& [shape, entries] : shapes) {
    auto text = replace(valid_case, "parabola\n  set Radius = 1e-2", fmt::format("{}\n  set {}", shape, entries));
    text = replace(text, "Tolerance = 0.01", "Tolerance = 0.1") + "subsection Output\n  set Fields = none\nend\n";
    files += " " + quoted(folder.write(shape + ".prm", text));
  }
  const auto run = fretval_run("run" + files + " -o " + (folder.path() / "out").string(), folder);
  ASSERT_EQ(run.exit_code, 0) << run.out << run.err;
  for (const auto& [shape, entries] : shapes) {
    const auto json = nlohmann::json::parse(text_of(folder.path() / "out" / shape / "result.json"));
    EXPECT_EQ(json.at("scene").at("shape"), shape);
    EXPECT_EQ(json.at("pass"), true) << shape;
  }
}

TEST(RunCommand, RefusesBadCasesAndWritesNothing) {
  const ScratchFolder folder;
  const auto good = folder.write("good.prm", valid_case);
  const auto bad = folder.write("bad.prm", replace(valid_case, "modulus = 1e6", "modulus = -1"));
  const auto run =
      fretval_run("run " + good.string() + " " + bad.string() + " -o " + (folder.path() / "out").string(), folder);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("bad.prm: Elastomer / Relaxed shear modulus = -1"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

TEST(RunCommand, TakesTheCaseFilesOfAFolderInEitherFormat) {
  const ScratchFolder folder;
  const auto err_of = [&] { return fretval_run("run " + folder.path().string(), folder).err; };
  folder.write("notes.txt", "");
  EXPECT_NE(err_of().find("the folder has no case files (.prm or .json)"), std::string::npos);
  folder.write("case.json", R"({"Indenter": {"Shape": "star"}})");
  EXPECT_NE(err_of().find("case.json: Indenter / Shape = star"), std::string::npos) << err_of();
}

TEST(RunCommand, AsksForAFileOfJUnitBeforeItComputes) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto run = fretval_run(
      "run " + quoted(file) + " --junit " + quoted(folder.path()) + " -o " + quoted(folder.path() / "out"), folder);
  EXPECT_EQ(run.exit_code, 2);
  expect_parts(run.err, {"is a folder", "--junit"});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

// A modulus in MPa that is read in Pa: the failure names the entry, not only what came of it.
TEST(RunCommand, NamesTheModulusThatAFailureMayComeFrom) {
  const ScratchFolder folder;
  const auto file = folder.write(
      "case.prm", replace(replace(valid_case, "modulus = 1e6", "modulus = 1"), "0.01\nend\n", "0.05\n" + coarse));
  const auto run = fretval_run("run " + quoted(file) + " --proof none -o " + quoted(folder.path() / "out"), folder);
  EXPECT_EQ(run.exit_code, 3) << run.out << run.err;
  expect_parts(run.out, {"Elastomer / Relaxed shear modulus = 1 Pa", "is it in Pa?"});
}

// What few ask for.
TEST(RunCommand, TellsDetailsWhereTheyAreAskedFor) {
  const ScratchFolder folder;
  const auto command = "run " + quoted(folder.write("case.prm", elastic_case())) + " --proof none -o " +
                       quoted(folder.path() / "out") + " --store " + quoted(folder.path() / "store");
  const auto brief = fretval_run(command, folder), verbose = fretval_run(command + " --verbose", folder);
  expect_parts(verbose.err, {"bodies made, "});
  expect_parts(verbose.out, {"1 % more friction (μ) changes"});
  EXPECT_EQ(brief.err.find("bodies made"), std::string::npos) << brief.err;
  EXPECT_EQ(brief.out.find("1 % more"), std::string::npos) << brief.out;
}

TEST(OutputFile, HasAFolderToLieInAndIsNone) {
  const ScratchFolder folder;
  const auto file = folder.path() / "new" / "map.csv";
  prepare_output_file("--map", file.string());
  EXPECT_TRUE(std::filesystem::is_directory(file.parent_path()));
  EXPECT_FALSE(std::filesystem::exists(file));
  prepare_output_file("--map", "");
  prepare_output_file("--map", "map.csv");
  expect_parts(refusal([&] { prepare_output_file("--map", folder.path().string()); }),
               {"is a folder", "--map expects"});
}

// Nothing is held to a baseline that does not have it, and that is said.
TEST(RunCommand, WarnsOfCasesThatABaselineDoesNotHave) {
  const ScratchFolder folder;
  auto kept = stored_result("single");
  kept["name"] = "case";
  fs::create_directories(folder.path() / "old/case");
  folder.write("old/case/result.json", kept.dump());
  const auto both =
      quoted(folder.write("case.prm", elastic_case())) + " " + quoted(folder.write("another.prm", elastic_case()));
  const auto old = folder.path() / "old";
  const auto run = fretval_run(
      "run " + both + " --proof none -o " + quoted(folder.path() / "out") + " --baseline " + quoted(old), folder);
  expect_parts(run.err, {"--baseline " + old.string() + ": has no another"});
  EXPECT_EQ(run.err.find("has no case"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace fretval
