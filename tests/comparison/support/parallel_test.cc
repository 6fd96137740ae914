#include "comparison/support/parallel.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace fretval {
namespace {

// taskset, a launcher of ranks or a batch system may leave less than the machine has.
TEST(Cores, AreThoseThatTheProcessMayRunOn) {
  cpu_set_t all, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  EXPECT_EQ(n_cores(), static_cast<std::size_t>(CPU_COUNT(&all)));
  CPU_ZERO(&one);
  for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++core)
    if (CPU_ISSET(core, &all)) CPU_SET(core, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(n_cores(), 1U);
  sched_setaffinity(0, sizeof all, &all);
}

TEST(ForEachInParallel, CallsEachIndexOnce) {
  for (const std::size_t n : {0, 1, 2, 1000}) {
    std::vector<int> calls(n);  // each index has its own: no thread writes where another does
    for_each_in_parallel(n, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(n, 1));
  }
}

TEST(ForEachInParallel, AnExceptionEndsTheRestAndIsRethrown) {
  std::atomic<int> calls{0};
  const auto work = [&](std::size_t i) {
    ++calls;
    if (i == 0) throw std::invalid_argument("the first");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  EXPECT_THROW(for_each_in_parallel(10000, work), std::invalid_argument);
  EXPECT_LT(calls, 10000);
}

TEST(ForEachInParallel, OfSeveralExceptionsOneIsRethrown) {
  EXPECT_THROW(for_each_in_parallel(100, [](std::size_t) { throw std::out_of_range("all"); }), std::out_of_range);
}

}  // namespace
}  // namespace fretval
