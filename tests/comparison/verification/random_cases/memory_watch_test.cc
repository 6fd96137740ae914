#include "comparison/verification/random_cases/memory_watch.h"

#include <gtest/gtest.h>

#include "comparison/support/resident_memory.h"

namespace fretval {
namespace {

TEST(MemoryGrowth, SeesALeakAndNoSinglePeak) {
  const auto samples = [](double per_case, double peak) {
    std::vector<MemorySample> all;
    for (std::size_t k = 1; k <= 100; ++k) all.push_back({100 * k, 2e8 + per_case * 100 * static_cast<double>(k)});
    all.front().bytes = 1e8;  // not everything is there yet
    all.back().bytes += peak;
    return all;
  };
  EXPECT_TRUE(memory_growth(samples(0, 1e8))->is_flat());
  const auto leak = memory_growth(samples(10e3, 0)).value();
  EXPECT_FALSE(leak.is_flat());
  EXPECT_NEAR(leak.bytes_per_case(), 10e3, 300);
  EXPECT_FALSE(memory_growth({{100, 1e8}, {200, 2e8}}));
}

// The memory of the process is what the growth is made of: a leak of this test's own must be seen.
TEST(MemoryGrowth, SeesWhatTheProcessHolds) {
  const auto before = resident_bytes();
  if (!before) GTEST_SKIP() << "the system does not tell";
  std::vector<MemorySample> samples;
  std::vector<std::vector<double>> leaked;
  for (std::size_t k = 1; k <= 16; ++k) {
    leaked.emplace_back(500000, 1.0);  // 4 MB
    samples.push_back({k, resident_bytes().value()});
  }
  EXPECT_FALSE(memory_growth(samples)->is_flat());
}

TEST(MemoryCheck, FailsOnlyWhereItGrows) {
  EXPECT_EQ(memory_check({{100, 1e8}, {200, 2e8}}).failure, "");
  EXPECT_EQ(memory_check({{100, 1e8}, {200, 2e8}}).finding, "too few cases to judge");
  std::vector<MemorySample> flat(8, {100, 1e8}), growing;
  for (std::size_t k = 0; k < 8; ++k) growing.push_back({100 * k, 1e8 + 1e7 * static_cast<double>(k)});
  EXPECT_EQ(memory_check(flat).failure, "");
  EXPECT_EQ(memory_check(growing).failure, "it grows");
}

}  // namespace
}  // namespace fretval
