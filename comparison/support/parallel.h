#pragma once

#include <cstddef>
#include <functional>

namespace fretval {

/// Cores that this process may run on, at least one: those of the machine, or what a launcher or taskset leaves it.
std::size_t n_cores();

/// Calls work(0..n-1) on n_threads threads, each index once. They work from both ends towards the middle: neighbours
/// often share something that is made once, and would wait for each other. The first exception ends the rest and is
/// rethrown.
void for_each_in_parallel(std::size_t n, const std::function<void(std::size_t)>& work,
                          std::size_t n_threads = n_cores());

}  // namespace fretval
