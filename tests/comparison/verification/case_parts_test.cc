#include "comparison/verification/case_parts.h"

#include <gtest/gtest.h>

#include "comparison/reference/mdr_case.h"
#include "comparison/verification/extremes/extreme_cases.h"

namespace fretval {
namespace {

mdr::Profile profile_with(const Entries& indenter) {
  return profile_of(case_of(with_section(elastic_base(), indenter), "").indenter);
}

TEST(CaseParts, AreTheIndentersThatTheyName) {
  EXPECT_NEAR(mdr::shape(profile_with(parabola(2)), 0.1), 0.01 / 4, 1e-12);
  EXPECT_NEAR(mdr::shape(profile_with(cone(45)), 0.1), 0.1, 1e-12);
  EXPECT_NEAR(mdr::shape(profile_with(power(3, 1e5)), 2e-3), 8e-4, 1e-12);
  EXPECT_EQ(mdr::shape(profile_with(rounded_flat(1e-3, 1)), 0.9e-3), 0);
  EXPECT_GT(mdr::shape(profile_with(rounded_flat(1e-3, 1)), 1.1e-3), 0);
  EXPECT_NEAR(mdr::shape(profile_with(truncated_sphere(1, 3e-3)), 5e-3), (25e-6 - 9e-6) / 2, 1e-12);
}

TEST(CaseParts, HaveBranches) {
  const auto scene = case_of(with_section(elastic_base(), branches("prony", 2e6, {1e6, 6e6}, {0.1, 0.01})), "");
  EXPECT_EQ(scene.elastomer.relaxed_modulus, 2e6);
  EXPECT_EQ(scene.elastomer.branch_moduli, (std::vector<double>{1e6, 6e6}));
  EXPECT_EQ(scene.elastomer.branch_times, (std::vector<double>{0.1, 0.01}));
}

// Entries of the old section would contradict those of the new one.
TEST(CaseParts, ReplaceAWholeSectionAndNoOther) {
  const auto cones = with_section(elastic_base(), cone(5));
  EXPECT_EQ(cones.count("Indenter / Radius"), 0U);
  EXPECT_EQ(cones.at("Indenter / Shape"), "cone");
  EXPECT_EQ(with_section(cones, parabola(1e-2)), elastic_base());
}

}  // namespace
}  // namespace fretval
