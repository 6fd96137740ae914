#include "comparison/results/data_text.h"

#include <gtest/gtest.h>

#include "comparison/case/test_duration.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

TEST(DataText, OfDataThatAreTakenAsTheyAreIsNone) {
  EXPECT_EQ(data_text(read_case()), "");
  EXPECT_EQ(duration_text(read_case()), "");
}

// The branch of the valid case relaxes in 0.1 s: a spring of 1 MPa more for a shorter test.
TEST(DataText, SaysWhatALongerTestWouldChange) {
  auto input = read_case();
  limit_to_test(0.05, input);
  expect_parts(data_text(input),
               {"test         50 ms: 1 of 1 branches are slower", "G = 2 MPa instead of G'(0) = 1 MPa",
                "near it: 100 ms", "three times longer: stick radius", "three times shorter: ", "by +0 %"});
  expect_parts(duration_text(input), {"case: test of 50 ms", "a test three times longer would change"});
}

// The branch of 0.1 s is a spring in a test of 50 ms, as in a shorter one; in a test of 150 ms it relaxes.
TEST(DataText, TellsALongerTestFromAShorterOne) {
  auto input = read_case();
  limit_to_test(0.05, input);
  const auto changes_in = [](const std::string& text, const std::string& head, char end) {
    const auto begin = text.find(head) + head.size();
    return text.substr(begin, text.find(end, begin) - begin);
  };
  const auto text = data_text(input), line = duration_text(input);
  for (const auto& longer :
       {changes_in(text, "three times longer: ", '\n'), changes_in(line, "three times longer would change ", ';')})
    EXPECT_NE(longer.find_first_of("123456789"), std::string::npos) << longer;
  for (const auto& shorter :
       {changes_in(text, "three times shorter: ", '\n'), changes_in(line, "one three times shorter ", '\n')})
    EXPECT_EQ(shorter.find_first_of("123456789"), std::string::npos) << shorter;
}

// A fifth of the modulus is a fifth of the force, and of no radius under prescribed displacements.
TEST(DataText, SaysWhatTheyLeaveOpenOfWhatIsAskedForAlone) {
  auto input = read_case(elastic_case());
  input.elastomer.modulus_scatter = 0.2;
  EXPECT_EQ(data_text(input), "  they leave   open largest normal force by 2.0e-01, over the scale of each\n");
}

TEST(DataText, SaysHowManyBranchesAreMerged) {
  auto input = read_case();
  input.elastomer.test_duration = Case::TestDuration{90, 2e5, {1e6, 1e6, 1e6, 1e6}, {1, 2, 3, 4}, 0, 1, 3, {}, 4e-5};
  expect_parts(data_text(input),
               {"test         90 s: 1 of 4 branches are slower and count as springs, G = 1 MPa instead "
                "of G'(0) = 200 kPa; 3 others are merged, which changes the complex modulus by 4.0e-05 "
                "at most\n",
                "no branch relaxes in a third to three times of it"});
  input.elastomer.test_duration->n_fast = 0;
  EXPECT_EQ(data_text(input).find("merged"), std::string::npos);
}

TEST(DataText, SaysWhatTheyLeaveOpen) {
  auto input = read_case(elastic_case());
  input.elastomer.modulus_scatter = 0.2;
  input.notes = {"case.prm: something was made of it"};
  expect_parts(data_text(input), {"data         case.prm: something was made of it", "they leave   open ", "force"});
}

}  // namespace
}  // namespace fretval
