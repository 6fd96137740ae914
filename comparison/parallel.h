#pragma once

#include <cstddef>
#include <functional>

namespace fretval {

/// Calls work(0..n-1) on all cores, each index once, in no particular order. The first exception ends the rest and is
/// rethrown.
void for_each_in_parallel(std::size_t n, const std::function<void(std::size_t)>& work);

}  // namespace fretval
