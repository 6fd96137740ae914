#include "comparison/support/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace fretval {
namespace {

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
