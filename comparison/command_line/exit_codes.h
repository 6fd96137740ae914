#pragma once

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

}  // namespace fretval
