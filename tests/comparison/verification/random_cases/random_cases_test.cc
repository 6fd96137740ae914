#include "comparison/verification/random_cases/random_cases.h"

#include <gtest/gtest.h>

#include <set>

#include "comparison/accuracy/prepared_case.h"
#include "tests/comparison/refusal.h"

namespace fretval {
namespace {

TEST(RandomCases, AreReproducibleAndVaried) {
  std::set<std::string> shapes, rheologies;
  int n_worn = 0, n_free = 0, n_at_rest = 0;
  for (std::size_t k = 0; k < 300; ++k) {
    const auto entries = random_entries({1, k});
    if (k < 20) {
      EXPECT_EQ(entries, random_entries({1, k}));
    }
    shapes.insert(entries.at("Indenter / Shape"));
    rheologies.insert(entries.at("Elastomer / Rheology"));
    n_worn += entries.count("Wear / State") > 0 ? 1 : 0;
    n_free += entries.at("Motion / Phase") == "free" ? 1 : 0;
    n_at_rest += entries.at("Motion / Tangential amplitude") == "0" ? 1 : 0;
  }
  EXPECT_EQ(shapes.size(), 5U);
  EXPECT_EQ(rheologies.size(), 5U);
  EXPECT_GT(n_worn, 0);
  EXPECT_GT(n_free, 0);
  EXPECT_GT(n_at_rest, 0);
  EXPECT_NE(random_entries({1, 0}), random_entries({2, 0}));
  EXPECT_NE(random_entries({1, 0}), random_entries({1, 0, 1}));
}

// Each one that the tool refuses as bad input is drawn again, and is a case that nobody looks at.
TEST(RandomCases, AreHardlyEverRefused) {
  int n_refused = 0;
  for (std::size_t k = 0; k < 200; ++k)
    n_refused += refusal([&] { prepare({case_of(random_entries({1, k}), "case")}); }) == "no error" ? 0 : 1;
  EXPECT_LE(n_refused, 2);
}

}  // namespace
}  // namespace fretval
