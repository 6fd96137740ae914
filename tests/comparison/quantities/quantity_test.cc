#include "comparison/quantities/quantity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

TEST(Quantity, IsFoundByTheNameInStoredResults) {
  for (const auto quantity : all_quantities) EXPECT_EQ(quantity_of(name_of(quantity)), quantity);
  EXPECT_FALSE(quantity_of("stick_radius"));
  const auto stored = stored_result();
  for (const auto& [key, unused] : stored.at("comparison").items()) EXPECT_TRUE(quantity_of(key)) << key;
}

// The table of traits is in the order of the enumeration, and so are the keys of result.json.
TEST(Quantity, HasTraitsOfItsOwn) {
  std::set<std::string> titles, labels;
  for (const auto quantity : all_quantities) {
    const auto& traits = traits_of(quantity);
    EXPECT_TRUE(titles.insert(traits.title).second) << traits.title;
    EXPECT_TRUE(labels.insert(traits.label).second) << traits.label;
    const std::string name = traits.name;
    const auto has = [&](const char* part) { return name.find(part) != std::string::npos; };
    const bool over_a = has("_radius") || has("_along") || has("_across"),
               of_the_indenter = quantity == Quantity::indentation_max || quantity == Quantity::tangential_amplitude;
    EXPECT_EQ(over_a || of_the_indenter, std::string(traits.unit) == "m");
  }
  EXPECT_STREQ(traits_of(Quantity::normal_force_max).unit, "N");
  EXPECT_STREQ(name_of(Quantity::stick_radius_first_slip), "stick_radius_first_slip");
  EXPECT_STREQ(name_of(Quantity::stick_radius_shakedown), "stick_radius_shakedown");
}

TEST(Quantity, HasAScaleInItsOwnUnit) {
  const Scales scales{2, 3, 5};
  EXPECT_EQ(scale_of(Quantity::stick_radius_shakedown, scales, -7), 2);
  EXPECT_EQ(scale_of(Quantity::tangential_force_mean, scales, -7), 3);
  EXPECT_EQ(scale_of(Quantity::friction_work, scales, -7), 5);
  EXPECT_EQ(scale_of(Quantity::tangential_force_max, scales, -7), 7);
  EXPECT_EQ(scale_of(Quantity::limiting_amplitude, scales, -7), 1) << "it is a ratio";
  EXPECT_EQ(scale_of(Quantity::contact_radius_max, {0, 3, 5}, -7), 7) << "without a radius that is known";
}

// Against the sliding force; of what is compared relatively nothing is roundoff.
TEST(Quantity, IsShownWithoutRoundoff) {
  const Scales scales{2, 3, 5};
  EXPECT_EQ(without_roundoff(Quantity::tangential_force_mean, scales, -2e-12), 0);
  EXPECT_EQ(without_roundoff(Quantity::tangential_force_mean, scales, -4e-12), -4e-12);
  EXPECT_EQ(without_roundoff(Quantity::tangential_force_max, scales, 1e-30), 1e-30);
}

TEST(Quantity, IsListedOnceInEitherOrder) {
  const auto by_name = [](Quantity a, Quantity b) { return std::string(name_of(a)) < name_of(b); };
  EXPECT_TRUE(std::is_sorted(all_quantities.begin(), all_quantities.end(), by_name));
  auto sorted = quantities_by_interest;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, all_quantities);
  EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
}

}  // namespace
}  // namespace fretval
