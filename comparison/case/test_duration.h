#pragma once

#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// Takes the body as a test of so many seconds sees it, for both methods: branches that relax more slowly than the test
/// lasts are springs of the relaxed modulus; the others are hastened and merged where that changes the complex modulus
/// by less than a tenth of the tolerance, from the frequency at which the motion repeats to 300 times its fastest one,
/// for a pass from a hundredth of one over its duration (mdr/rheology/branch_merging.h). The elastomer's test_duration
/// tells what was changed.
void limit_to_test(double seconds, Case& input);

/// The case as a test that lasts `factor` times as long would see it.
Case with_duration_times(double factor, Case input);

/// Relaxation times in s of the branches that are slower than n_cycles cycles of the motion; of a case without a test
/// duration.
std::vector<double> times_slower_than(double n_cycles, const Case& input);

/// Why a periodic state under forces is out of reach of both methods, which step all cycles up to it: branches slower
/// than many_cycles, and what to set. Empty: the periodic state can be reached.
std::string too_slow_for_forces(const Case& input);

/// Cycles of creep beyond which a test does not reach the periodic state soon, and to step up to it takes too long.
constexpr double many_cycles = 1e4;

}  // namespace fretval
