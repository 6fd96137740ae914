#include "comparison/run/explanation.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "comparison/case_file/case_file.h"
#include "comparison/data/path_table.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/modulus_table.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::explanation_test {
namespace {

// a = sqrt(R (d0 + delta)), a/R; omega tau = 2 pi 0.1; rho² = (1 + 2 x²)²+... of the standard solid, docs/theory.md.
TEST(Explanation, NamesInputsGroupsRadiiAndWork) {
  expect_parts(explanation(read_case()),
               {"case\n", "parabola, R = 10 mm", "standard solid, G'(0) = 1 MPa, 1 MPa with 100 ms; incompressible",
                "mu = 0.5", "100 µm ± 20 µm at 1 Hz", "15 µm at 1 Hz, phase 60 deg", "omega tau    0.628",
                "0.2 of the indentation", "0.3 of mu times", "1.09545 mm, largest contact radius", "a/R          0.11",
                "partial slip", "first slip   c = 727.284 µm", "shakedown    c = 792.773 µm",
                "24 rings under the contact", "to prove a tolerance of 0.01"});
}

TEST(Explanation, SaysWhichRadiiThereAreNot) {
  const auto none =
      explanation(read_case(replace(valid_case, "Tangential amplitude = 1.5e-5", "Tangential amplitude = 1")));
  expect_parts(none, {"no zone sticks for good", "first slip   none", "shakedown    none"});
}

TEST(Explanation, OfAPassOfForcesSaysWhenItSlides) {
  auto input = read_case(elastic_case());
  input.motion = motion_along({{{0, 1}, {0.5, 0.3}, {0, 0.2}, false, true, true}, "rows.csv"});
  expect_parts(explanation(input), {"rows.csv: 2 rows in 1 s, passed once", "normal       300 mN to 500 mN",
                                    "tangential   0 N to 200 mN", "gross slip: the whole contact slides from t = 833"});
}

TEST(Explanation, SaysWhyFiniteElementsDoNotComputeIt) {
  const auto far = replace(valid_case, "Tangential frequency = 1", "Tangential frequency = 5000");
  expect_parts(explanation(read_case(far)), {"elements     none: ", "more than a factor of 1000 apart"});
  Case without = read_case();
  without.tolerance = 0;
  expect_parts(explanation(without), {"need an Accuracy / Tolerance"});
}

// k = 1.5 mu Dd / u_x0 = 1.5 * 0.5 * 20 / 15.
TEST(Explanation, HasTheGroupOfThePaper) {
  expect_parts(explanation(read_case()), {"k            1 (3/2 mu"});
  expect_parts(explanation(read_case(replace(valid_case, "Normal amplitude = 2e-5", "Normal amplitude = 1e-5"))),
               {"k            0.5 (3/2 mu"});
}

// Nothing sticks: rings are refined around a zone that is not there, dozens of times.
TEST(Explanation, TellsNoTimeWhereAZoneIsLookedFor) {
  const auto none = explanation(read_case(replace(valid_case, "amplitude = 1.5e-5", "amplitude = 1")));
  expect_parts(none, {"minutes, which nobody can tell beforehand"});
  EXPECT_EQ(none.find("of the order of"), std::string::npos);
  const auto vector = explanation(read_case(valid_case + "subsection Contact\n  set Friction = vector\nend\n"));
  expect_parts(vector, {"as friction is a vector: minutes"});
}

TEST(Explanation, OfASweepAndOfWearSaysWhatAllOfItCosts) {
  const auto one = explanation(read_case()), ten = explanation(read_case(), std::vector<Case>(10, read_case()));
  EXPECT_EQ(one.find("of the sweep"), std::string::npos);
  expect_parts(ten, {"all 10 cases of the sweep, on "});
  const auto worn = explanation(read_case(elastic_case() + "subsection Wear\n  set Coefficient = 1e-12\nend\n"));
  expect_parts(worn, {"most of it for the wear"});
  EXPECT_EQ(one.find("wear,"), std::string::npos);
}

// What forces are answered for is another contact than the one that a run begins with.
TEST(Explanation, OfForcesNamesTheWornContact) {
  const auto forces = replace(replace(valid_case, "Indentation = 1e-4", "Normal force = 0.5"),
                              "Normal amplitude = 2e-5", "Normal force amplitude = 0.1");
  const auto text = explanation(read_case(forces));
  expect_parts(text,
               {", contact radius where wear ends\n", "radii under forces are those of the contact where wear ends"});
  EXPECT_EQ(text.find("largest contact radius"), std::string::npos) << text;
  EXPECT_EQ(explanation(read_case()).find("where wear ends"), std::string::npos);
}

/// The time that a line ends with, after some words.
double seconds_after(const std::string& text, const std::string& words) {
  const auto line = text.substr(text.find(words));
  const std::string before = "of the order of ";
  std::istringstream time(line.substr(line.find(before) + before.size()));
  double value = 0;
  std::string unit;
  time >> value >> unit;
  return value * std::map<std::string, double>{{"s", 1}, {"min", 60}, {"h", 3600}}.at(unit);
}

// a is that of a half-space, 1.09545 mm: over 4 mm and 8 mm. At nu = 0.3 springs along the surface are 1.7/1.4 times
// softer than those across it, and k = 1.214 mu 20/15.
TEST(Explanation, OfACylinderSaysHowThickItIsForItsContact) {
  auto input = read_case();
  input.tolerance = 0;
  input.body = {Case::Body::Shape::cylinder, 4e-3, 8e-3, true};
  input.elastomer.poisson_ratio = 0.3;
  expect_parts(explanation(input), {"a cylinder 4 mm thick of radius 8 mm, bonded to its base\n", "; nu = 0.3\n",
                                    "a/H          0.274; a half-space would do within 1 % of a from ",
                                    "a/B          0.137, over the radius\n", "k            0.8095 (1.214 mu times"});
  input.body.is_bonded = false;
  expect_parts(explanation(input), {"of radius 8 mm, on a frictionless base\n"});
}

TEST(Explanation, OfManyBranchesNamesFour) {
  auto input = read_case();
  input.tolerance = 0;
  input.elastomer.rheology = Case::Rheology::prony;
  input.elastomer.branch_moduli.assign(5, 1e5);
  input.elastomer.branch_times = {0.1, 0.2, 0.5, 1, 2};
  expect_parts(explanation(input),
               {"100 kPa with 1 s and 1 more branch; incompressible\n", "omega tau    0.628 to 12.6\n"});
  input.elastomer.branch_moduli.push_back(1e5);
  input.elastomer.branch_times.push_back(5);
  expect_parts(explanation(input), {"100 kPa with 1 s and 2 more branches; incompressible\n", "0.628 to 31.4\n"});
}

// At a constant depth all within sqrt(R (d - 2 u/(3 mu))) never slips: there is such a zone up to 3/2 mu d = 75 um.
TEST(Explanation, OfAPassSaysWhetherAZoneNeverSlips) {
  auto input = read_case(elastic_case());
  input.tolerance = 0;
  input.motion = motion_along({{{0, 1}, {1e-4, 1e-4}, {0, 2.7e-5}, false}, "rows.csv"});
  expect_parts(explanation(input), {"normal       100 µm to 100 µm\n", "tangential   0 m to 27 µm\n",
                                    "regime       partial slip: a zone never slips\n",
                                    "first slip   c = 800 µm, never slips since rest\n", "shakedown    none: "});
  input.motion = motion_along({{{0, 1}, {1e-4, 1e-4}, {0, 8e-5}, false}, "rows.csv"});
  expect_parts(explanation(input), {"regime       all of the contact slips in the pass\n", "first slip   none\n"});
}

// All cases, not those that are looked at: a hundred times as many take some hundred times as long.
TEST(Explanation, TimeOfASweepGrowsWithItsCases) {
  const auto seconds = [](std::size_t n) {
    return seconds_after(explanation(read_case(), std::vector<Case>(n, read_case())), "of the sweep, on ");
  };
  EXPECT_GT(seconds(4000), 30 * seconds(40));
}

// At 0.4 Hz tan delta of the standard solid, 1 MPa and 1 MPa with 0.1 s, is 0.24: what relaxes below is not measured.
TEST(Explanation, GivesAnExtrapolatedModulusARange) {
  const ScratchFolder folder;
  std::istringstream rows(standard_solid_table());
  std::string table;
  for (std::string row; std::getline(rows, row);)
    if (const double f = std::atof(row.c_str()); f == 0 || f > 0.35) table += row + "\n";
  folder.write("dma.csv", table);
  const auto text =
      replace(replace(valid_case, "standard solid", "table\n  set Table = dma.csv\n  set Table modulus = shear"),
              "  set Relaxed shear modulus = 1e6\n  set Branch moduli = 1e6\n  set Branch times = 0.1\n", "");
  const auto input = read_case_file(folder.write("case.prm", text)).at(0);
  expect_parts(explanation(input), {"G'(0) = 1 MPa, extrapolated: 0.15 to 1.1, "});
  std::string warnings;
  for (const auto& warning : input.warnings) warnings += warning;
  expect_parts(warnings, {"tan delta is still 0.2", "G'(0) is extrapolated, to "});
}

}  // namespace
}  // namespace fretval::explanation_test
