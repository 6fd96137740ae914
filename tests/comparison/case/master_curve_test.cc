#include "comparison/case/master_curve.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/modulus_table.h"
#include "tests/comparison/refusal.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval {
namespace {

struct Fitted {
  Case::Elastomer elastomer;
  std::string warnings;
};

Fitted fit_of(const std::string& table, bool youngs = false) {
  const ScratchFolder folder;
  const auto file = folder.write("dma.csv", table).string();
  Fitted fitted;
  std::vector<std::string> warnings;
  fit_master_curve(file, youngs, fitted.elastomer, warnings);
  for (const auto& warning : warnings) {
    expect_parts(warning, {file + ": "});
    fitted.warnings += warning;
  }
  return fitted;
}

TEST(MasterCurve, OfAStandardSolidIsThatBody) {
  const auto [shear, warnings] = fit_of(standard_solid_table());
  EXPECT_EQ(warnings, "");
  EXPECT_NEAR(shear.relaxed_modulus / 1e6, 1, 1e-2);
  const auto& moduli = shear.branch_moduli;
  EXPECT_NEAR(std::accumulate(moduli.begin(), moduli.end(), 0.0) / 1e6, 1, 2e-2);
  EXPECT_EQ(shear.master_curve->frequency.size(), 81U);
  EXPECT_NEAR(fit_of(standard_solid_table(), true).elastomer.relaxed_modulus, shear.relaxed_modulus / 3, 1);
}

// Moduli that no body has are used all the same.
TEST(MasterCurve, WarnsAboutModuliThatContradictEachOther) {
  expect_parts(fit_of(standard_solid_table(4)).warnings, {"Kramers and Kronig", "the Prony body misses the moduli by"});
}

TEST(MasterCurve, OfFewFrequenciesIsFittedButNotHeldToItself) {
  const auto [elastomer, warnings] = fit_of(
      "f, G', tan delta\nHz, MPa, 1\n0.01, 0.62, 0.05\n0.1, 0.68, 0.07\n1, 0.77, 0.11\n10, 0.93, 0.17\n100, 1.25, "
      "0.28\n");
  expect_parts(warnings, {"Kramers and Kronig", "5 frequencies, must be at least 8"});
  EXPECT_FALSE(elastomer.master_curve->kramers_kronig);
  EXPECT_LT(elastomer.master_curve->residual, 0.1);
}

TEST(MasterCurve, RefusesATableByItsName) {
  expect_parts(refusal([] { fit_of("1,1e6,1e5\n2,1e6,1e5\n"); }), {"dma.csv: "});
}

}  // namespace
}  // namespace fretval
