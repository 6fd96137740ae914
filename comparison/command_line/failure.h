#pragma once

#include <exception>

namespace fretval {

/// Says on the standard error why the program ends and, with several ranks, which one tells it. Returns the exit code:
/// that of bad input, of failed numerics, or of the system.
int say_failure(const std::exception_ptr& why);

/// Tells of a failure once for all ranks, and ends them all. Returns the exit code in a process that was started alone.
int end_with_failure(const std::exception_ptr& why);

}  // namespace fretval
