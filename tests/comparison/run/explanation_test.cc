#include "comparison/run/explanation.h"

#include <gtest/gtest.h>

#include "comparison/data/path_table.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

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
  input.motion = motion_along({"rows.csv", {0, 1}, {0.5, 0.3}, {0, 0.2}, false, true, true});
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
}

TEST(Explanation, OfASweepAndOfWearSaysWhatAllOfItCosts) {
  const auto one = explanation(read_case()), ten = explanation(read_case(), std::vector<Case>(10, read_case()));
  EXPECT_EQ(one.find("of the sweep"), std::string::npos);
  expect_parts(ten, {"all 10 cases of the sweep, on "});
  const auto worn = explanation(read_case(elastic_case() + "subsection Wear\n  set Coefficient = 1e-12\nend\n"));
  expect_parts(worn, {"most of it for the wear"});
  EXPECT_EQ(one.find("wear,"), std::string::npos);
}

}  // namespace
}  // namespace fretval::explanation_test
