#include "comparison/case/plausibility.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "comparison/case_file/case_file.h"
#include "comparison/reference/mdr_case.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval {
namespace {

TEST(Plausibility, ImplausibleUnitsAreWarnedAbout) {
  const auto warnings = [](const std::string& from, const std::string& to) {
    const auto scene = read_case(replace(valid_case, from, to));
    std::string all;
    for (const auto& warning : implausible_values(scene, profile_of(scene.indenter))) all += warning;
    return all;
  };
  EXPECT_EQ(warnings("Phase = 60", "Phase = 30"), "");
  expect_parts(warnings("Indentation = 1e-4", "Indentation = 0.1"), {"case.prm", "slope of 3.2", "a/R", "in m?"});
  expect_parts(warnings("Radius = 1e-2", "Radius = 1e-5"), {"case.prm", "a/R", "in m?"});
  // 12.7 mm in m: a/R = sqrt(1.2e-4/12.7), with 12.7 mm sqrt(1.2e-4/0.0127).
  expect_parts(
      warnings("Radius = 1e-2", "Radius = 12.7"),
      {"Indenter / Radius = 12.7 m", "a/R is 0.0031", "0.01 to 0.5 are usual", "With 12.7 mm a/R would be 0.097"});
  EXPECT_EQ(warnings("Radius = 1e-2", "Radius = 1"), "");
  expect_parts(warnings("modulus = 1e6", "modulus = 1"), {"case.prm", "1 Pa is implausible", "in Pa?"});
  expect_parts(warnings("modulus = 1e6", "modulus = 1e12"), {"1e+12 Pa is implausible"});
  // a = sqrt(R (d0 + delta)): of a sphere it is where (a/2) ln((R+a)/(R-a)) = d, 1.3 % less at a/R = 0.283.
  expect_parts(warnings("Indentation = 1e-4", "Indentation = 7.8e-4"),
               {"a/R is 0.28", "sphere of radius 0.01 m", "smaller by 1.3 %", "Indenter / Shape = sphere"});
  EXPECT_EQ(warnings("Shape = parabola\n  set Radius = 1e-2", "Shape = sphere\n  set Radius = 1.6e-3"), "");
  EXPECT_EQ(warnings("Indentation = 1e-4", "Indentation = 5e-4"), "");
  const auto steep = warnings("Shape = parabola\n  set Radius = 1e-2", "Shape = cone\n  set Slope angle = 89.9");
  expect_parts(steep, {"Indenter / Slope angle = 89.9 deg, a slope of 5.7e+02", "between the flank and the surface"});
  EXPECT_EQ(steep.find("in m?"), std::string::npos) << "no length makes a cone steep: " << steep;
  expect_parts(warnings("Normal amplitude = 2e-5", "Normal amplitude = 1.01e-4"), {"lifts off in every cycle"});
  EXPECT_EQ(warnings("Normal amplitude = 2e-5", "Normal amplitude = 1e-4"), "");
  // Of a prescribed force the indentation is not known here.
  const std::string displacement = "Indentation = 1e-4\n  set Normal amplitude = 2e-5",
                    force = "Normal force = 1e6\n  set Normal force amplitude = 0";
  EXPECT_EQ(warnings(displacement, force), "");
}

// MPa that are read in Pa beside a branch in Pa, and a body as it should be.
TEST(Plausibility, HintsAtAModulusThatTheBodyHardlyReturnsBy) {
  expect_parts(hint_at_modulus(read_case(replace(valid_case, "modulus = 1e6", "modulus = 1"))),
               {"Elastomer / Relaxed shear modulus = 1 Pa", "beside a branch of 1e+06 Pa", "is it in Pa?"});
  EXPECT_EQ(hint_at_modulus(read_case()), "");
}

// Moduli measured from 0.1 to 10 Hz.
TEST(Plausibility, FrequenciesWithoutModuliAreWarnedAbout) {
  auto scene = read_case();
  const auto warnings = [&] {
    std::string all;
    for (const auto& warning : implausible_values(scene, profile_of(scene.indenter))) all += warning + "\n";
    return all;
  };
  scene.elastomer.master_curve = Case::MasterCurve{};
  auto& curve = *scene.elastomer.master_curve;
  curve.table = "dma.csv";
  curve.frequency = {0.1, 1, 10};
  scene.motion.normal_frequency = 10;
  scene.motion.tangential_frequency = 0.1;
  EXPECT_EQ(warnings(), "");
  scene.motion.normal_frequency = 25;
  expect_parts(warnings(), {"case.prm", "moves at 25 Hz", "dma.csv", "0.1 to 10 Hz"});
  scene.motion.normal_amplitude = 0;
  EXPECT_EQ(warnings(), "") << "nothing moves at that frequency";
  scene.motion.tangential_harmonics = {{1e-6, 0.05, 0}};
  expect_parts(warnings(), {"moves at 0.05 Hz"});
  scene.motion.path = Case::Path{};
  scene.motion.path->time = {0, 0.01};
  scene.motion.path->normal = {1e-4, 1e-4};
  scene.motion.path->tangential = {0, 0};
  scene.motion.path->repeats = true;
  expect_parts(warnings(), {"moves at 100 Hz"});
  scene.motion.path->repeats = false;
  EXPECT_EQ(warnings(), "") << "a single pass has no frequency";
}

// A parabola of 10 mm, one half of which is 3 % higher than the mean.
TEST(Plausibility, HalvesOfAScanThatDifferAreWarnedAbout) {
  const ScratchFolder folder;
  const auto warnings = [&](const char* rows) {
    folder.write("scan.csv", std::string("r,f\nmm,um\n") + rows);
    folder.write("case.prm", replace(valid_case, "parabola\n  set Radius = 1e-2", "table\n  set Table = scan.csv"));
    const auto scene = read_case_file(folder.path() / "case.prm").at(0);
    return implausible_values(scene, profile_of(scene.indenter));
  };
  const auto found = warnings("-2,204\n-1,51\n-0.5,12.75\n0,0\n0.5,12.25\n1,49\n2,196\n");
  ASSERT_EQ(found.size(), 1U);
  expect_parts(found[0], {"scan.csv: the halves of the scan differ by up to 8e-06 m, 4.0 %", "at r = 0.002 m", "mean"});
  EXPECT_TRUE(warnings("-2,200\n-1,50\n-0.5,12.5\n0,0\n0.5,12.5\n1,50\n2,200\n").empty());
}

// A parabola of 10 mm in steps of 5 um, every other height off by 0.4 um.
TEST(Plausibility, NoiseOfATableIsWarnedAbout) {
  const ScratchFolder folder;
  const auto warnings = [&](double scatter) {
    std::string rows = "r,f\nmm,um\n";
    for (int i = 0; i < 400; ++i)
      rows += fmt::format("{:.4f},{:.6f}\n", 0.005 * i, 50 * 2.5e-5 * i * i + (i % 2 == 1 ? scatter : 0));
    folder.write("scan.csv", rows);
    folder.write("case.prm", replace(valid_case, "parabola\n  set Radius = 1e-2", "table\n  set Table = scan.csv"));
    const auto scene = read_case_file(folder.path() / "case.prm").at(0);
    std::string all;
    for (const auto& warning : implausible_values(scene, any_profile_of(scene.indenter))) all += warning;
    return all;
  };
  expect_parts(warnings(0.4), {"scan.csv: ", "it looks like noise of ", "set Indenter / Table noise = "});
  EXPECT_EQ(warnings(0).find("noise"), std::string::npos);
}

// Row by row the body rests in the first one.
TEST(Plausibility, AFirstRowThatIsOffIsWarnedAbout) {
  auto scene = read_case();
  Case::Path path;
  path.file = "rows.csv";
  for (int i = 0; i < 200; ++i) {
    path.time.push_back(0.01 * i);
    path.normal.push_back(1e-4 + 2e-5 * std::sin(0.02 * i) + (i == 0 ? 5e-6 : 0));
    path.tangential.push_back(1.5e-5 * (1 - std::cos(0.03 * i)));
  }
  scene.motion.path = path;
  std::string all;
  for (const auto& warning : implausible_values(scene, profile_of(scene.indenter))) all += warning;
  expect_parts(all, {"rows.csv: d = 0.000105 m in the first row is 5e-06 m off"});
}

// At the deepest all harmonics of the normal motion are at their largest: 100 + 20 + 30 um into a parabola of 12.7 m.
TEST(Plausibility, TakesTheLargestIndentationOfAllHarmonics) {
  auto scene = read_case(replace(valid_case, "Radius = 1e-2", "Radius = 12.7"));
  scene.motion.normal_harmonics = {{3e-5, 2, 0}};
  std::string all;
  for (const auto& warning : implausible_values(scene, profile_of(scene.indenter))) all += warning;
  expect_parts(all, {"at the largest indentation, 0.00015 m"});
}

TEST(Plausibility, BranchesThatNoTestSeesRelaxAreWarnedAboutFromTheFastestToTheSlowest) {
  auto scene = read_case();
  scene.elastomer.rheology = Case::Rheology::prony;
  scene.elastomer.branch_moduli = {1e5, 1e5, 1e5, 1e5};
  scene.elastomer.branch_times = {1e11, 0.1, 1e9, 1e10};
  std::string all;
  for (const auto& warning : implausible_values(scene, profile_of(scene.indenter))) all += warning;
  expect_parts(all, {"3 of 4 branches relax more slowly", "in 1e+09 s to 1e+11 s"});
}

}  // namespace
}  // namespace fretval
