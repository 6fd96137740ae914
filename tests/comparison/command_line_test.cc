#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

TEST(CommandLine, SaysItsVersionAndThoseOfItsLibraries) {
  const ScratchFolder folder;
  const auto run = fretval_run("--version", folder);
  EXPECT_EQ(run.exit_code, 0);
  for (const char* name : {"fretval", "deal.II", "PETSc", "MUMPS", "gmsh", "Eigen"})
    EXPECT_NE(run.out.find(name), std::string::npos) << run.out;
}

TEST(CommandLine, PrintsTheAnalyticAnswerAsJson) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto run = fretval_run("mdr " + file.string() + " --json", folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json.at("name"), "case");
  for (const char* key : {"modulus_ratio", "contact_radius_max", "stick_radius_first_slip", "stick_radius_shakedown",
                          "worn_radius", "normal_force_max"})
    EXPECT_TRUE(json.at("mdr").contains(key)) << key;
  EXPECT_EQ(json.at("limiting_profile").at("criterion"), "shakedown");
  EXPECT_EQ(json.at("limiting_profile").at("r").size(), json.at("limiting_profile").at("f").size());
}

TEST(CommandLine, WritesTheFieldsOnTheSurface) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto fields = folder.path() / "fields.csv";
  ASSERT_EQ(fretval_run("mdr " + file.string() + " --fields " + fields.string(), folder).exit_code, 0);
  EXPECT_EQ(text_of(fields).rfind("r [m],f [m],p deepest [Pa],", 0), 0U);
}

// The reference goes further than the finite elements: what they cannot do is refused before anything is written.
TEST(CommandLine, RunRefusesWhatOnlyTheReferenceAnswers) {
  const ScratchFolder folder;
  const auto file =
      folder.write("case.prm", replace(valid_case, "Tangential frequency = 1", "Tangential frequency = 2"));
  EXPECT_EQ(fretval_run("mdr " + file.string(), folder).exit_code, 0);
  const auto run = fretval_run("run " + file.string() + " -o " + (folder.path() / "out").string(), folder);
  EXPECT_EQ(run.exit_code, 2);
  for (const char* part : {"case.prm", "Tangential frequency = 2 Hz", "free", "fretval mdr"})
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

TEST(CommandLine, RunWritesEveryResultAndTheReport) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto run = fretval_run("run " + file.string() + " -o " + (folder.path() / "out").string(), folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const fs::path out = folder.path() / "out";
  for (const char* name : {"result.json", "run.json", "history.csv", "contact.csv", "profile.csv", "normal_deepest.vtu",
                           "normal_highest.vtu", "tangential_period_end.vtu"})
    EXPECT_GT(fs::file_size(out / "case" / name), 100U) << name;
  const auto json = nlohmann::json::parse(text_of(out / "case" / "result.json"));
  for (const char* key : {"name", "pass", "mdr", "fe", "comparison", "cost"}) EXPECT_TRUE(json.contains(key)) << key;
  for (const char* key : {"contact_radius_max", "stick_radius_first_slip", "stick_radius_shakedown", "worn_radius",
                          "normal_force_max", "error_estimate"})
    EXPECT_TRUE(json.at("fe").contains(key)) << key;
  for (const char* key : {"seconds", "dofs", "contact_nodes", "time_steps", "cycles", "peak_memory_bytes"})
    EXPECT_TRUE(json.at("cost").contains(key)) << key;
  EXPECT_EQ(json.at("pass"), true);
  EXPECT_NE(text_of(out / "index.html").find("Which stick radius do finite elements follow?"), std::string::npos);
  for (const auto& entry : fs::recursive_directory_iterator(out)) EXPECT_NE(entry.path().extension(), ".partial");
}

TEST(CommandLine, RefusesBadCasesAndWritesNothing) {
  const ScratchFolder folder;
  const auto good = folder.write("good.prm", valid_case);
  const auto bad = folder.write("bad.prm", replace(valid_case, "modulus = 1e6", "modulus = -1"));
  const auto run =
      fretval_run("run " + good.string() + " " + bad.string() + " -o " + (folder.path() / "out").string(), folder);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("bad.prm: Elastomer / Relaxed shear modulus = -1"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

TEST(CommandLine, RefusesAMissingFile) {
  const ScratchFolder folder;
  EXPECT_EQ(fretval_run("run nowhere.prm", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("mdr nowhere.prm", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("report nowhere", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("check --meshes nowhere", folder).exit_code, 2);
  const auto run = fretval_run("check --suite nothing", folder);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("expected small, exact, tolerance, extremes or soak"), std::string::npos) << run.err;
  EXPECT_EQ(fretval_run("check --suite exact --short", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("check --suite extremes --family nothing", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("check --suite exact --only 3", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("dance", folder).exit_code, 2);
}

// The whole ladder: a heading, a line a row and the verdict.
TEST(CommandLineSlow, ChecksTheExactSolutions) {
  const ScratchFolder folder;
  const auto junit = folder.path() / "junit.xml";
  const auto run = fretval_run("check --suite exact --junit " + junit.string(), folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1 + 38 + 1) << run.out;
  EXPECT_NE(text_of(junit).find("tests=\"38\" failures=\"0\""), std::string::npos);
}

TEST(CommandLine, RefusesAMeshWithoutAGroup) {
  const ScratchFolder folder;
  const fs::path meshes(fs::path(FRETVAL_SOURCE_DIR) / "meshes" / "small");
  folder.write("coarse.msh", replace(text_of(meshes / "coarse.msh"), "\"axis\"", "\"axes\""));
  folder.write("fine.msh", text_of(meshes / "fine.msh"));
  const auto run = fretval_run("check --meshes " + folder.path().string(), folder);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("coarse.msh"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("axes"), std::string::npos) << run.err;
}

TEST(CommandLine, SaysWhenTheOutputCannotBeWritten) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto blocker = folder.write("blocker", "a file where a folder should be");
  EXPECT_EQ(fretval_run("run " + file.string() + " -o " + (blocker / "out").string(), folder).exit_code, 4);
}

TEST(CommandLine, WritesAMeshInMetres) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto mesh = folder.path() / "mesh.msh";
  ASSERT_EQ(fretval_run("mesh " + file.string() + " -o " + mesh.string(), folder).exit_code, 0);
  EXPECT_NE(text_of(mesh).find("\"contact\""), std::string::npos);
}

}  // namespace
}  // namespace fretval
