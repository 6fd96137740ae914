#include "comparison/case_file/case_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval {
namespace {

Case read_one(const std::string& text) {
  const ScratchFolder folder;
  return read_case_file(folder.write("one.prm", text)).at(0);
}

std::string error_of(const std::string& text) {
  const ScratchFolder folder;
  const auto file = folder.write("bad.prm", text);
  return refusal([&] { read_case_file(file); });
}

TEST(CaseFile, ReadsEveryEntry) {
  const Case input = read_one(valid_case);
  EXPECT_EQ(input.name, "one");
  EXPECT_EQ(input.indenter.shape, Case::Shape::parabola);
  EXPECT_EQ(input.indenter.radius, 1e-2);
  EXPECT_EQ(input.elastomer.relaxed_modulus, 1e6);
  EXPECT_EQ(input.elastomer.branch_moduli, std::vector<double>{1e6});
  EXPECT_EQ(input.elastomer.branch_times, std::vector<double>{0.1});
  EXPECT_EQ(input.friction_coefficient, 0.5);
  EXPECT_EQ(input.motion.indentation, 1e-4);
  EXPECT_EQ(input.motion.normal_amplitude, 2e-5);
  EXPECT_EQ(input.motion.tangential_amplitude, 1.5e-5);
  EXPECT_EQ(input.motion.normal_frequency, 1);
  EXPECT_EQ(input.motion.phase, 60);
  EXPECT_EQ(input.tolerance, 0.01);
  EXPECT_EQ(input.wear, Case::Wear::unworn);
}

/// The valid case over another body.
std::string on(const std::string& body, const std::string& base = valid_case) {
  return base + "subsection Body\n" + body + "end\n";
}

TEST(CaseFile, ReadsBodies) {
  EXPECT_TRUE(read_one(valid_case).body.is_half_space());
  const auto layer = read_one(on("set Shape = layer\nset Thickness = 3 mm\nset Base = bonded\n")).body;
  EXPECT_EQ(layer.shape, Case::Body::Shape::layer);
  EXPECT_DOUBLE_EQ(layer.thickness, 3e-3);
  EXPECT_TRUE(layer.is_bonded);
  const auto still = replace(valid_case, "Tangential amplitude = 1.5e-5", "Tangential amplitude = 0");
  const auto cylinder =
      read_one(on("set Shape = cylinder\nset Thickness = 3 mm\nset Radius = 1 cm\nset Base = frictionless\n", still))
          .body;
  EXPECT_EQ(cylinder.shape, Case::Body::Shape::cylinder);
  EXPECT_DOUBLE_EQ(cylinder.radius, 1e-2);
  EXPECT_FALSE(cylinder.is_bonded);
  EXPECT_EQ(read_one(valid_case).elastomer.poisson_ratio, 0.5);
  EXPECT_EQ(
      read_one(replace(valid_case, "set Rheology", "set Poisson ratio = 0.3\nset Rheology")).elastomer.poisson_ratio,
      0.3);
}

TEST(CaseFile, RefusesImpossibleBodies) {
  const auto names = [](const std::string& text, const std::string& what) { expect_parts(error_of(text), {what}); };
  names(on("set Shape = slab\n"), "expected one of half space, layer, cylinder");
  names(on("set Shape = layer\nset Base = bonded\n"), "Body / Thickness");
  names(on("set Shape = layer\nset Thickness = 1 mm\n"), "Body / Base");
  const auto missing = error_of(on("set Shape = layer\nset Thickness = 1 mm\n"));
  EXPECT_EQ(missing.find("Body / Base"), missing.rfind("Body / Base")) << "said once: " << missing;
  names(on("set Shape = layer\nset Thickness = 1 mm\nset Radius = 1 mm\nset Base = bonded\n"),
        "belongs to Shape = cylinder");
  names(on("set Thickness = 1 mm\n"), "belongs to Shape = layer or cylinder");
  names(on("set Shape = layer\nset Thickness = 1 mm\nset Base = frictionless\n"),
        "holds the body against the tangential");
  for (const char* nu : {"-0.1", "0.51", "nan"})
    names(replace(valid_case, "set Rheology", std::string("set Poisson ratio = ") + nu + "\nset Rheology"),
          "from 0 to 0.5");
}

TEST(CaseFile, ReadsAnUnlockedPhase) {
  EXPECT_FALSE(read_one(replace(valid_case, "Phase = 60", "Phase = free")).motion.phase);
}

TEST(CaseFile, OverridesWhatItIncludes) {
  const ScratchFolder folder;
  folder.write("base.prm", valid_case);
  const auto file = folder.write("derived.prm", "include base.prm\nsubsection Motion\n  set Phase = 10\nend\n");
  const auto input = read_case_file(file).at(0);
  EXPECT_EQ(input.motion.phase, 10);
  EXPECT_EQ(input.indenter.radius, 1e-2);
  EXPECT_EQ(input.name, "derived");
}

TEST(CaseFile, ExpandsASweep) {
  const auto sweep = [](const std::string& values) {
    const ScratchFolder folder;
    return read_case_file(folder.write("family.prm", valid_case +
                                                         "subsection Sweep\n  set Entry = Motion / Phase\n"
                                                         "  set Values = " +
                                                         values + "\nend\n"));
  };
  const auto range = sweep("0:30:180");
  ASSERT_EQ(range.size(), 7U);
  EXPECT_EQ(range[6].motion.phase, 180);
  EXPECT_EQ(range[1].name, "family/phase-30");
  EXPECT_EQ(range[1].sweep->value, 30);
  EXPECT_EQ(sweep("10, 20").size(), 2U);
  EXPECT_EQ(sweep("0:0.1:0.3").size(), 4U) << "0.1 + 0.1 + 0.1 > 0.3";
  EXPECT_EQ(sweep("0.123456789").at(0).motion.phase, 0.123456789) << "the name has fewer digits";
  EXPECT_EQ(sweep("-90:30:-30").size(), 3U);
  EXPECT_NEAR(*sweep("0 : 1 : 2 rad").at(2).motion.phase, 114.59155902616465, 1e-12);
  EXPECT_EQ(sweep("10 deg, 20 deg").at(1).motion.phase, 20);
  EXPECT_THROW(sweep("10 mm, 20 mm"), InputError);
}

TEST(CaseFile, ReadsJsonThroughTheSameHandler) {
  const ScratchFolder folder;
  const auto file = folder.write("one.json", R"({
    "Indenter": {"Shape": "cone", "Slope angle": 5},
    "Elastomer": {"Rheology": "elastic", "Relaxed shear modulus": "1e6"},
    "Friction": {"Coefficient": "0.5", "Law": "unidirectional"},
    "Motion": {"Indentation": "1e-4", "Normal amplitude": "0", "Normal frequency": "1",
               "Tangential amplitude": "1e-5", "Tangential frequency": "1", "Phase": "0"},
    "Accuracy": {"Tolerance": "0.01"}})");
  const auto input = read_case_file(file).at(0);
  EXPECT_EQ(input.indenter.shape, Case::Shape::cone);
  EXPECT_EQ(input.indenter.slope_angle, 5);
}

TEST(CaseFile, ReadsListsOfJsonAndUnitsInThem) {
  const ScratchFolder folder;
  const auto text = [](const std::string& moduli) {
    return R"({"Indenter": {"Shape": "parabola", "Radius": "10 mm"},
    "Elastomer": {"Rheology": "prony", "Relaxed shear modulus": "1 MPa", "Branch times": [0.1, 1],
                  "Branch moduli": )" +
           moduli + R"(},
    "Friction": {"Coefficient": 0.5},
    "Motion": {"Indentation": "0.1 mm", "Normal amplitude": 0, "Normal frequency": 1, "Tangential amplitude": 1e-5,
               "Tangential frequency": 1, "Phase": 0},
    "Accuracy": {"Tolerance": 0.01}})";
  };
  for (const char* moduli : {"[1e6, 2000000]", "[\"1 MPa\", \"2 MPa\"]"})
    EXPECT_EQ(read_case_file(folder.write("one.json", text(moduli))).at(0).elastomer.branch_moduli,
              (std::vector<double>{1e6, 2e6}));
}

TEST(CaseFile, NeedsNoToleranceForMdrAlone) {
  const ScratchFolder folder;
  const auto file = folder.write("one.prm", replace(valid_case, "  set Tolerance = 0.01\n", ""));
  EXPECT_EQ(read_case_file(file, Accuracy::optional).at(0).indenter.radius, 1e-2);
  EXPECT_THROW(read_case_file(file), InputError);
}

TEST(CaseFile, SaysEverythingThatIsWrongAtOnceAndNothingTwice) {
  std::string text = replace(valid_case, "Radius = 1e-2", "Radiuss = 1e-2");
  text = replace(text, "Branch times = 0.1", "Branch times = 10 mm");
  text = replace(text, "set Law", "set Poisson ratio = 0.4\n  set Law");
  text = replace(text, "subsection Motion", "subsection Motoin");
  text = replace(text, "Tolerance = 0.01", "Tolerance = 1");
  const auto message = error_of(text);
  expect_parts(message,
               {"line 3: Indenter / Radiuss: no such entry; did you mean Radius?", "Branch times = 10 mm",
                "line 13: Friction / Poisson ratio: no such entry; write Elastomer / Poisson ratio",
                "line 16: subsection Motoin: no such subsection; did you mean Motion?", "Tolerance = 1: expected"});
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 4) << message;
}

TEST(CaseFile, NamesTheEntryOfAnotherSection) {
  expect_parts(error_of(replace(valid_case, "set Law", "set Radius = 1\n  set Law")),
               {"did you mean Indenter / Radius or Body / Radius?"});
  expect_parts(error_of(replace(valid_case, "set Radius", "set Young's modulus")), {"Relaxed shear modulus = E/3"});
}

TEST(CaseFile, OfTheGalleryOrTheExamplesIsValid) {
  int n_files = 0;
  for (const char* folder : {"cases/gallery", "cases/examples"})
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(FRETVAL_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".prm") continue;
      EXPECT_NO_THROW(read_case_file(entry.path())) << entry.path();
      ++n_files;
    }
  EXPECT_EQ(n_files, 29);
}

TEST(CaseFile, NamesAFileThatIsNotThere) {
  expect_parts(refusal([] { read_case_file("nowhere/case.prm"); }), {"nowhere/case.prm: no such file"});
}

TEST(CaseFile, RefusesASweepOverNothing) {
  expect_parts(error_of(valid_case + "subsection Sweep\n  set Entry = Motion / Speed\n  set Values = 1\nend\n"),
               {"Motion / Speed"});
}

TEST(CaseFile, SaysHowManyValuesASweepMayHave) {
  const auto sweep = [](const char* values) {
    return valid_case + "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = " + values + "\nend\n";
  };
  const ScratchFolder folder;
  const auto cases = [&](const std::string& text) { return read_case_file(folder.write("case.prm", text)); };
  expect_parts(refusal([&] { cases(sweep("0:0.001:190")); }),
               {"Sweep / Values = 0:0.001:190", "at most 100000 values of Motion / Phase", "190001"});
  EXPECT_EQ(cases(sweep("0:0.1:0.3")).size(), 4U);
}

TEST(CaseFile, OfTwoEntriesIsAMap) {
  const auto map = [](const char* second) {
    return valid_case +
           "subsection Sweep\n  set Entry = Friction / Coefficient\n  set Values = 0.3, 0.5\n  set Second entry = " +
           second + "\n  set Second values = 5 um, 10 um, 15 um\nend\n";
  };
  const ScratchFolder folder;
  const auto cases = read_case_file(folder.write("case.prm", map("Motion / Tangential amplitude")));
  ASSERT_EQ(cases.size(), 6U);
  EXPECT_EQ(cases[4].name, "case/coefficient-0.5-tangential-amplitude-1e-05");
  EXPECT_EQ(cases[4].friction_coefficient, 0.5);
  EXPECT_EQ(cases[4].motion.tangential_amplitude, 1e-5);
  EXPECT_EQ(cases[4].sweep->second_entry, "Motion / Tangential amplitude");
  EXPECT_EQ(cases[4].sweep->second_value, 1e-5);
  expect_parts(refusal([&] { read_case_file(folder.write("case.prm", map("Friction / Coefficient"))); }),
               {"Sweep / Second entry = Friction / Coefficient", "another one than the Entry"});
  const auto of_one_section =
      replace(map("Motion / Tangential amplitude"), "Entry = Friction / Coefficient\n  set Values = 0.3, 0.5",
              "Entry = Motion / Normal amplitude\n  set Values = 10 um, 20 um");
  EXPECT_EQ(read_case_file(folder.write("case.prm", of_one_section)).size(), 6U);
}

// 400 times 400.
TEST(CaseFile, SaysHowManyCasesAMapMayHave) {
  const ScratchFolder folder;
  const auto file = folder.write(
      "case.prm", valid_case +
                      "subsection Sweep\n  set Entry = Motion / Phase\n  set Values = 1:1:400\n"
                      "  set Second entry = Friction / Coefficient\n  set Second values = 0.001:0.001:0.4\nend\n");
  expect_parts(refusal([&] { read_case_file(file); }),
               {"Sweep / Second values = 0.001:0.001:0.4", "at most 100000 cases altogether, and these are 160000"});
}

}  // namespace
}  // namespace fretval
