#pragma once

#include <array>
#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// Takes the body as a test of so many seconds sees it, for both methods: branches that relax more slowly than the test
/// lasts are springs of the relaxed modulus; the others are hastened and merged where that changes the complex modulus
/// by less than a tenth of the tolerance, from the frequency at which the motion repeats to 300 times its fastest one,
/// of a pass from a hundredth of one over its duration (mdr/rheology/branch_merging.h). What was taken from what stands
/// in the elastomer's test_duration.
void limit_to_test(double seconds, Case& input);

/// The case of which the test had lasted longer by a factor.
Case with_duration_times(double factor, Case input);

/// Relaxation times of branches slower than so many cycles of the motion, of a case without a duration; in s.
std::vector<double> times_slower_than(double n_cycles, const Case& input);

/// Why a periodic state under forces is out of reach of both methods, which step all cycles up to it: branches slower
/// than many_cycles, and what to set. Empty: it is not.
std::string too_slow_for_forces(const Case& input);

/// Longest period of what is prescribed, in s; a pass has its duration.
double longest_period(const Case::Motion& motion);

/// Beyond this a periodic state is none that a test reaches soon, and history by history takes too long to find.
constexpr double many_cycles = 1e4;

}  // namespace fretval
