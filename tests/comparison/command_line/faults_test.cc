#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparison/case_file/case_file.h"
#include "comparison/report/report.h"
#include "comparison/support/folders.h"
#include "meshes/msh_file.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/shown.h"

// What goes wrong around a computation, and what the tool says. The list of faults is in docs/robustness.md.
namespace fretval {
namespace {

namespace fs = std::filesystem;

std::string refusal_of(const std::string& name, const std::string& text) {
  const ScratchFolder folder;
  const auto file = folder.write(name, text);
  return refusal([&] { prepare(read_case_file(file)); });
}

/// All files below a folder, and no other, relative to it.
/// Also while a run writes there, and files go away.
std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code gone;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file(gone)) files.push_back(entry.path().lexically_relative(folder).string());
  return files;
}

// ---- case files

struct Fault {
  std::string from, to;
  std::vector<std::string> message;  // besides the name of the file
};

class CaseFault : public testing::TestWithParam<Fault> {};

TEST_P(CaseFault, IsRefusedByName) {
  const auto& [from, to, parts] = GetParam();
  const std::string message = refusal_of("bad.prm", replace(valid_case, from, to));
  expect_parts(message, {"bad.prm"});
  expect_parts(message, parts);
}

INSTANTIATE_TEST_SUITE_P(
    Numbers, CaseFault,
    testing::Values(Fault{"Radius = 1e-2", "Radius = 0", {"Indenter / Radius = 0", "positive"}},
                    Fault{"Radius = 1e-2", "Radius = -1e-2", {"Indenter / Radius = -1e-2", "positive"}},
                    Fault{"Radius = 1e-2", "Radius = inf", {"Indenter / Radius = inf", "positive"}},
                    Fault{"Radius = 1e-2", "Radius = nan", {"Indenter / Radius = nan", "positive"}},
                    Fault{"Radius = 1e-2", "Radius = 1e400", {"Indenter / Radius = 1e400", "positive"}},
                    Fault{"Radius = 1e-2", "Radius = 1e-400", {"Indenter / Radius = 1e-400", "positive"}},
                    Fault{"Radius = 1e-2", "Radius = 0,01", {"Indenter / Radius = 0,01", "positive"}},
                    Fault{"Radius = 1e-2", "Radius = 1e-2 Hz", {"Indenter / Radius = 1e-2 Hz", "positive", "mm"}},
                    Fault{"times = 0.1", "times = -0.1", {"Branch times = -0.1", "positive"}},
                    Fault{"times = 0.1", "times = 0", {"Branch times = 0", "positive"}},
                    Fault{"moduli = 1e6", "moduli = 0", {"Branch moduli = 0", "positive"}},
                    Fault{"modulus = 1e6", "modulus = -1e6", {"Relaxed shear modulus = -1e6", "positive"}},
                    Fault{"modulus = 1e6", "modulus = 0", {"Relaxed shear modulus = 0", "Maxwell"}},
                    Fault{"Coefficient = 0.5", "Coefficient = -0.5", {"Friction / Coefficient = -0.5", "positive"}},
                    Fault{"Coefficient = 0.5", "Coefficient = 0", {"Friction / Coefficient = 0", "positive"}},
                    Fault{"Coefficient = 0.5", "Coefficient = nan", {"Friction / Coefficient = nan", "positive"}},
                    Fault{"Indentation = 1e-4", "Indentation = 0", {"Motion / Indentation = 0", "positive"}},
                    Fault{"Normal amplitude = 2e-5", "Normal amplitude = -1", {"Normal amplitude = -1", "negative"}},
                    Fault{"Normal frequency = 1", "Normal frequency = 0", {"Normal frequency = 0", "positive"}},
                    Fault{"Rheology = standard solid\n  set Relaxed shear modulus = 1e6\n  set Branch moduli = 1e6\n  "
                          "set Branch times = 0.1",
                          "Rheology = kelvin voigt\n  set Relaxed shear modulus = 1e6\n  set Viscosity = -1",
                          {"Elastomer / Viscosity = -1", "positive"}},
                    // The finite elements are for incompressible bodies alone.
                    Fault{"Branch times = 0.1",
                          "Branch times = 0.1\n  set Poisson ratio = 0.6",
                          {"Elastomer / Poisson ratio = 0.6", "from 0 to 0.5"}}));

/// An entry in a section of its own before the last one.
Fault in_section(const std::string& section, const std::string& entries, const std::vector<std::string>& parts) {
  return {"subsection Accuracy", "subsection " + section + "\n" + entries + "\nend\nsubsection Accuracy", parts};
}

Fault with_stick_ratio(const std::string& ratio) {
  return in_section("Wear", "set State = limiting\nset Stick radius ratio = " + ratio,
                    {"Wear / Stick radius ratio = " + ratio, "0.01 to 0.99"});
}

Fault with_shape(const std::string& entries, const std::vector<std::string>& parts) {
  return {"parabola\n  set Radius = 1e-2", entries, parts};
}

Fault with_sweep(const std::string& values, const char* expected = "first : step : last") {
  return in_section("Sweep", "set Entry = Motion / Phase\nset Values = " + values,
                    {"Sweep / Values = " + values, expected});
}

// Both ends of every range, and every way to misspell a list.
INSTANTIATE_TEST_SUITE_P(
    Ranges, CaseFault,
    testing::Values(
        Fault{"Tolerance = 0.01", "Tolerance = 9e-6", {"Accuracy / Tolerance = 9e-6", "between 1e-5 and 0.1"}},
        Fault{"Tolerance = 0.01", "Tolerance = 0.11", {"Accuracy / Tolerance = 0.11", "between 1e-5 and 0.1"}},
        Fault{
            "Tolerance = 0.01", "Tolerance = 0.01\nset Rings per radius = 15", {"Rings per radius = 15", "16 to 640"}},
        Fault{"Tolerance = 0.01",
              "Tolerance = 0.01\nset Rings per radius = 641",
              {"Rings per radius = 641", "16 to 640"}},
        Fault{"Tolerance = 0.01", "Tolerance = 0.01\nset Rings per radius = 20.5", {"20.5", "a whole number"}},
        Fault{
            "Tolerance = 0.01", "Tolerance = 0.01\nset Steps per cycle = 15", {"Steps per cycle = 15", "16 to 10000"}},
        Fault{"Tolerance = 0.01", "Tolerance = 0.01\nset Economise = true", {"Economise"}},
        in_section("Output", "set Fields = all", {"Output / Fields = all", "none", "extremes"}),
        with_stick_ratio("0.001"), with_stick_ratio("0.999"),
        Fault{"times = 0.1", "times = 0.1, 0.2", {"Branch times = 0.1, 0.2", "1 times"}},
        Fault{"times = 0.1", "times = 0.1,", {"Branch times", "last comma"}},
        Fault{"Branch moduli = 1e6", "Branch moduli = 1e6, 2e6", {"Elastomer / Branch"}},
        Fault{"Phase = 60", "Phase = often", {"Motion / Phase = often", "finite number"}}, with_sweep("0;5:9"),
        with_sweep("0:5;9"), with_sweep("0:5"), with_sweep("0:0:9"), with_sweep("9:1:0"),
        with_sweep("0:1e-9:1", "at most 100000 values of Motion / Phase"), with_sweep("0:1:9 x"),
        in_section("Sweep", "set Entry = Phase\nset Values = 1", {"Sweep / Entry = Phase", "SECTION / ENTRY"})));

// What is missing, or does not belong to the choices that were made.
INSTANTIATE_TEST_SUITE_P(
    Choices, CaseFault,
    testing::Values(
        Fault{"Rheology = standard solid", "Rheology = rubber", {"Rheology = rubber", "kelvin voigt"}},
        Fault{"Law = unidirectional", "Law = scalar", {"Friction / Law = scalar", "unidirectional"}},
        Fault{"set Radius = 1e-2", "", {"Indenter / Radius is missing", "positive"}},
        Fault{"Radius = 1e-2", "Radius = 1e-2\nset Slope angle = 5", {"Slope angle = 5", "cone"}},
        Fault{"Radius = 1e-2", "Radius = 1e-2\nset Flat radius = 1", {"Flat radius = 1", "truncated sphere"}},
        with_shape("table\nset Table = none.csv", {"Indenter / Table = none.csv", "relative to the case file"}),
        Fault{"times = 0.1", "times = 0.1\nset Temperature = 40", {"Reference temperature is missing"}},
        Fault{"times = 0.1", "times = 0.1\nset Fractional order = 1", {"Fractional order = 1", "fractional zener"}},
        in_section("Wear", "set Cycles = 100", {"Wear / Coefficient is missing"}),
        Fault{"Phase = 60", "Phase = 60\nset Normal force = 1", {"Indentation = 1e-4", "Normal force"}}));

INSTANTIATE_TEST_SUITE_P(
    Structure, CaseFault,
    testing::Values(Fault{"set Radius", "set Radios", {"Radios", "Valid entries", "Slope angle"}},
                    Fault{"subsection Friction", "subsection Fiction", {"Fiction", "Valid subsections", "Friction"}},
                    Fault{"end\nsubsection Friction", "subsection Friction", {"Friction stands within subsection"}},
                    Fault{"subsection Indenter",
                          "include nowhere.prm\nsubsection Indenter",
                          {"include nowhere.prm", "no such file"}},
                    Fault{"set Radius = 1e-2",
                          "set Radius = 1e-2\n  set Radius = 2e-2",
                          {"line 4", "Indenter / Radius is set a second time, first in line 3", "once"}},
                    Fault{"subsection Accuracy",
                          "subsection  Indenter\n  SET Radius = 1\nend\nsubsection Accuracy",
                          {"Indenter / Radius is set a second time"}},
                    Fault{"subsection Friction\n  set Coefficient = 0.5\n  set Law = unidirectional\nend\n",
                          "",
                          {"Friction / Coefficient is missing", "positive"}},
                    Fault{"subsection Accuracy",
                          "subsection Solver\n  set Threads = 4\nend\nsubsection Accuracy",
                          {"Solver", "Valid subsections"}},
                    Fault{"subsection Indenter", "include\nsubsection Indenter", {"line 1", "names no file"}},
                    Fault{"subsection Indenter", "INCLUDE bad.prm\nsubsection Indenter", {"includes itself"}},
                    Fault{"subsection Indenter", "incl\\\nude bad.prm\nsubsection Indenter", {"includes itself"}},
                    Fault{"subsection Friction",
                          "include bad.prm\nsubsection Friction",
                          {"line 11", "before the first subsection"}},
                    Fault{"Law = unidirectional", "Law = \xff\xfe", {"Friction / Law", "unidirectional"}},
                    Fault{"set Law", "s\xe9t Law", {"line 13", "expected set ENTRY = VALUE"}}));

TEST(CaseFaults, IncludesThatLoopThroughOthersAreRefused) {
  const ScratchFolder folder;
  const auto file = folder.write("a.prm", "include b.prm\n");
  folder.write("b.prm", "include a.prm\n");
  expect_parts(refusal([&] { read_case_file(file); }), {"a.prm", "includes itself"});
}

// 2^20 files if each were read as often as it is named.
TEST(CaseFaults, IncludesThatMultiplyAreRefused) {
  const ScratchFolder folder;
  folder.write("0.prm", "# nothing\n");
  for (int i = 1; i <= 20; ++i) {
    const std::string line = "include " + std::to_string(i - 1) + ".prm\n";
    folder.write(std::to_string(i) + ".prm", line + line);
  }
  expect_parts(refusal([&] { read_case_file(folder.path() / "20.prm"); }), {"20.prm", "more than 100 files"});
}

TEST(CaseFaults, BinaryAndHugeFilesAreRefused) {
  expect_parts(refusal_of("bad.prm", valid_case + std::string(1, '\0')), {"bad.prm", "zero byte", "text file"});
  expect_parts(refusal_of("bad.prm", std::string(2'000'000, '#')), {"bad.prm", "2000000 bytes", "at most 1000000"});
  expect_parts(refusal_of("bad.prm", ""), {"bad.prm"});
}

TEST(CaseFaults, AByteOrderMarkAndAnyLineEndingAreAccepted) {
  std::string text = "\xEF\xBB\xBF# \xe9\n";
  for (const char c : valid_case) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const ScratchFolder folder;
  const auto scene = read_case_file(folder.write("case.prm", text)).at(0);
  EXPECT_EQ(scene.indenter.radius, 1e-2);
  EXPECT_EQ(scene.elastomer.rheology, Case::Rheology::standard_solid);
}

struct BadJson {
  std::string text;
  std::vector<std::string> message;
};

TEST(CaseFaults, BadJsonIsRefusedByName) {
  const std::vector<BadJson> bad{
      {"", {"empty"}},
      {"[]", {"object of sections"}},
      {"{\"Indenter\": 1}", {"Indenter", "object of entries"}},
      {"{\"Indenter\": {\"Radios\": 1}}", {"Indenter / Radios", "no such entry", "Valid entries"}},
      {"{\"Indentor\": {\"Radius\": 1}}", {"Indentor", "no such subsection", "did you mean Indenter?"}},
      {"{\"Indenter\": {\"Radius\": [[1]]}}", {"Indenter / Radius", "text, a number, true or false"}},
      {"{\"Indenter\": {\"Radius\": null}}", {"Indenter / Radius", "text, a number, true or false"}},
      {"{\"Indenter\": {\"Radius\": 1, \"Radius\": 2}}", {"Indenter / Radius", "second time"}},
      {"{\"Indenter\": {}, \"Indenter\": {}}", {"Indenter", "second time"}},
      {"{\"Indenter\": {\"Shape\": \"\xff\"}}", {"UTF-8"}},
      {"{\"Indenter\": {\"Radius\": 1e400}}", {"1e400"}},
      {std::string(500'000, '['), {"parse error"}},
      {std::string(300'000, '[') + std::string(300'000, ']'), {"object of sections"}}};
  for (const auto& [text, parts] : bad) {
    const auto message = refusal_of("bad.json", text);
    expect_parts(message, {"bad.json"});
    expect_parts(message, parts);
  }
}

struct BadTable {
  std::string text;
  std::vector<std::string> message;
};

TEST(TableFaults, BadProfilesAreRefusedByFileAndLine) {
  const std::string rows = "r,f\nm,m\n0,0\n1e-4,1e-6\n2e-4,4e-6\n3e-4,9e-6\n";
  const std::vector<BadTable> bad{{"", {"no rows"}},
                                  {rows + "4e-4\n", {"line 7", "has 1 value; must have one in column 2"}},
                                  {rows + "4e-4;1,6e-5\n", {"line 7", "semicolons", "rows before have commas"}},
                                  {rows + "2e-4,4e-6\n", {"line 7", "radius = 0.0002", "scan outwards"}},
                                  {rows + "-4e-4,1\n", {"line 7", "radius = -0.0004"}},
                                  {rows + "4e-4,nan\n", {"line 7", "finite"}},
                                  {rows + std::string("\0\1\2", 3), {"line 7", "zero byte"}},
                                  {"r,f\nm,m\n0,0\n1e-4,1e-6\n", {"at least 4"}},
                                  {"0,0\n1,1\n2,4\n3,9\n", {"column 1 has no unit", "mm,um"}},
                                  {"r [mm],f\n0,0\n1,1\n2,4\n3,9\n", {"column 2 has no unit"}},
                                  {rows + std::string(1'000'000, '1'), {"line 7", "10000 characters"}}};
  for (const auto& [text, parts] : bad) {
    const ScratchFolder folder;
    folder.write("pin.csv", text);
    const auto file =
        folder.write("bad.prm", replace(replace(valid_case, "parabola", "table"), "Radius = 1e-2", "Table = pin.csv"));
    const auto message = refusal([&] { prepare(read_case_file(file)); });
    expect_parts(message, {"pin.csv"});
    expect_parts(message, parts);
  }
}

TEST(TableFaults, BadModuliAreRefusedByFileAndLine) {
  const std::string units = "f,G',G''\nHz,Pa,Pa\n";
  const std::vector<BadTable> bad{{units + "1,1e6,1e5\n", {"single frequency", "at least 2"}},
                                  {units + "1,1e6,1e5\n2,-1e6,1e5\n", {"line 4", "storage modulus", "positive"}},
                                  {units + "1,1e6,1e5\n0,1e6,1e5\n", {"line 4", "frequency", "positive"}},
                                  {"1,1e6\n2,1e6\n", {"line 1", "must have 3"}},
                                  {"1,1e6,1e5\n2,1e6,1e5\n", {"column 1 has no unit", "Hz,MPa,MPa"}},
                                  {"f,G',G''\nHz,bar,bar\n1,1,1\n2,1,1\n", {"bar", "Pa"}}};
  for (const auto& [text, parts] : bad) {
    const ScratchFolder folder;
    folder.write("dma.csv", text);
    const auto file = folder.write("bad.prm", case_with_modulus_table());
    const auto message = refusal([&] { prepare(read_case_file(file)); });
    expect_parts(message, {"dma.csv"});
    expect_parts(message, parts);
  }
}

TEST(CaseFaults, NamesThatAreNoFolderAreRefused) {
  for (const char* name : {"...prm", "..prm", "index.html.prm", "exact.json.prm", "a\nb.prm", "a\x1b[2J.prm"})
    expect_parts(refusal_of(name, valid_case), {"becomes that of a folder of results", "rename"});
  expect_parts(refusal_of("a\xff.prm", valid_case), {"not UTF-8"});
}

// ---- stored results

// Found by fuzzing: a limiting profile whose forces were not compared, or not finite.
TEST(ResultFaults, AReportShowsALimitingProfileWithoutForces) {
  const fs::path seed = fs::path(FRETVAL_SOURCE_DIR) / "tests/fuzz/seeds/result_json/limiting.json";
  for (const bool compared : {true, false}) {
    auto json = nlohmann::json::parse(text_of(seed));
    if (compared)
      json["comparison"]["normal_force_max"]["difference"] = nullptr;
    else
      json["comparison"].erase("normal_force_max");
    const ScratchFolder folder;
    folder.write("result.json", json.dump());
    EXPECT_NE(shown(text_of(write_report(folder.path()))).find("<td>–</td>"), std::string::npos);
  }
}

// Names, keys and words of a stored result stand in the page as text.
TEST(ResultFaults, TagsInAResultAreNoTagsInTheReport) {
  const fs::path seeds = fs::path(FRETVAL_SOURCE_DIR) / "tests/fuzz/seeds/result_json";
  for (const char* seed : {"tags.json", "limiting.json"}) {
    const ScratchFolder folder;
    folder.write("result.json", text_of(seeds / seed));
    const std::string page = text_of(write_report(folder.path()));
    EXPECT_EQ(n_of("<script", page), 4) << "data, sections.js, d3 and report.js: " << seed;
    const auto html = shown(page);
    EXPECT_EQ(html.find("<script"), std::string::npos) << seed;
    EXPECT_NE(html.find("&lt;script&gt;"), std::string::npos) << seed;
  }
}

// ---- the numerics

// A mesh of somebody else's whose contact line ends inside the contact.
TEST(NumericsFaults, AContactLineThatIsTooShortFailsTheCheck) {
  const ScratchFolder folder;
  auto mesh = meshes::read_msh(fs::path(FRETVAL_SOURCE_DIR) / "meshes" / "small" / "coarse.msh");
  for (auto& edge : mesh.edges)
    if (edge.boundary == meshes::Boundary::contact &&
        std::max(mesh.nodes[edge.nodes[0]][0], mesh.nodes[edge.nodes[1]][0]) > 0.6)
      edge.boundary = meshes::Boundary::free;
  for (const char* name : {"coarse.msh", "fine.msh"}) meshes::write_msh(mesh, folder.path() / name);
  const auto run = fretval_run("check --meshes " + quoted(folder.path()), folder);
  EXPECT_EQ(run.exit_code, 3) << run.out;
  expect_parts(run.out, {"FAIL", "end of the contact line of the mesh", "use a longer one"});
}

// ---- the system

TEST(SystemFaults, AFolderInUseIsRefusedAndLeftAlone) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", elastic_case());
  const auto out = folder.path() / "out";
  const auto arguments = quoted(file) + " -o " + quoted(out);
  {
    const FolderLock lock(out);
    const auto run = fretval_run("run " + arguments, folder);
    EXPECT_EQ(run.exit_code, 4);
    expect_parts(run.err, {"another fretval is writing", out.string(), "-o"});
    EXPECT_TRUE(files_below(out).empty());
  }
  EXPECT_EQ(fretval_run("run " + arguments, folder).exit_code, 0);
}

TEST(SystemFaults, AFullStandardOutputIsASystemError) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", elastic_case());
  const auto run = shell_run(std::string(FRETVAL_PROGRAM) + " mdr " + quoted(file) + " >/dev/full", folder);
  EXPECT_EQ(run.exit_code, 4);
  expect_parts(run.err, {"standard output", "No space left"});
}

TEST(SystemFaults, AFolderThatCannotBeMadeIsASystemError) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", elastic_case());
  for (const char* verb : {"run", "trade"}) {
    const auto run = fretval_run(verb + (" " + quoted(file) + " -o /proc/fretval"), folder);
    EXPECT_EQ(run.exit_code, 4) << run.err;
    expect_parts(run.err, {"/proc/fretval"});
  }
  const auto mesh = fretval_run("mesh " + quoted(file) + " -o /proc/mesh.msh", folder);
  EXPECT_EQ(mesh.exit_code, 4);
  expect_parts(mesh.err, {"/proc/mesh.msh"});
}

// A disk of 40 kB takes the first files of a case, not its fields.
TEST(SystemFaults, AFullDiskLeavesNothingHalfWritten) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", elastic_case());
  const auto disk = folder.path() / "disk";
  fs::create_directory(disk);
  const std::string command =
      "unshare -m sh -c " + quoted("mount -t tmpfs -o size=40k none " + disk.string() + " || exit 77; " +
                                   FRETVAL_PROGRAM + " run " + file.string() + " -o " + disk.string() +
                                   "; code=$?; cd " + disk.string() + "; find . -type f; exit $code");
  const auto run = shell_run(command, folder);
  if (run.exit_code == 77 || run.err.find("unshare") != std::string::npos) GTEST_SKIP() << "needs to mount a disk";
  EXPECT_EQ(run.exit_code, 4) << run.err;
  expect_parts(run.err, {"No space left", "case/"});
  EXPECT_NE(run.out.find("history.csv"), std::string::npos) << run.out;
  for (const char* name : {".partial", "result.json", "index.html"})
    EXPECT_EQ(run.out.find(name), std::string::npos) << run.out;
}

// What a file says is repeated in errors; it must not steer the terminal.
TEST(SystemFaults, ErrorsHaveNoControlCharacters) {
  const ScratchFolder folder;
  const auto file = folder.write("case.prm", replace(valid_case, "set Radius", "set \x1b[2J\x07"));
  const auto run = fretval_run("mdr " + quoted(file), folder);
  EXPECT_EQ(run.exit_code, 2);
  expect_parts(run.err, {"case.prm", "line 3", "?[2J?"});
  EXPECT_EQ(run.err.find('\x1b'), std::string::npos);
}

// Names of files are text in the report and nothing in a shell.
TEST(SystemFaults, HostileNamesAreText) {
  const ScratchFolder folder;
  const std::string html = "<img src=x onerror=alert(1)>", shell = "a`touch here`$(touch here);'\" touch here";
  folder.write(html + ".prm", elastic_case());
  const std::string not_utf8 = "d\xff";
  fs::create_directory(folder.path() / not_utf8);
  folder.write(not_utf8 + "/" + shell + ".prm", elastic_case());
  const auto run = shell_run("cd " + quoted(folder.path()) + " && " + FRETVAL_PROGRAM + " run " +
                                 quoted(html + ".prm") + " " + quoted(not_utf8 + "/" + shell + ".prm") + " -o out",
                             folder);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const auto& name : {html, shell}) EXPECT_TRUE(fs::exists(folder.path() / "out" / name / "result.json")) << name;
  EXPECT_FALSE(fs::exists(folder.path() / "here"));
  const std::string page = text_of(folder.path() / "out" / "index.html");
  for (const auto& text : {page, shown(page)}) {
    EXPECT_EQ(text.find("<img"), std::string::npos);
    EXPECT_NE(text.find("&lt;img src=x"), std::string::npos);
  }
}

}  // namespace
}  // namespace fretval
