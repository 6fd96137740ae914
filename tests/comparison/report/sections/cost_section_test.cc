#include <gtest/gtest.h>

#include "comparison/report/sections/sections.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/shown.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

StoredResult with_cost(double seconds, int computations) {
  auto json = stored_result();
  json["cost"]["all"] = {{"seconds", seconds},           {"time_steps", 100}, {"cycles", 10},
                         {"computations", computations}, {"bodies", 3},       {"bodies_from_store", 1}};
  return {json, {}};
}

TEST(CostSection, AddsUpWhatAllProofsTook) {
  expect_parts(rendered(cost_section({with_cost(1.5, 11), with_cost(2.25, 12)})),
               {"The proofs of all 2 cases took 23 computations", "200 time steps, 20 cycles, 3.75 s of one processor",
                "counted in each case that uses it: 4 made, 2 from the store"});
}

// Cases are computed one after the other: the memory is that of the largest.
TEST(CostSection, HasTheMemoryOfTheLargestCaseInMegabytes) {
  auto one = with_cost(1, 1), other = one;
  one.json["cost"]["peak_memory_bytes"] = 3e8;
  other.json["cost"]["peak_memory_bytes"] = 2e8;
  EXPECT_EQ(cost_section({one, other}).at("megabytes"), "300");
}

// A result of an earlier version has the chosen resolution alone: no sum is better than a wrong one.
TEST(CostSection, DoesWithoutASumWhereAResultHasNone) {
  StoredResult old{stored_result(), {}};
  old.json["cost"].erase("all");
  const auto html = rendered(cost_section({with_cost(1.5, 11), old}));
  EXPECT_EQ(html.find("of one processor"), std::string::npos);
  expect_parts(html, {"Peak memory"});
}

}  // namespace
}  // namespace fretval
