#include <gtest/gtest.h>

#include <filesystem>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/shown.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

TEST(Commands, RefusesAMissingFile) {
  const ScratchFolder folder;
  EXPECT_EQ(fretval_run("run nowhere.prm", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("mdr nowhere.prm", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("report nowhere", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("check --meshes nowhere", folder).exit_code, 2);
  const auto run = fretval_run("check --suite nothing", folder);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("expected small, exact, tolerance, extremes or random"), std::string::npos) << run.err;
  EXPECT_EQ(fretval_run("check --suite extremes --family nothing", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("dance", folder).exit_code, 2);
}

TEST(Commands, SaysWhichVerbWasMeant) {
  const ScratchFolder folder;
  const auto said = [&](const std::string& arguments) {
    const auto run = fretval_run(arguments, folder);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    return run.err;
  };
  expect_parts(said("rnu case.prm -o there"), {"rnu: no such verb; did you mean run?", "valid verbs: new, explain, "});
  expect_parts(said("--quiet compaer a b"), {"compaer: no such verb; did you mean compare?"});
  const auto far_off = said("dance");
  expect_parts(far_off, {"dance: no such verb; valid verbs: "});
  EXPECT_EQ(far_off.find("pages"), std::string::npos) << "it is for those who install";
  EXPECT_EQ(said("run --no-such-option case.prm").find("no such verb"), std::string::npos);
}

TEST(Commands, SaysWhichOptionWasMeant) {
  const ScratchFolder folder;
  const auto said = [&](const std::string& arguments) {
    const auto run = fretval_run(arguments, folder);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    return run.err;
  };
  expect_parts(said("run --poof bars case.prm"),
               {"error: --poof: no such option of fretval run; did you mean --proof?"});
  expect_parts(said("check --sute=exact"), {"error: --sute: no such option", "did you mean --suite?", "check --help"});
  expect_parts(said("run --quite case.prm"), {"did you mean --quiet?"});
  expect_parts(said("run --proof bar case.prm"), {"--proof bar: expected none, bars or tolerance; did you mean bars?"});
  expect_parts(said("run"), {"error: fretval run: cases is required; fretval run --help says more"});
}

TEST(Commands, WritesAReportWithoutAnyOtherProgram) {
  const ScratchFolder folder;
  fs::copy(fs::path(FRETVAL_SOURCE_DIR) / "tests/fuzz/seeds/result_json/phase.json", folder.path() / "result.json");
  const auto run =
      shell_run("PATH=/nowhere " + std::string(FRETVAL_PROGRAM) + " report " + folder.path().string(), folder);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  expect_parts(shown(text_of(folder.path() / "index.html")), {"data-plot=\"0\""});
}

TEST(Commands, WritesAMeshInMetres) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  const auto mesh = folder.path() / "mesh.msh";
  ASSERT_EQ(fretval_run("mesh " + file.string() + " -o " + mesh.string(), folder).exit_code, 0);
  EXPECT_NE(text_of(mesh).find("\"contact\""), std::string::npos);
  const auto sweep = folder.write(
      "sweep.prm", valid_case + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:90:180\nend\n");
  const auto run = fretval_run("mesh " + sweep.string() + " -o " + (folder.path() / "no.msh").string(), folder);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("a sweep has many meshes"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder.path() / "no.msh"));
}

TEST(Commands, WritesNoMeshUnderTheNameOfAnotherFormat) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", valid_case);
  for (const char* name : {"mesh.vtu", "mesh", "mesh.msh.gz"}) {
    const auto run = fretval_run("mesh " + file.string() + " -o " + (folder.path() / name).string(), folder);
    EXPECT_EQ(run.exit_code, 2) << name;
    expect_parts(run.err, {name, "expected a name that ends in .msh"});
    EXPECT_FALSE(fs::exists(folder.path() / name));
  }
}

}  // namespace
}  // namespace fretval
