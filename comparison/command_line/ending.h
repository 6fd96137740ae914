#pragma once

#include <exception>
#include <string>

namespace fretval {

constexpr int exit_agree = 0;
constexpr int exit_disagree = 1;
constexpr int exit_bad_input = 2;
constexpr int exit_numerics_failed = 3;
constexpr int exit_system_failed = 4;
constexpr int exit_not_resolved = 5;

/// Text about the exit codes for --help and the manual page.
constexpr const char* exit_codes_text =
    "0  all that was asked for agrees, or is not proved (--proof none)\n"
    "1  finite elements and MDR disagree beyond the tolerance, or a value has moved from the baseline,\n"
    "   or MDR is off by more than trust --at-most\n"
    "2  bad input\n"
    "3  the numerics failed\n"
    "4  the system failed\n"
    "5  not resolved: nothing disagrees, but an error bar is wider than the tolerance that was asked for\n";

/// Says on the standard error why the program ends and, with several ranks, which one tells it. Returns the exit code:
/// that of bad input, of failed numerics, or of the system.
int say_failure(const std::exception_ptr& why);

/// Tells of a failure once for all ranks, and ends them all. Returns the exit code in a process that was started alone.
int end_with_failure(const std::exception_ptr& why);

/// Sets the message on the standard error for a user who ends the program with Ctrl-C, or by SIGTERM as mpirun and
/// batch systems do; after it the program ends as it would otherwise. The last call holds.
void say_on_interrupt(const std::string& message);

}  // namespace fretval
