#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
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

TEST(CommandLine, PrintsTheAnalyticAnswerAsText) {
  const ScratchFolder folder;
  const auto file =
      folder.write("case.prm", valid_case + "subsection Wear\n  set Coefficient = 1e-15\n  set Cycles = 1000\nend\n");
  const auto run = fretval_run("mdr " + file.string() + " --springs", folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out.rfind("case\n  modulus ratio ", 0), 0U) << run.out;
  for (const char* label : {"largest contact radius", "stick radius, shakedown", "outer radius of the wear",
                            "springs: shakedown", "springs: friction per cycle", "worn volume"})
    EXPECT_NE(run.out.find(std::string("\n  ") + label + " "), std::string::npos) << label << "\n" << run.out;
  EXPECT_NE(run.out.find(" m^3 after 1000 cycles\n"), std::string::npos) << run.out;
}

TEST(CommandLine, PrintsWhereNothingSticks) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", replace(valid_case, "amplitude = 1.5e-5", "amplitude = 5e-4"));
  const auto run = fretval_run("mdr " + file.string(), folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("stick radius, shakedown     none (nothing sticks)\n"), std::string::npos) << run.out;
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

// The indenter that wear ends at: nothing slips inside c, and nothing is carried outside.
TEST(CommandLine, RunHoldsALimitingProfileToNoWear) {
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
    for (const char* key : {"slip_inside_stick_zone", "force_outside_stick_zone", "maximum_indentation"}) {
      EXPECT_EQ(json.at("comparison").at(key).at("pass"), true) << key;
      EXPECT_LT(std::abs(json.at("comparison").at(key).at("difference").get<double>()), 0.01) << key;
    }
  }
  EXPECT_EQ(n_results, 1);
  EXPECT_NE(text_of(out / "index.html").find("The state in which nothing wears any more"), std::string::npos);
}

// Every shape in the same scene, with finite elements as coarse as they get.
TEST(CommandLine, RunComparesEveryShape) {
  const std::map<std::string, std::string> shapes{{"cone", "Slope angle = 4"},
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

TEST(CommandLine, MdrAnswersASweepWithAListAndHasNoFieldsOfIt) {
  const ScratchFolder folder;
  const auto file =
      folder.write("sweep.prm", replace(valid_case, "Radius = 1e-2", "Radius = 1e-7") +
                                    "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:90:180\nend\n");
  const auto run = fretval_run("mdr " + file.string() + " --json", folder);
  EXPECT_EQ(run.exit_code, 0);
  const auto json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(json[k].at("name"), "sweep/phase-" + std::to_string(90 * k));
  EXPECT_NE(run.err.find("slope"), std::string::npos) << "100 um into a radius of 100 nm is implausible: " << run.err;
  const auto fields = fretval_run("mdr " + file.string() + " --fields " + (folder.path() / "f.csv").string(), folder);
  EXPECT_EQ(fields.exit_code, 2);
  EXPECT_NE(fields.err.find("a sweep has many fields"), std::string::npos) << fields.err;
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
  EXPECT_NE(run.err.find("expected small, exact, tolerance, extremes or random"), std::string::npos) << run.err;
  EXPECT_EQ(fretval_run("check --suite extremes --family nothing", folder).exit_code, 2);
  EXPECT_EQ(fretval_run("dance", folder).exit_code, 2);
}

TEST(CommandLine, ChecksTheSmallSuite) {
  const ScratchFolder folder;
  const auto junit = folder.path() / "junit.xml", json = folder.path() / "small.json";
  const auto run = fretval_run("check --junit " + junit.string() + " --json " + json.string(), folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("pass: 6 cases: 6 agree"), std::string::npos) << run.out;
  EXPECT_EQ(nlohmann::json::parse(text_of(json)).at("rows").size(), 6U);
  EXPECT_NE(text_of(junit).find("tests=\"6\" failures=\"0\""), std::string::npos) << text_of(junit);
}

// All rows: a heading, a line a row and the verdict.
TEST(CommandLineSlow, ChecksTheExactSolutions) {
  const ScratchFolder folder;
  const auto junit = folder.path() / "junit.xml", json = folder.path() / "exact.json";
  const auto run = fretval_run("check --suite exact --junit " + junit.string() + " --json " + json.string(), folder);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1 + 36 + 1) << run.out;
  EXPECT_NE(text_of(junit).find("tests=\"36\" failures=\"0\""), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text_of(json)).size(), 36U);
}

std::size_t n_files(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// Every case once.
TEST(CommandLineSlow, ChecksATolerance) {
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

TEST(CommandLine, ChecksOneFamilyOfTheExtremes) {
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
TEST(CommandLine, ChecksRandomCasesAndWritesTheWorst) {
  const ScratchFolder folder;
  const auto junit = folder.path() / "junit.xml", json = folder.path() / "new" / "random.json",
             worst = folder.path() / "worst";
  const auto run = fretval_run("check --suite random --cases 2 --seed 1 --junit " + junit.string() + " --json " +
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
TEST(CommandLine, DrawsNewRandomCasesAndSaysHowToRepeatThem) {
  const ScratchFolder folder;
  const auto seed_of = [&] {
    const auto run = fretval_run("check --suite random --cases 1", folder);
    const auto at = run.err.find("--seed ");
    EXPECT_NE(at, std::string::npos) << run.err;
    return run.err.substr(at + 7, run.err.find(' ', at + 7) - at - 7);
  };
  EXPECT_NE(seed_of(), seed_of());
  const auto run = fretval_run("check --suite random --only 3", folder);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--only: of which cases? Expected their --seed"), std::string::npos) << run.err;
}

TEST(CommandLine, RefusesOptionsOfAnotherSuite) {
  const ScratchFolder folder;
  for (const std::string option : {"--write-cases there", "--suite exact --short", "--suite random --meshes there"}) {
    const auto run = fretval_run("check " + option, folder);
    EXPECT_EQ(run.exit_code, 2) << option;
    EXPECT_NE(run.err.find(": it belongs to the suite "), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

TEST(CommandLine, SaysWhenGnuplotCannotDraw) {
  const ScratchFolder folder;
  fs::copy(fs::path(FRETVAL_SOURCE_DIR) / "tests/fuzz/seeds/result_json/phase.json", folder.path() / "result.json");
  const auto run =
      shell_run("PATH=/nowhere " + std::string(FRETVAL_PROGRAM) + " report " + folder.path().string(), folder);
  EXPECT_EQ(run.exit_code, 4) << run.err;
  EXPECT_NE(run.err.find("gnuplot could not draw"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder.path() / "index.html"));
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
  const auto sweep = folder.write(
      "sweep.prm", valid_case + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 0:90:180\nend\n");
  const auto run = fretval_run("mesh " + sweep.string() + " -o " + (folder.path() / "no.msh").string(), folder);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("a sweep has many meshes"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder.path() / "no.msh"));
}

}  // namespace
}  // namespace fretval
