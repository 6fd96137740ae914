#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "comparison/command_line/verbs.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/suite_rows.h"
#include "tests/comparison/variable.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

TEST(CheckCommand, TellsDisagreementFromAnAnswerThatIsMissing) {
  EXPECT_EQ(exit_code_of(run_of({row_of(1e-3, 2e-3), row_of(1e-3, 2e-2), refused_row("a", "a b")})), 0);
  EXPECT_EQ(exit_code_of(run_of({row_of(3e-3, 2e-3)})), 1);
  EXPECT_EQ(exit_code_of(run_of({refused_row("a", "")})), 1);
  EXPECT_EQ(exit_code_of(run_of({refused_row("a", "b")})), 1);
  EXPECT_EQ(exit_code_of(run_of({row_of(1e-3, 2e-3), refused_row("", "singular")})), 3);
  auto broken = row_of(1e-3, 2e-3);
  broken.failure = "out of memory";
  EXPECT_EQ(exit_code_of(run_of({broken})), 3);
}

std::size_t n_files(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// Without a store of operators: what proves the finite elements makes them.
TEST(CheckCommand, ChecksTheSmallSuite) {
  const ScratchFolder folder;
  const auto operators = folder.path() / "operators";
  const Variable store("FRETVAL_STORE", operators.string());
  const auto junit = folder.path() / "junit.xml", json = folder.path() / "small.json";
  const auto run = fretval_run("check --junit " + junit.string() + " --json " + json.string(), folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("pass: 6 cases: 6 agree"), std::string::npos) << run.out;
  EXPECT_EQ(nlohmann::json::parse(text_of(json)).at("rows").size(), 6U);
  EXPECT_NE(text_of(junit).find("tests=\"6\" failures=\"0\""), std::string::npos) << text_of(junit);
  EXPECT_FALSE(fs::exists(operators));
}

// On a terminal, by its first line; the suite is not waited for. Random cases are drawn before, under a line of their
// own, which may come to foresee its end.
TEST(CheckCommandSlow, BeginsWithAnEstimateOfTheTimeLeft) {
  const ScratchFolder folder;
  for (const char* suite : {"exact", "tolerance", "extremes", "random --count 200"}) {
    const auto command = std::string("timeout 10 ") + FRETVAL_PROGRAM + " check --suite " + suite;
    const auto run = shell_run("script -qec 'stty cols 60; " + command + "' /dev/null", folder);
    const auto drawn = run.out.rfind(" drawn");
    const auto lines = run.out.substr(drawn == std::string::npos ? 0 : drawn);
    EXPECT_NE(lines.substr(0, lines.find(" left")).find(", about "), std::string::npos) << run.out;
  }
}

// Every case once.
TEST(CheckCommandSlow, ChecksATolerance) {
  const ScratchFolder folder;
  const auto junit = folder.path() / "junit.xml", cases = folder.path() / "cases";
  const auto run = fretval_run(
      "check --suite tolerance --tolerances 0.01 --junit " + junit.string() + " --write-cases " + cases.string(),
      folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_EQ(n_files(cases / "0.01"), 50U);
  EXPECT_NE(run.out.find("pass: 50 cases: 50 agree, 0 are refused"), std::string::npos) << run.out;
  EXPECT_NE(text_of(junit).find("tests=\"50\" failures=\"0\""), std::string::npos);
}

TEST(CheckCommand, ChecksOneFamilyOfTheExtremes) {
  const ScratchFolder folder;
  const auto junit = folder.path() / "junit.xml", json = folder.path() / "extremes.json";
  const auto run = fretval_run(
      "check --suite extremes --short --family 'refused input' --junit " + junit.string() + " --json " + json.string(),
      folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("Elastomer / Relaxed shear modulus = 0"), std::string::npos) << run.out;
  EXPECT_NE(text_of(junit).find("tests=\"1\" failures=\"0\""), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text_of(json)).at("summary").at("refused"), 1);
}

// The worst cases are written as case files that the tool takes.
TEST(CheckCommand, ChecksRandomCasesAndWritesTheWorst) {
  const ScratchFolder folder;
  const auto junit = folder.path() / "junit.xml", json = folder.path() / "new" / "random.json",
             worst = folder.path() / "worst";
  const auto run = fretval_run("check --suite random --count 2 --seed 1 --junit " + junit.string() + " --json " +
                                   json.string() + " --write-worst " + worst.string(),
                               folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("pass: 2 cases: "), std::string::npos) << run.out;
  EXPECT_NE(text_of(junit).find("failures=\"0\""), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text_of(json)).at("rows").size(), 2U);
  EXPECT_EQ(n_files(worst), 2U);
  for (const auto& file : fs::directory_iterator(worst))
    EXPECT_EQ(fretval_run("mdr " + file.path().string(), folder).exit_code, 0) << file.path();
}

// Whether their errors are within the bars is not for a test to say: nobody has seen these cases.
TEST(CheckCommand, DrawsNewRandomCasesAndSaysHowToRepeatThem) {
  const ScratchFolder folder;
  const auto seed_of = [&] {
    const auto run = fretval_run("check --suite random --count 1", folder);
    const auto at = run.err.find("--seed ");
    EXPECT_NE(at, std::string::npos) << run.err;
    return run.err.substr(at + 7, run.err.find(' ', at + 7) - at - 7);
  };
  EXPECT_NE(seed_of(), seed_of());
  const auto run = fretval_run("check --suite random --only 3", folder);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--only: of which cases? Expected their --seed"), std::string::npos) << run.err;
}

// As `run` would, without its results.
TEST(CheckCommand, ChecksAFolderOfCasesAndKeepsNothing) {
  const ScratchFolder folder;
  fs::create_directory(folder.path() / "own");
  folder.write("own/one.prm", elastic_case());
  folder.write("own/two.prm", replace(elastic_case(), "set Coefficient = 0.5", "set Coefficient = 0.6"));
  const auto junit = folder.path() / "junit.xml";
  const auto own = (folder.path() / "own").string();
  const auto run = fretval_run("check --cases " + own + " --junit " + junit.string(), folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  for (const char* name : {"agree        one", "agree        two"})
    EXPECT_NE(run.out.find(name), std::string::npos) << run.out;
  EXPECT_NE(text_of(junit).find("tests=\"2\" failures=\"0\""), std::string::npos) << text_of(junit);
  EXPECT_FALSE(fs::exists(folder.path() / "results"));
  EXPECT_EQ(n_files(folder.path() / "own"), 2U);
  for (const std::string option : {"--suite small", "--count 3", "--json there"})
    EXPECT_EQ(fretval_run("check --cases " + own + " " + option, folder).exit_code, 2) << option;
}

TEST(CheckCommand, RefusesOptionsOfAnotherSuite) {
  const ScratchFolder folder;
  for (const std::string option : {"--write-cases there", "--suite exact --short", "--suite random --meshes there"}) {
    const auto run = fretval_run("check " + option, folder);
    EXPECT_EQ(run.exit_code, 2) << option;
    EXPECT_NE(run.err.find(": it belongs to the suite "), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

TEST(CheckCommand, RefusesAMeshWithoutAGroup) {
  const ScratchFolder folder;
  const fs::path meshes(fs::path(FRETVAL_SOURCE_DIR) / "meshes" / "small");
  folder.write("coarse.msh", replace(text_of(meshes / "coarse.msh"), "\"axis\"", "\"axes\""));
  folder.write("fine.msh", text_of(meshes / "fine.msh"));
  const auto run = fretval_run("check --meshes " + folder.path().string(), folder);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("coarse.msh"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("axes"), std::string::npos) << run.err;
}

TEST(CheckCommand, DisagreesIfARowOfTheExactSuiteFails) {
  const ConvergenceRow good{"Hertz", "force", "", {1e-3, 2, 0, ""}, "rings", {32, 64}, {1e-4, 2.5e-5}};
  auto bad = good;
  bad.errors = {1, 1};
  EXPECT_EQ(exit_code_of(std::vector<ConvergenceRow>{good, good}), 0);
  EXPECT_EQ(exit_code_of(std::vector<ConvergenceRow>{good, bad}), 1);
}

}  // namespace
}  // namespace fretval
