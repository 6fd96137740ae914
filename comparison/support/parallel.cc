#include "comparison/support/parallel.h"

#include <sched.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace fretval {

std::size_t n_cores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof cores, &cores) != 0) return std::max(1U, std::thread::hardware_concurrency());
  return static_cast<std::size_t>(std::max(1, CPU_COUNT(&cores)));
}

void for_each_in_parallel(std::size_t n, const std::function<void(std::size_t)>& work, std::size_t n_threads) {
  std::mutex mutex;
  std::size_t front = 0, back = n;
  std::exception_ptr failure;
  const auto next = [&](bool from_front) -> std::optional<std::size_t> {
    const std::lock_guard<std::mutex> lock(mutex);
    if (front == back || failure) return std::nullopt;
    return from_front ? front++ : --back;
  };
  const auto worker = [&](std::size_t number) {
    while (const auto i = next(number % 2 == 0)) {
      try {
        work(*i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t number = 1; number < std::min(n, n_threads); ++number) threads.emplace_back(worker, number);
  worker(0);
  for (auto& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace fretval
