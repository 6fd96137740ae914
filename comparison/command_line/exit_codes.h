#pragma once

namespace fretval {

constexpr int exit_agree = 0;
constexpr int exit_disagree = 1;
constexpr int exit_bad_input = 2;
constexpr int exit_numerics_failed = 3;
constexpr int exit_system_failed = 4;

}  // namespace fretval
