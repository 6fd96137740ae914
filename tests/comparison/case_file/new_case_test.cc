#include "comparison/case_file/new_case.h"

#include <gtest/gtest.h>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/case_file/case_file.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::new_case_test {
namespace {

PreparedCase prepared_new(const NewCase& choice) {
  const ScratchFolder folder;
  for (const auto& [name, text] : new_case_files("mine", choice)) folder.write(name, text);
  return prepare(read_case_file(folder.path() / "mine.prm")).front();
}

TEST(NewCase, EveryShapeIsAValidCaseWithoutAWarning) {
  for (const auto& shape : new_case_shapes()) {
    const auto prepared = prepared_new({shape, "standard solid"});
    EXPECT_EQ(Case::shape_names.at(static_cast<std::size_t>(prepared.input.indenter.shape)), shape);
    EXPECT_TRUE(prepared.input.warnings.empty()) << shape << ": " << prepared.input.warnings.front();
  }
}

TEST(NewCase, EveryRheologyIsAValidCaseWithoutAWarning) {
  for (const auto& rheology : new_case_rheologies()) {
    const auto prepared = prepared_new({"parabola", rheology});
    EXPECT_EQ(prepared.input.elastomer.rheology_name(), rheology);
    EXPECT_TRUE(prepared.input.warnings.empty()) << rheology << ": " << prepared.input.warnings.front();
  }
}

// The largest contact of the parabola: a² = R (d0 + delta).
TEST(NewCase, MeansWhatItSays) {
  EXPECT_NEAR(prepared_new({}).fem.units.length, std::sqrt(1e-2 * 1.2e-4), 1e-12);
  // a = R tanh(u) with u tanh(u) = d/R = 0.012: a/a_parabola = 1 - (a/R)²/6 + ...
  EXPECT_NEAR(prepared_new({"sphere", "elastic"}).fem.units.length / std::sqrt(1e-2 * 1.2e-4), 1 - 0.012 / 6, 1e-5);
  EXPECT_NEAR(prepared_new({"table", "elastic"}).fem.units.length, std::sqrt(1e-2 * 1.2e-4), 1e-7);
}

TEST(NewCase, ExplainsItsEntriesAndUnits) {
  expect_parts(
      new_case_files("mine", {}).at("mine.prm"),
      {"  set Radius = 10 mm ", "# of curvature", "set Normal frequency = 1 Hz", "#   set Values = 0 : 15 : 180 deg"});
}

TEST(NewCase, RefusesWhatThereIsNot) {
  expect_parts(refusal([] { new_case_files("mine", {"spere", "elastic"}); }), {"--shape spere", "truncated sphere"});
  expect_parts(refusal([] {
                 new_case_files("mine", {"cone", "elastc"});
               }),
               {"--rheology elastc", "did you mean elastic?"});
}

// At 1 Hz omega tau is 0.2 pi: G' = 1 + 0.3948/1.3948 and G'' = 0.6283/1.3948 MPa.
TEST(NewCase, HasAModulusTableOfTheStandardSolid) {
  expect_parts(new_case_files("mine", {"parabola", "table"}).at("mine-moduli.csv"),
               {"f,G',G''\nHz,MPa,MPa\n", "\n1,1.28304", ",0.450477"});
}

}  // namespace
}  // namespace fretval::new_case_test
