#include "comparison/verification/written_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "comparison/verification/extremes/extreme_cases.h"
#include "tests/comparison/computed_case.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/refusal.h"

namespace fretval {
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

}  // namespace
}  // namespace fretval
