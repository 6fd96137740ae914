#include "comparison/verification/random_cases/memory_watch.h"

#include <gtest/gtest.h>

#include "comparison/support/resident_memory.h"

namespace fretval {
namespace {

std::vector<MemorySample> samples(double per_case, double peak) {
  std::vector<MemorySample> all;
  for (std::size_t k = 1; k <= 100; ++k) all.push_back({100 * k, 2e8 + per_case * 100 * static_cast<double>(k)});
  all.front().bytes = 1e8;  // not everything is there yet
  all.back().bytes += peak;
  return all;
}

TEST(MemoryCheck, SeesALeakAndNoSinglePeak) {
  EXPECT_EQ(memory_check(samples(0, 1e8)).failure, "");
  EXPECT_EQ(memory_check(samples(3e3, 0)).failure, "");
  const auto leak = memory_check(samples(10e3, 0));
  EXPECT_EQ(leak.failure, "it grows");
  EXPECT_NE(leak.finding.find(", 10000 bytes per case"), std::string::npos) << leak.finding;
}

TEST(MemoryCheck, SaysThatFewSamplesTellNothing) {
  const auto few = memory_check({{100, 1e8}, {200, 2e8}});
  EXPECT_EQ(few.failure, "");
  EXPECT_EQ(few.finding, "too few cases to judge");
}

// The memory of the process is what the growth is made of: a leak of this test's own must be seen.
TEST(MemoryCheck, SeesWhatTheProcessHolds) {
  if (!resident_bytes()) GTEST_SKIP() << "the system does not tell";
  std::vector<MemorySample> seen;
  std::vector<std::vector<double>> leaked;
  for (std::size_t k = 1; k <= 16; ++k) {
    leaked.emplace_back(500000, 1.0);  // 4 MB
    seen.push_back({k, resident_bytes().value()});
  }
  EXPECT_EQ(memory_check(seen).failure, "it grows");
}

}  // namespace
}  // namespace fretval
