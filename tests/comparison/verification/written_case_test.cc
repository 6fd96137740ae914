#include "comparison/verification/written_case.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "comparison/reference/mdr_case.h"
#include "comparison/verification/suites.h"
#include "tests/comparison/computed_case.h"
#include "tests/comparison/expect_parts.h"

namespace fretval::written_case_test {
namespace {

TEST(EntryText, IsExactToTheLastBit) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, 12345678.9, std::nextafter(1.0, 2.0)})
    EXPECT_EQ(std::strtod(entry_text(value).c_str(), nullptr), value);
}

TEST(WrittenCase, IsReadWithTheChangesOfItsEntries) {
  const auto entries = with(elastic_base(), {{"Motion / Phase", "12.5"}, {"Output / Fields", "none"}});
  const auto scene = case_of(entries, "a name");
  EXPECT_EQ(scene.name, "a name");
  EXPECT_EQ(scene.motion.phase, 12.5);
  EXPECT_EQ(case_of(elastic_base(), "").motion.phase, 60);
  expect_parts(refusal([&] {
                 case_of(with(entries, {{"Motion / Phase", ""}}), "", "suite x");
               }),
               {"suite x", "Motion / Phase is missing"});
}

TEST(WrittenCase, SticksAtTheRatioThatItIsAskedFor) {
  const auto ratio = [](double asked, double factor) {
    const auto answer = exact_answer(case_of(with_stick_ratio(elastic_base(), asked, factor), ""));
    return answer.stick_radius_shakedown.value_or(0) / answer.contact_radius_max.value();
  };
  EXPECT_NEAR(ratio(0.3, 1), 0.3, 1e-9);
  EXPECT_NEAR(ratio(0, 0.999), 0, 0.05) << "at the border to where nothing sticks";
  EXPECT_EQ(ratio(0, 1.001), 0);
  expect_parts(refusal([] { with_stick_ratio(elastic_base(), 0.99); }), {"c/a = 0.99"});
}

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
}  // namespace fretval::written_case_test
