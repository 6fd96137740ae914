#include "comparison/support/resident_memory.h"

#include <gtest/gtest.h>

#include <vector>

namespace fretval {
namespace {

constexpr std::size_t n_megabytes = 32;

/// Memory that is resident because it was written to.
std::vector<char> touched_memory() {
  return std::vector<char>(n_megabytes << 20U, 1);
}

TEST(ResidentMemory, GrowsAndFallsWithWhatIsHeld) {
  if (!resident_bytes()) GTEST_SKIP() << "the system does not tell";
  const double before = resident_bytes().value();
  double held = 0;
  {
    const auto memory = touched_memory();
    held = resident_bytes().value() + (memory.back() - 1);
  }
  constexpr double most = 0.9e6 * n_megabytes;
  EXPECT_GT(held - before, most);
  EXPECT_LT(resident_bytes().value(), held - most);
}

TEST(ResidentMemory, RemembersAPeakThatIsOver) {
  const ResidentGrowth growth;
  if (!growth.peak_bytes()) GTEST_SKIP() << "the system does not tell";
  EXPECT_LT(growth.peak_bytes().value(), 0.5e6 * n_megabytes);
  EXPECT_EQ(touched_memory().back(), 1);
  EXPECT_GT(growth.peak_bytes().value(), 0.9e6 * n_megabytes);
  const ResidentGrowth later;
  EXPECT_LT(later.peak_bytes().value(), 0.5e6 * n_megabytes);
}

}  // namespace
}  // namespace fretval
